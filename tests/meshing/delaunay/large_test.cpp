// Claim. Large inputs of many kinds are triangulated.
// Oracle. laws.hpp; formulas for lattices and skew lines.
#include <gtest/gtest.h>

#include <cstddef>

#include "meshing/delaunay/triangulation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/laws.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Triangulation;

/// The number of tetrahedra.
std::size_t expect_lawful(const Cloud& points) {
  const auto mesh = Triangulation(points).tetrahedra();
  EXPECT_EQ(broken_law(points, mesh), "");
  return mesh.size();
}

TEST(Large, GeneralPosition) {
  Random random(20261221);
  expect_lawful(uniform(50000, random));
  expect_lawful(clusters(50000, random));
  expect_lawful(uniform(20000, random, 1, 1e-6, 1e6));
  expect_lawful(with_duplicates(uniform(50000, random), random));
}

TEST(Large, Surfaces) {
  Random random(20261222);
  expect_lawful(sphere(20000, random));
  expect_lawful(paraboloid(20000, random));
}

/// The number of tetrahedra is quadratic.
TEST(Large, Curves) {
  EXPECT_GT(expect_lawful(helix(600, 1)), 100000U);
  EXPECT_EQ(expect_lawful(skew_lines(300)), 299U * 299U);
}

TEST(Large, Lattices) {
  Random random(20261223);
  EXPECT_EQ(expect_lawful(grid(20, 1)), 6 * 19U * 19U * 19U);
  EXPECT_EQ(expect_lawful(grid(50, 1)), 6 * 49U * 49U * 49U);
  expect_lawful(with_duplicates(grid(20, 1), random));
  expect_lawful(grid(40, 0.1));
}

}  // namespace
