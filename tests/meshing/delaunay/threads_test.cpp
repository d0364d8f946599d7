// Claim. Any number of threads gives the same tetrahedra. Sizes are such that all threads have
// parts of the last round, and once of what is left of it.
// Oracle. One thread.
#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>

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

TEST(DelaunayThreads, LongReferences) {
  Random random(20261265);
  const Cloud points = uniform(10000, random);
  EXPECT_EQ(Triangulation(points, {4, 1, References::long_}).tetrahedra(),
            Triangulation(points).tetrahedra());
}

}  // namespace
