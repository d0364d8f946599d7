// Claim. untangled() makes every hexahedron of a spoiled grid valid, at any scale; leaves fixed and
// unused points as they are, bit for bit; ends with finite coordinates where nothing can be done.
// Oracle. The Jacobian determinant at 125 places of each hexahedron, from its definition
// (grids.hpp); multiplication by a power of two, which is exact; points compared as bits.
#include "realize/untangle/untangle.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "enum/core/errors.hpp"
#include "tests/realize/untangle/grids.hpp"

namespace hexatlas::untangle {
namespace {

using exact::Point3;

std::array<std::uint64_t, 3> bits(const Point3& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
          std::bit_cast<std::uint64_t>(p.z)};
}

void expect_fixed_kept(const Mesh& mesh, const std::vector<Point3>& points) {
  ASSERT_EQ(points.size(), mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (mesh.is_free[v] == 0) {
      EXPECT_EQ(bits(points[v]), bits(mesh.points[v]));
    }
}

/// Every point near its place in the grid, the boundary too; 0.2 leaves all cells valid.
Mesh shaken(std::uint32_t n, double amplitude, support::Random& random) {
  Mesh mesh = grids::cubes(n);
  for (Point3& p : mesh.points) {
    p.x += amplitude * (2 * grids::fraction(random) - 1);
    p.y += amplitude * (2 * grids::fraction(random) - 1);
    p.z += amplitude * (2 * grids::fraction(random) - 1);
  }
  return mesh;
}

TEST(Untangle, AScatteredGridBecomesValid) {
  support::Random random(1);
  for (const bool as_given : {false, true})
    for (std::uint32_t n = 2; n <= 4; ++n) {
      Mesh mesh = shaken(n, 0.15, random);
      grids::scatter(mesh, n, random);
      ASSERT_LT(grids::least_jacobian(mesh, mesh.points), 0);
      const auto points = untangled(mesh, {.effort = 2, .starts_as_given = as_given});
      expect_fixed_kept(mesh, points);
      EXPECT_GT(grids::least_jacobian(mesh, points), 0) << n << as_given;
    }
}

TEST(Untangle, AFoldedGridBecomesValid) {
  for (const double shift :
       {1.5, 3.0}) {  // the inner points of a slab, pushed through the next ones
    Mesh mesh = grids::cubes(5);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.is_free[v] != 0 && mesh.points[v].x == 2) mesh.points[v].x += shift;
    ASSERT_LT(grids::least_jacobian(mesh, mesh.points), 0);
    const auto points = untangled(mesh, {.effort = 2, .starts_as_given = true});
    expect_fixed_kept(mesh, points);
    EXPECT_GT(grids::least_jacobian(mesh, points), 0.5);
  }
}

TEST(Untangle, AGridIsLeftInGoodShape) {
  Mesh mesh = grids::cubes(3);
  const auto points = untangled(mesh, {.effort = 1});
  EXPECT_GT(grids::least_jacobian(mesh, points), 0.99);
}

/// Steps of 1 to 1/1000 along each axis, the block sheared.
TEST(Untangle, ABlockHasTheSpacingOfItsBoundary) {
  const std::array<double, 6> at{0, 0.001, 0.003, 0.01, 0.2, 1};
  Mesh mesh = grids::cubes(5);
  for (Point3& p : mesh.points) {
    const double x = at[static_cast<std::size_t>(p.x)], y = -at[5 - static_cast<std::size_t>(p.y)];
    p = {x + 0.25 * y, y - 0.125 * p.z, p.z + 0.5 * x};
  }
  const std::vector<Point3> wanted = mesh.points;
  support::Random random(2);
  grids::scatter(mesh, 5, random);
  for (const int effort : {0, 2}) {
    const auto points = untangled(mesh, {.effort = effort});
    expect_fixed_kept(mesh, points);
    for (std::size_t v = 0; v < points.size(); ++v) {
      EXPECT_NEAR(points[v].x, wanted[v].x, 1e-9);
      EXPECT_NEAR(points[v].y, wanted[v].y, 1e-9);
      EXPECT_NEAR(points[v].z, wanted[v].z, 1e-9);
    }
  }
}

TEST(Untangle, ScalingByAPowerOfTwoScalesTheResult) {
  support::Random random(2);
  Mesh mesh = shaken(3, 0.15, random);
  grids::scatter(mesh, 3, random);
  const auto points = untangled(mesh, {.effort = 1});
  for (const int exponent : {500, -500, 1020, -900}) {
    Mesh scaled = mesh;
    for (Point3& p : scaled.points)
      p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const auto result = untangled(scaled, {.effort = 1});
    for (std::size_t v = 0; v < points.size(); ++v)
      EXPECT_EQ(bits(result[v]),
                bits({std::ldexp(points[v].x, exponent), std::ldexp(points[v].y, exponent),
                      std::ldexp(points[v].z, exponent)}));
  }
}

TEST(Untangle, GreatAndSmallAndFarAwayMeshesBecomeValid) {
  support::Random random(3);
  for (const double scale : {1e150, 1e-150, 1.0})
    for (const double shift : {0.0, 1e6}) {
      Mesh mesh = shaken(3, 0.15, random);
      grids::scatter(mesh, 3, random);
      for (Point3& p : mesh.points)
        p = {scale * (p.x + shift), scale * (p.y - shift), scale * (p.z + 2 * shift)};
      std::vector<Point3> points = untangled(mesh, {.effort = 1});
      expect_fixed_kept(mesh, points);
      for (Point3& p : points) p = {p.x / scale, p.y / scale, p.z / scale};
      EXPECT_GT(grids::least_jacobian(mesh, points), 0) << scale << ' ' << shift;
    }
}

TEST(Untangle, WithoutFixedPointsTheGivenPlacesAreTheStart) {
  support::Random random(4);
  Mesh mesh = shaken(3, 0.4, random);
  mesh.is_free.assign(mesh.is_free.size(), 1);
  ASSERT_LT(grids::least_jacobian(mesh, mesh.points), 0);
  const auto points = untangled(mesh, {.effort = 1});
  EXPECT_GT(grids::least_jacobian(mesh, points), 0);
  double greatest = 0;
  for (const Point3& p : points)
    greatest = std::max({greatest, std::abs(p.x - 1.5), std::abs(p.y - 1.5), std::abs(p.z - 1.5)});
  EXPECT_GT(greatest, 0.5);
  EXPECT_LT(greatest, 4);
}

TEST(Untangle, NothingToMove) {
  Mesh mesh = grids::cubes(2);
  mesh.is_free.assign(mesh.is_free.size(), 0);
  EXPECT_EQ(untangled(mesh, {}), mesh.points);
  EXPECT_EQ(untangled({{{1, 2, 3}}, {}, {1}}, {}), (std::vector<Point3>{{1, 2, 3}}));
  EXPECT_TRUE(untangled({}, {}).empty());
}

TEST(Untangle, AFreePointOfNoHexahedronStays) {
  Mesh mesh = grids::cubes(2);
  mesh.points.push_back({1e300, -0.0, 7});
  mesh.is_free.push_back(1);
  mesh.points.push_back({0, 0, 0});
  mesh.is_free.push_back(0);
  const auto points = untangled(mesh, {});
  EXPECT_EQ(bits(points[27]), bits(mesh.points[27]));
  EXPECT_EQ(bits(points[28]), bits(mesh.points[28]));
  EXPECT_GT(grids::least_jacobian(mesh, points), 0.99);
}

/// Where no place is right, the answer is finite and the fixed points are kept.
TEST(Untangle, ImpossibleBoundariesEndCleanly) {
  std::vector<Mesh> impossible(5, grids::cubes(2));
  for (Point3& p : impossible[0].points) p.z = 0;                              // flat
  for (Point3& p : impossible[1].points) p.x = -p.x;                           // inside out
  for (Point3& p : impossible[2].points) p = {3, 3, 3};                        // one place
  std::swap(impossible[3].points.front(), impossible[3].points.back());        // corners exchanged
  for (Point3& p : impossible[4].points) p = {1e-320 * p.x, 0, 1e-320 * p.z};  // subnormal, flat
  for (const Mesh& mesh : impossible) {
    const auto points = untangled(mesh, {.effort = 1});
    expect_fixed_kept(mesh, points);
    EXPECT_TRUE(grids::is_finite(points));
    EXPECT_LE(grids::least_jacobian(mesh, points), 0);
  }
}

TEST(Untangle, RequirementsAreChecked) {
  Mesh mesh = grids::cubes(1);
  EXPECT_THROW(static_cast<void>(untangled(mesh, {.effort = -1})), core::PreconditionViolated);
  EXPECT_THROW(static_cast<void>(untangled(mesh, {.threads = 0})), core::PreconditionViolated);
  mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(untangled(mesh, {})), core::PreconditionViolated);
  mesh.points[3].y = 1;
  mesh.hexahedra[0][7] = 8;
  EXPECT_THROW(static_cast<void>(untangled(mesh, {})), core::PreconditionViolated);
  mesh.hexahedra[0][7] = 0;
  EXPECT_THROW(static_cast<void>(untangled(mesh, {})), core::PreconditionViolated);
  mesh.hexahedra[0][7] = 7;
  mesh.is_free.pop_back();
  EXPECT_THROW(static_cast<void>(untangled(mesh, {})), core::PreconditionViolated);
}

}  // namespace
}  // namespace hexatlas::untangle
