// Claim. Any number of threads gives the same tetrahedra. Sizes are such that all threads have
// parts of the last round, and once of what is left of it.
// Oracle. One thread.
#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "meshing/delaunay/triangulation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::References;
using delaunay::Triangulation;

void expect_same(const Cloud& points, std::initializer_list<int> numbers_of_threads) {
  const Triangulation one(points);
  const auto expected = one.tetrahedra();
  std::uint64_t seed = 0;
  for (const int threads : numbers_of_threads) {
    const Triangulation made(points, {threads, ++seed});
    ASSERT_EQ(made.tetrahedra(), expected) << threads << " threads";
    ASSERT_EQ(made.duplicates(), one.duplicates());
    ASSERT_EQ(made.dimension(), 3);
  }
}

/// Few of a round's points are duplicates; some are on the hull.
TEST(DelaunayThreads, GeneralPosition) {
  Random random(20261261);
  expect_same(uniform(14000, random), {2, 4});
}

/// With three threads there are enough left over for a pass along another curve.
TEST(DelaunayThreads, SeveralCurves) {
  Random random(20261268);
  expect_same(uniform(20000, random), {3});
}

/// Nearly all tetrahedra are at the hull.
TEST(DelaunayThreads, Surface) {
  Random random(20261262);
  expect_same(sphere(12000, random), {3});
}

/// Coplanar facets of the hull, ties everywhere.
TEST(DelaunayThreads, Lattice) {
  Random random(20261263);
  expect_same(with_duplicates(grid(22, 1), random), {4});
}

/// Many points have the same key.
TEST(DelaunayThreads, Clusters) {
  Random random(20261264);
  expect_same(clusters(12000, random), {3});
}

void expect_same_weighted(const Cloud& points, const std::vector<double>& weights,
                          std::initializer_list<int> numbers_of_threads) {
  const Triangulation one(points, weights);
  const auto expected = one.tetrahedra();
  const auto hidden = one.hidden();
  EXPECT_GT(hidden.size(), points.size() / 10);
  std::uint64_t seed = 0;
  for (const int threads : numbers_of_threads) {
    const Triangulation made(points, weights, {threads, ++seed});
    ASSERT_EQ(made.tetrahedra(), expected) << threads << " threads";
    ASSERT_EQ(made.duplicates(), one.duplicates());
    ASSERT_EQ(made.hidden(), hidden);
  }
}

/// Vertices are hidden by others in all parts.
TEST(DelaunayThreads, WeightsInGeneralPosition) {
  Random random(20261266);
  const Cloud points = uniform(14000, random);
  std::vector<double> weights(points.size());
  for (double& w : weights) w = 0.003 * unit(random);
  expect_same_weighted(points, weights, {2, 4});
}

/// Ties everywhere; of points at one place the heavier wins, of equal ones the first.
TEST(DelaunayThreads, WeightsOnALattice) {
  Random random(20261267);
  const Cloud points = with_duplicates(grid(22, 1), random);
  std::vector<double> weights(points.size());
  for (double& w : weights) w = static_cast<double>(random() % 3);
  expect_same_weighted(points, weights, {3, 4});
}

TEST(DelaunayThreads, LongReferences) {
  Random random(20261265);
  const Cloud points = uniform(10000, random);
  EXPECT_EQ(Triangulation(points, {4, 1, References::long_}).tetrahedra(),
            Triangulation(points).tetrahedra());
}

}  // namespace
