// Claim. Flips lead from sphere to sphere and back and are all there are; the lists hold each class
// once; the balls are the spheres less a vertex. Oracle. A slow judge of manifolds; flips by their
// definition; all labelled manifolds on up to seven vertices by covering triangles, with no flips
// and no symmetry; the literature (see spheres.hpp).
#include "enum/balls/spheres.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <set>
#include <vector>

#include "enum/canon/nauty/triangulation_form.hpp"
#include "enum/core/errors.hpp"
#include "tests/enum/balls/sphere_laws.hpp"

namespace {

using namespace hexatlas;
using complex::Triangulation;
using complex::VertexSet;

/// The results of all bistellar flips that keep the vertices, by the definition, set by set.
std::set<Triangulation> flips_by_definition(const Triangulation& sphere) {
  const auto is_face = [&](unsigned set) {
    return std::any_of(sphere.tetrahedra.begin(), sphere.tetrahedra.end(),
                       [&](VertexSet t) { return (t & set) == set; });
  };
  std::set<Triangulation> result;
  for (unsigned both = 0; both < 1U << static_cast<unsigned>(sphere.vertices); ++both) {
    if (std::popcount(both) != 5) continue;
    for (unsigned a = both; a != 0; a = (a - 1) & both) {
      const unsigned b = both ^ a;
      if (std::popcount(a) < 2 || std::popcount(a) > 3 || is_face(b)) continue;
      // The tetrahedra at A have to be A with all facets of B, and no others.
      std::set<VertexSet> at_a;
      for (const VertexSet t : sphere.tetrahedra)
        if ((t & a) == a) at_a.insert(t);
      std::set<VertexSet> wanted;
      std::set<VertexSet> after(sphere.tetrahedra.begin(), sphere.tetrahedra.end());
      for (unsigned bit = 1; bit <= both; bit <<= 1U) {
        if ((bit & b) != 0) wanted.insert(static_cast<VertexSet>(both ^ bit));
        if ((bit & a) != 0) after.insert(static_cast<VertexSet>(both ^ bit));
      }
      if (at_a != wanted) continue;
      for (const VertexSet t : wanted) after.erase(t);
      result.insert({sphere.vertices, {after.begin(), after.end()}});
    }
  }
  return result;
}

TEST(Spheres, FlipsAreThoseOfTheDefinitionAndCanBeUndone) {
  for (int vertices = 5; vertices <= 8; ++vertices)
    for (const auto& sphere : balls::spheres(vertices).found) {
      const auto list = balls::flipped(sphere);
      const std::set<Triangulation> flips(list.begin(), list.end());
      EXPECT_EQ(flips.size(), list.size());
      EXPECT_EQ(flips, flips_by_definition(sphere));
      for (const auto& other : list) {
        EXPECT_TRUE(oracle::is_closed_manifold(support::tetrahedra_of(other)));
        const auto back = balls::flipped(other);
        EXPECT_EQ(std::count(back.begin(), back.end(), sphere), 1);
      }
    }
}

TEST(Spheres, SubdivisionsAreSpheresWithOneMoreVertex) {
  for (const auto& sphere : balls::spheres(7).found) {
    const auto list = balls::subdivided(sphere);
    EXPECT_EQ(list.size(), sphere.tetrahedra.size());
    for (const auto& finer : list) {
      EXPECT_EQ(finer.vertices, 8);
      EXPECT_EQ(finer.tetrahedra.size(), sphere.tetrahedra.size() + 3);
      EXPECT_EQ(oracle::vertex_set(support::tetrahedra_of(finer)).size(), 8U);
      EXPECT_TRUE(oracle::is_closed_manifold(support::tetrahedra_of(finer)));
    }
  }
}

TEST(Spheres, AreAllClosedManifoldsWithUpToSevenVertices) {
  for (int vertices = 5; vertices <= 7; ++vertices) support::expect_all_manifolds(vertices);
}

TEST(Spheres, NumbersOfTheLiterature) {
  balls::Spheres list = balls::spheres(5);
  for (const std::size_t count : {1U, 2U, 5U, 39U, 1296U}) {
    EXPECT_EQ(list.found.size(), count) << list.vertices;
    support::expect_distinct_and_sorted(list);
    if (list.vertices < 9) list = balls::next_spheres(list);
  }
  std::vector<std::size_t> histogram(28);
  for (const auto& sphere : list.found) ++histogram.at(sphere.tetrahedra.size());
  EXPECT_EQ(std::vector<std::size_t>(histogram.begin() + 17, histogram.end()),
            (std::vector<std::size_t>{7, 23, 45, 84, 128, 175, 223, 231, 209, 121, 50}));
  for (const auto& sphere : list.found)
    EXPECT_TRUE(oracle::is_closed_manifold(support::tetrahedra_of(sphere)));
}

TEST(Spheres, OutOfRangeIsRefused) {
  EXPECT_THROW((void)balls::spheres(4), core::PreconditionViolated);
  EXPECT_THROW((void)balls::spheres(11), core::PreconditionViolated);
}

TEST(Balls, NumbersAndGroups) {
  const std::map<int, std::size_t> known{{4, 1}, {5, 3}, {6, 12}, {7, 167}};
  for (const auto& [vertices, count] : known) {
    const auto spheres = balls::spheres(vertices + 1);
    const auto list = balls::balls(spheres);
    EXPECT_EQ(list.size(), count);
    // Labelled spheres with a marked vertex, counted with the groups of the one and the other.
    std::uint64_t factorial = 1;
    for (int i = 2; i <= vertices + 1; ++i) factorial *= static_cast<std::uint64_t>(i);
    std::uint64_t marked = 0;
    for (const auto& sphere : spheres.found)
      marked += factorial / canon::triangulation_form(sphere).automorphisms *
                static_cast<std::uint64_t>(vertices + 1);
    std::set<Triangulation> different;
    for (const auto& ball : list) {
      marked -= factorial * static_cast<std::uint64_t>(vertices + 1) /
                (ball.automorphisms * static_cast<std::uint64_t>(vertices + 1));
      different.insert(ball.triangulation);
      EXPECT_EQ(complex::search_shelling(ball.triangulation).outcome,
                complex::ShellingSearch::found);
      EXPECT_EQ(complex::boundary_triangles(ball.triangulation).size(),
                static_cast<std::size_t>(2 * ball.boundary_vertices - 4));
    }
    EXPECT_EQ(marked, 0U);
    EXPECT_EQ(different.size(), list.size());
  }
}

TEST(Balls, PuncturedSphereHasTheLinkAsItsBoundary) {
  for (const auto& sphere : balls::spheres(8).found)
    for (int v = 0; v < sphere.vertices; ++v) {
      const auto rest = balls::punctured(sphere, v);
      std::set<VertexSet> link;
      for (const VertexSet t : sphere.tetrahedra)
        if ((t & complex::bit_of(v)) != 0)
          link.insert(
              complex::image_of(static_cast<VertexSet>(t ^ complex::bit_of(v)), rest.labels));
      const auto boundary = complex::boundary_triangles(rest.ball);
      EXPECT_EQ(std::set<VertexSet>(boundary.begin(), boundary.end()), link);
      unsigned used = 0;
      for (const VertexSet triangle : boundary) used |= triangle;
      EXPECT_EQ(used, (1U << static_cast<unsigned>(rest.boundary_vertices)) - 1U);
    }
}

}  // namespace
