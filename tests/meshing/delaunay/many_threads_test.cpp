// Claim. Large inputs have the same tetrahedra for 1, 2, 3, 4, 7, 16 threads: the Delaunay ones.
// Oracle. One thread; laws.hpp.
#include <gtest/gtest.h>

#include <cstdint>

#include "meshing/delaunay/triangulation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/laws.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Triangulation;

void expect_same(const Cloud& points) {
  const auto expected = Triangulation(points).tetrahedra();
  ASSERT_EQ(broken_law(points, expected), "");
  for (const int threads : {2, 3, 4, 7, 16})
    for (const std::uint64_t seed : {0U, 1U})
      ASSERT_EQ(Triangulation(points, {threads, seed}).tetrahedra(), expected)
          << threads << " threads";
}

TEST(ManyThreads, GeneralPosition) {
  Random random(20261271);
  expect_same(uniform(60000, random));
  expect_same(clusters(40000, random));
}

/// The hull has few vertices: its facets are large, and go through all parts.
TEST(ManyThreads, ATetrahedronFullOfPoints) {
  Random random(20261272);
  Cloud points{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}};
  const Cloud inside = uniform(40000, random, 3, 3, 3);
  points.insert(points.end(), inside.begin(), inside.end());
  expect_same(points);
}

TEST(ManyThreads, Surfaces) {
  Random random(20261273);
  expect_same(sphere(30000, random));
}

TEST(ManyThreads, Lattices) {
  Random random(20261274);
  expect_same(grid(30, 1));
  expect_same(with_duplicates(grid(30, 0.1), random));
}

/// Ties take longer, so one of two threads gets some of the other's work.
TEST(ManyThreads, OneHalfIsHarder) {
  Random random(20261276);
  Cloud points = grid(34, 1);
  for (const mesh::Point& p : uniform(points.size(), random, 34, 34, 34))
    points.push_back({p.x - 40, p.y, p.z});
  expect_same(points);
}

/// A curve that is not convex, with some noise: its tetrahedra are long.
TEST(ManyThreads, Curve) {
  Random random(20261275);
  Cloud points = helix(20000, 300);
  for (mesh::Point& p : points) p.z += 1e-4 * unit(random);
  expect_same(points);
}

}  // namespace
