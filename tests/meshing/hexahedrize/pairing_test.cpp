// Claim. sides_of() tells what lies at each side of each quad and numbers the edges; partners()
// divides the quads of 3-connected spheres into pairs of neighbours. Oracle. A search over all
// pairs of quads; the pairs looked at one by one.
#include "meshing/hexahedrize/pairing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/meshing/hexahedrize/spheres.hpp"

namespace {

using namespace hexatlas;
using complex::QuadSphere;
using complex::VertexId;
using hexahedrize::Sides;

std::vector<QuadSphere> some_spheres() {
  std::vector<QuadSphere> result{support::grid_cube(1), support::grid_cube(4),
                                 support::trapezohedron(4), support::trapezohedron(37)};
  for (const std::size_t inserted : {5U, 30U, 90U})
    for (std::uint64_t seed = 0; seed < 10; ++seed)
      result.push_back(support::random_sphere(24 + 16 * seed, seed, inserted));
  return result;
}

/// The edge from vertex s of a quad to the next, without a direction.
std::pair<VertexId, VertexId> edge(const QuadSphere& sphere, std::size_t quad, std::size_t s) {
  return std::minmax(sphere.quads[quad][s], sphere.quads[quad][(s + 1) % 4]);
}

TEST(Sides, AreThoseOfASearchOverAllQuads) {
  for (const QuadSphere& sphere : some_spheres()) {
    const Sides sides = hexahedrize::sides_of(sphere);
    ASSERT_EQ(sides.size(), sphere.quads.size());
    std::set<std::uint32_t> numbers;
    for (std::size_t q = 0; q < sides.size(); ++q)
      for (std::size_t s = 0; s < 4; ++s) {
        numbers.insert(sides[q][s].edge);
        std::size_t others = 0;
        for (std::size_t p = 0; p < sides.size(); ++p)
          for (std::size_t t = 0; t < 4; ++t) {
            if (p == q || edge(sphere, p, t) != edge(sphere, q, s)) continue;
            ++others;
            EXPECT_EQ(sides[q][s].quad, p);
            EXPECT_EQ(sides[p][t].edge, sides[q][s].edge);
          }
        EXPECT_EQ(others, 1U);
      }
    EXPECT_EQ(numbers.size(), 2 * sides.size());
    EXPECT_EQ(*numbers.rbegin(), 2 * sides.size() - 1);
  }
}

void expect_paired(const QuadSphere& sphere) {
  const auto partner = hexahedrize::partners(hexahedrize::sides_of(sphere));
  ASSERT_EQ(partner.size(), sphere.quads.size());
  for (std::size_t q = 0; q < partner.size(); ++q) {
    ASSERT_LT(partner[q], partner.size());
    ASSERT_NE(partner[q], q);
    EXPECT_EQ(partner[partner[q]], q);
    std::size_t shared = 0;
    for (std::size_t s = 0; s < 4; ++s)
      for (std::size_t t = 0; t < 4; ++t)
        if (edge(sphere, q, s) == edge(sphere, partner[q], t)) ++shared;
    EXPECT_EQ(shared, 1U);
  }
}

TEST(Partners, AreNeighboursAndMutual) {
  for (const QuadSphere& sphere : some_spheres()) expect_paired(sphere);
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    expect_paired(support::random_sphere(24 + 2 * seed, seed, 1 + seed % 97));
  expect_paired(support::random_sphere(5000, 1));
}

TEST(RandomSpheres, HaveNoReasonAgainstAFilling) {
  for (const QuadSphere& sphere : some_spheres()) {
    EXPECT_EQ(complex::reason_against_filling(sphere), std::nullopt);
    EXPECT_EQ(sphere.reversed, 0U);
    // The law itself, without a library: no two vertices are opposite in two quads.
    std::set<std::pair<VertexId, VertexId>> opposite;
    for (const auto& quad : sphere.quads) {
      EXPECT_TRUE(opposite.insert(std::minmax(quad[0], quad[2])).second);
      EXPECT_TRUE(opposite.insert(std::minmax(quad[1], quad[3])).second);
    }
  }
}

}  // namespace
