// Claim. Inputs of many kinds, of some thousand points, are triangulated; numbers of tetrahedra
// that are known are met.
// Oracle. laws.hpp; formulas for lattices, skew lines and points of the moment curve.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshing/delaunay/triangulation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/laws.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Triangulation;

std::vector<Triangulation::Tetrahedron> expect_lawful(const Cloud& points) {
  auto mesh = Triangulation(points).tetrahedra();
  EXPECT_EQ(broken_law(points, mesh), "");
  return mesh;
}

TEST(Laws, GeneralPosition) {
  Random random(20261211);
  expect_lawful(uniform(5000, random));
  expect_lawful(clusters(5000, random));
  expect_lawful(with_duplicates(uniform(5000, random), random));
}

TEST(Laws, AnisotropicBoxes) {
  Random random(20261212);
  for (const double x : {1e-9, 1e9})
    for (const double y : {1e-4, 1e7}) expect_lawful(uniform(1000, random, x, y, 1));
}

TEST(Laws, Surfaces) {
  Random random(20261213);
  expect_lawful(sphere(2000, random));
  expect_lawful(paraboloid(2000, random));
  expect_lawful(helix(300, 3));
}

/// The six tetrahedra of each cube have the volume 1/6.
TEST(Laws, Lattice) {
  constexpr std::size_t kSide = 12;
  EXPECT_EQ(expect_lawful(grid(kSide, 1)).size(), 6 * 11U * 11U * 11U);
  EXPECT_EQ(expect_lawful(grid(kSide, 0x1p-20)).size(), 6 * 11U * 11U * 11U);
  expect_lawful(grid(kSide, 0.1));
}

TEST(Laws, SkewLines) {
  const auto mesh = expect_lawful(skew_lines(60));
  ASSERT_EQ(mesh.size(), 59U * 59U);
  for (const auto& t : mesh)
    EXPECT_EQ(t[0] % 2 + t[1] % 2 + t[2] % 2 + t[3] % 2, 2U);  // two of each line
}

/// Laws that cannot fail prove nothing.
TEST(Laws, FindFaults) {
  Random random(20261214);
  const Cloud points = uniform(50, random);
  const auto mesh = Triangulation(points).tetrahedra();
  EXPECT_EQ(broken_law(points, mesh), "");
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    auto changed = mesh;
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(broken_law(points, changed), "");
    changed = mesh;
    std::swap(changed[i][2], changed[i][3]);
    EXPECT_NE(broken_law(points, changed), "");
  }
  // Of other points: lawful but for the spheres, or for the sides.
  Cloud moved = points;
  for (mesh::Point& p : moved) p.x *= 4;
  EXPECT_EQ(broken_law(moved, mesh), "facets: two sides, empty spheres");
}

/// Five points: two tetrahedra instead of three, and three instead of two.
TEST(Laws, FindTheOtherTriangulationOfFivePoints) {
  Cloud points{{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {0, 0, 2}, {0, 0, -2}};
  const std::vector<Triangulation::Tetrahedron> two{{0, 1, 2, 3}, {0, 1, 4, 2}};
  const std::vector<Triangulation::Tetrahedron> three{{0, 1, 4, 3}, {0, 2, 3, 4}, {1, 2, 4, 3}};
  EXPECT_EQ(broken_law(points, two), "");
  EXPECT_EQ(broken_law(points, three), "facets: two sides, empty spheres");
  points[3].z = 0.1;
  points[4].z = -0.1;
  EXPECT_EQ(broken_law(points, three), "");
  EXPECT_EQ(broken_law(points, two), "facets: two sides, empty spheres");
  EXPECT_EQ(broken_law(points, {three[0], three[1]}), "convex surface");
}

}  // namespace
