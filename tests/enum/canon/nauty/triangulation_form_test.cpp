// Claim. triangulation_form() tells isomorphism, group orders and orbits of balls and spheres and
// does not depend on labels. Oracle. Least image over all walks, without nauty; flips make the
// samples.
#include "enum/canon/nauty/triangulation_form.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "enum/balls/spheres.hpp"
#include "tests/enum/balls/support.hpp"

namespace {

using namespace hexatlas;

/// Spheres on 6 .. 9 vertices by random flips, with random labels, and balls made of them.
std::vector<complex::Triangulation> samples(support::Random& random) {
  std::vector<complex::Triangulation> result;
  complex::Triangulation sphere = balls::spheres(5).found[0];
  for (int vertices = 6; vertices <= 9; ++vertices) {
    const auto finer = balls::subdivided(sphere);
    sphere = finer[random.below(finer.size())];
    for (int i = 0; i < 30; ++i) {
      const auto next = balls::flipped(sphere);
      if (next.empty()) continue;
      sphere = next[random.below(next.size())];
      result.push_back(support::scrambled(sphere, random));
      result.push_back(balls::punctured(sphere, static_cast<int>(random.below(
                                                    static_cast<std::size_t>(vertices))))
                           .ball);
    }
  }
  return result;
}

TEST(TriangulationForm, AgreesWithWalks) {
  support::Random random(3);
  std::map<complex::Triangulation, oracle::Tetrahedra> walk_of;
  std::map<oracle::Tetrahedra, complex::Triangulation> form_of;
  for (const auto& sample : samples(random)) {
    const auto form = canon::triangulation_form(sample);
    const auto walk = oracle::walk_form(support::tetrahedra_of(sample));
    EXPECT_EQ(form.automorphisms, walk.automorphisms);
    EXPECT_EQ(std::vector<int>(form.orbit.begin(), form.orbit.begin() + sample.vertices),
              walk.orbit);
    EXPECT_EQ(walk_of.emplace(form.canonical, walk.least).first->second, walk.least);
    EXPECT_EQ(form_of.emplace(walk.least, form.canonical).first->second, form.canonical);
    EXPECT_EQ(complex::image_of(sample, form.labels), form.canonical);
  }
  EXPECT_GT(form_of.size(), 100U);
}

TEST(TriangulationForm, DoesNotDependOnLabels) {
  support::Random random(4);
  for (const auto& sample : samples(random)) {
    const auto form = canon::triangulation_form(sample);
    const auto copy = canon::triangulation_form(support::scrambled(sample, random));
    EXPECT_EQ(copy.canonical, form.canonical);
    EXPECT_EQ(copy.automorphisms, form.automorphisms);
  }
}

TEST(TriangulationForm, GroupsThatAreKnown) {
  // A tetrahedron; the boundary of the 4-simplex; the cyclic 4-polytope with seven vertices, by
  // Gale's evenness condition, whose group is that of the heptagon.
  EXPECT_EQ(canon::triangulation_form({4, {15}}).automorphisms, 24U);
  EXPECT_EQ(canon::triangulation_form(balls::spheres(5).found[0]).automorphisms, 120U);
  complex::Triangulation cyclic{7, {}};
  for (int a = 0; a < 7; ++a)
    for (int b = a + 2; b < 7; ++b)
      if ((b + 1) % 7 != a)
        cyclic.tetrahedra.push_back(
            static_cast<complex::VertexSet>(complex::bit_of(a) | complex::bit_of((a + 1) % 7) |
                                            complex::bit_of(b) | complex::bit_of((b + 1) % 7)));
  const auto form = canon::triangulation_form(cyclic);
  EXPECT_EQ(form.automorphisms, 14U);
  for (int v = 0; v < 7; ++v) EXPECT_EQ(form.orbit[static_cast<std::size_t>(v)], 0);
}

TEST(TriangulationForm, MoreNodesThanBitsInAWord) {
  // The join of the circles 0 .. 7 and 8 .. 15: 64 tetrahedra.
  complex::Triangulation sphere{16, {}};
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b)
      sphere.tetrahedra.push_back(static_cast<complex::VertexSet>(
          complex::bit_of(a) | complex::bit_of((a + 1) % 8) | complex::bit_of(8 + b) |
          complex::bit_of(8 + (b + 1) % 8)));
  support::Random random(5);
  const auto form = canon::triangulation_form(sphere);
  EXPECT_EQ(form.automorphisms, 2U * 16U * 16U);
  EXPECT_EQ(canon::triangulation_form(support::scrambled(sphere, random)).canonical,
            form.canonical);
  sphere.tetrahedra.resize(63);
  EXPECT_EQ(canon::triangulation_form(sphere).automorphisms, 8U);
}

}  // namespace
