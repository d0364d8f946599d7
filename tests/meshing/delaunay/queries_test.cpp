// Claim. Places are located, stars are complete, points inserted later change the triangulation to
// that of all points, refinement ends when it should.
// Oracle. All tetrahedra, with exact signs; triangulations made from scratch.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "meshing/delaunay/triangulation.hpp"
#include "realize/exact/orientation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/laws.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Triangulation;
using Tetrahedron = Triangulation::Tetrahedron;
using Index = Triangulation::Index;
using exact::Sign;

Sign side(const Cloud& points, const Tetrahedron& t, unsigned vertex, const mesh::Point& place) {
  std::array<exact::Point3, 4> corners{};
  for (unsigned i = 0; i < 4; ++i) {
    const mesh::Point& p = i == vertex ? place : points[t[i]];
    corners[i] = {p.x, p.y, p.z};
  }
  return exact::sign_of_orientation(corners[0], corners[1], corners[2], corners[3]);
}

bool contains(const Cloud& points, const Tetrahedron& t, const mesh::Point& place) {
  for (unsigned i = 0; i < 4; ++i)
    if (side(points, t, i, place) == Sign::negative) return false;
  return true;
}

std::array<Index, 4> sorted(Tetrahedron t) {
  std::sort(t.begin(), t.end());
  return t;
}

std::set<std::array<Index, 4>> as_sets(std::span<const Tetrahedron> mesh) {
  std::set<std::array<Index, 4>> result;
  for (const Tetrahedron& t : mesh) result.insert(sorted(t));
  return result;
}

mesh::Point mean(const mesh::Point& p, const mesh::Point& q) {
  return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
}

double volume(const std::array<mesh::Point, 4>& t) {
  const auto from = [&](unsigned i) {
    return std::array{t[i].x - t[0].x, t[i].y - t[0].y, t[i].z - t[0].z};
  };
  const auto a = from(1), b = from(2), c = from(3);
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6;
}

mesh::Point barycentre(const std::array<mesh::Point, 4>& t) {
  return mean(mean(t[0], t[1]), mean(t[2], t[3]));
}

/// Random, on the lattice, on facets and edges, at vertices, outside.
std::vector<mesh::Point> places_for(const Cloud& points, Random& random) {
  std::vector<mesh::Point> places{{1e300, 0, 0}, {0, -1e300, 1e-300}, {-1, -1, -1}};
  for (int i = 0; i < 60; ++i) {
    const mesh::Point& p = points[random() % points.size()];
    const mesh::Point& q = points[random() % points.size()];
    places.push_back(p);
    places.push_back(mean(p, q));
    places.push_back(in_box(random, 5, 5, 5));
  }
  return places;
}

std::vector<Cloud> some_clouds(Random& random) {
  return {uniform(60, random, 4, 4, 4), real(lattice_box(4, 4, 4)), sphere(60, random),
          real(some_of(lattice_box(5, 5, 5), 40, random)),
          with_duplicates(real(some_of(lattice_box(5, 5, 5), 60, random)), random)};
}

TEST(Located, IsATetrahedronThatContainsThePlace) {
  Random random(20261231);
  std::size_t inside = 0, outside = 0;
  for (const Cloud& points : some_clouds(random)) {
    Triangulation made(points);
    const auto mesh = made.tetrahedra();
    const auto all = as_sets(mesh);
    for (const mesh::Point& place : places_for(points, random)) {
      const auto found = made.located(place);
      ASSERT_EQ(found.has_value(), std::any_of(mesh.begin(), mesh.end(), [&](const auto& t) {
                  return contains(points, t, place);
                }));
      ++(found ? inside : outside);
      if (!found) continue;
      ASSERT_TRUE(contains(points, *found, place));
      ASSERT_TRUE(all.contains(sorted(*found)));
      for (unsigned i = 0; i < 4; ++i)
        ASSERT_EQ(side(points, *found, i, points[(*found)[i]]), Sign::positive);
    }
  }
  EXPECT_GT(inside, 300U);
  EXPECT_GT(outside, 50U);
}

TEST(Star, HasTheTetrahedraOfThePlace) {
  Random random(20261232);
  for (const Cloud& points : some_clouds(random)) {
    Triangulation made(points);
    const auto mesh = made.tetrahedra();
    for (int tries = 0; tries < 100; ++tries) {
      const auto point = static_cast<Index>(random() % points.size());
      const auto vertex = static_cast<Index>(
          std::find(points.begin(), points.end(), points[point]) - points.begin());
      std::set<std::array<Index, 4>> expected;
      for (const Tetrahedron& t : mesh)
        if (std::find(t.begin(), t.end(), vertex) != t.end()) expected.insert(sorted(t));
      const auto star = made.star(point);
      ASSERT_EQ(star.size(), expected.size());
      ASSERT_EQ(as_sets(star), expected);
      for (const Tetrahedron& t : star) {
        ASSERT_EQ(t[0], vertex);
        ASSERT_EQ(side(points, t, 0, points[t[0]]), Sign::positive);
      }
    }
    EXPECT_EQ(made.tetrahedra(), mesh);
  }
}

/// Each point after the first few: the same as if it had been there from the beginning.
TEST(Insert, IsAsFromScratch) {
  Random random(20261233);
  for (std::size_t trial = 0; trial < 160; ++trial) {
    Cloud points = real(small_set(trial, 30, random));
    Cloud so_far(points.begin(), points.begin() + 4);
    while (so_far.size() < points.size() && Triangulation(so_far).dimension() < 3)
      so_far.push_back(points[so_far.size()]);
    if (Triangulation(so_far).dimension() < 3) continue;
    Triangulation made(so_far);
    for (std::size_t i = so_far.size(); i < points.size(); ++i) {
      so_far.push_back(points[i]);
      const Index vertex = made.insert(points[i]);
      ASSERT_EQ(vertex, static_cast<Index>(std::find(points.begin(), points.end(), points[i]) -
                                           points.begin()));
      const Triangulation expected(so_far);
      ASSERT_EQ(made.tetrahedra(), expected.tetrahedra());
      ASSERT_EQ(made.points(), so_far.size());
      ASSERT_EQ(made.duplicates(), expected.duplicates());
      ASSERT_EQ(made.star(static_cast<Index>(i)).size(), made.star(vertex).size());
    }
  }
}

/// Coordinates that are longer than those of all points so far, and nearly on spheres of these.
TEST(Insert, BesideALattice) {
  Random random(20261250);
  Cloud points = real(lattice_box(5, 5, 5));
  Triangulation made(points);
  for (int i = 0; i < 300; ++i) {
    const auto coordinate = [&] {
      return static_cast<double>(1 + random() % 7) / 2 +
             0x1p-51 * static_cast<double>(random() % 3);
    };
    points.push_back({coordinate(), coordinate(), coordinate()});
    made.insert(points.back());
  }
  ASSERT_EQ(made.tetrahedra(), Triangulation(points).tetrahedra());
  ASSERT_EQ(broken_law(points, made.tetrahedra()), "");
}

TEST(Insert, ManyPointsAfterAFew) {
  Random random(20261234);
  const Cloud points = uniform(3000, random);
  for (const int threads : {1, 3}) {
    Triangulation made(std::span<const mesh::Point>(points).first(10), {threads});
    for (std::size_t i = 10; i < points.size(); ++i)
      ASSERT_EQ(made.insert(points[i]), static_cast<Index>(i));
    EXPECT_EQ(made.tetrahedra(), Triangulation(points).tetrahedra());
  }
}

/// The cavity has all points as vertices, more than have small numbers.
TEST(Insert, InTheMiddleOfASphere) {
  Random random(20261235);
  for (const std::size_t count : {20U, 61U, 62U, 63U, 64U, 65U, 66U, 1000U}) {
    Cloud points = sphere(count, random);
    Triangulation made(points);
    points.push_back({0, 0, 0});
    ASSERT_EQ(made.insert(points.back()), static_cast<Index>(count));
    const auto mesh = made.tetrahedra();
    ASSERT_EQ(mesh, Triangulation(points).tetrahedra());
    ASSERT_EQ(broken_law(points, mesh), "");
    EXPECT_GT(made.star(static_cast<Index>(count)).size(), count);
    ASSERT_EQ(made.insert({0, 0, 0}), static_cast<Index>(count));
    for (int i = 0; i < 50; ++i) {
      points.push_back(in_box(random, 0.1, 0.1, 2));
      made.insert(points.back());
    }
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(count) + 1, mesh::Point{0, 0, 0});
    ASSERT_EQ(broken_law(points, made.tetrahedra()), "");
  }
}

/// A point far outside sees half of a hull with many facets.
TEST(Insert, FarOutside) {
  Random random(20261236);
  Cloud points = sphere(500, random);
  Triangulation made(points);
  for (const mesh::Point& p : Cloud{{1e3, 0, 0}, {0, -1e30, 0}, {-1e300, 1e300, 1e300}}) {
    points.push_back(p);
    made.insert(p);
    ASSERT_EQ(broken_law(points, made.tetrahedra()), "");
  }
}

TEST(Refine, EndsWhenNoTetrahedronIsLarge) {
  Random random(20261237);
  constexpr double kLarge = 0.0002;
  for (const int threads : {1, 2}) {
    const Cloud before = uniform(20, random);
    Triangulation made(before, {threads});
    Cloud points = before;
    const auto wish = [&](const std::array<mesh::Point, 4>& t) -> std::optional<mesh::Point> {
      EXPECT_GT(volume(t), -1e-12);
      if (volume(t) <= kLarge) return std::nullopt;
      points.push_back(barycentre(t));
      return points.back();
    };
    EXPECT_EQ(made.refine(wish, 0), 0U);
    EXPECT_EQ(made.refine(wish, 7), 7U);
    EXPECT_EQ(made.points(), before.size() + 7);
    const std::size_t more = made.refine(wish, 1000000);
    EXPECT_GT(more, 300U);
    EXPECT_EQ(made.points(), before.size() + 7 + more);
    ASSERT_EQ(points.size(), made.points());
    const auto mesh = made.tetrahedra();
    EXPECT_EQ(mesh, Triangulation(points).tetrahedra());
    for (const auto& [a, b, c, d] : mesh)
      ASSERT_LE(volume({points[a], points[b], points[c], points[d]}), kLarge);
    EXPECT_EQ(made.refine(wish, 10), 0U);
  }
}

/// A wish for a vertex that is there already inserts nothing and is not asked for again.
TEST(Refine, IgnoresWishesForVertices) {
  Random random(20261238);
  const Cloud points = uniform(50, random);
  Triangulation made(points);
  const std::size_t tetrahedra = made.size();
  std::size_t asked = 0;
  EXPECT_EQ(made.refine(
                [&](const auto& t) {
                  ++asked;
                  return std::optional(t[asked % 4]);
                },
                1000),
            0U);
  EXPECT_EQ(asked, tetrahedra);
  EXPECT_EQ(made.size(), tetrahedra);
}

}  // namespace
