// Claim. validity_of_hexahedron() says valid only if the Jacobian determinant is positive on the
// cube, invalid only if it is not; scaled_jacobian() is the least corner determinant of unit
// edge vectors.
// Oracle. Shapes known by hand; integer corners, where the matrix of partial derivatives is
// evaluated at rational points in 128-bit integers; mirror images and powers of two. The
// scaled Jacobian of a parallelepiped by Gram's formula.
#include "meshing/quality/hexahedron.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>

#include "tests/realize/exact/placed_cells.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using mesh::Point;
using placed_cells::scaled;
using quality::Corners;
using quality::Validity;

__extension__ using Wide = __int128;

Corners unit_cube() {
  Corners corners{};
  for (std::size_t v = 0; v < 8; ++v)
    corners[v] = {static_cast<double>(v & 1U), static_cast<double>(v >> 1U & 1U),
                  static_cast<double>(v >> 2U & 1U)};
  return corners;
}

template <class Map>
Corners mapped(Corners corners, const Map& map) {
  for (Point& p : corners) p = map(p);
  return corners;
}

Corners mirrored(const Corners& corners) {
  return mapped(corners, [](const Point& p) { return Point{p.x, p.y, -p.z}; });
}

/// steps^6 times the determinant at (r, s, t) / steps; corners must be integers.
Wide jacobian(const Corners& corners, std::int64_t r, std::int64_t s, std::int64_t t,
              std::int64_t steps) {
  const std::array<std::int64_t, 3> at{r, s, t};
  std::array<std::array<Wide, 3>, 3> d{};
  for (std::size_t direction = 0; direction < 3; ++direction)
    for (std::size_t v = 0; v < 8; ++v) {
      Wide weight = (v >> direction & 1U) != 0 ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k)
        if (k != direction) weight *= (v >> k & 1U) != 0 ? at[k] : steps - at[k];
      d[direction][0] += weight * std::llround(corners[v].x);
      d[direction][1] += weight * std::llround(corners[v].y);
      d[direction][2] += weight * std::llround(corners[v].z);
    }
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

Wide least_sample(const Corners& corners, std::int64_t steps) {
  Wide least = jacobian(corners, 0, 0, 0, steps);
  for (std::int64_t r = 0; r <= steps; ++r)
    for (std::int64_t s = 0; s <= steps; ++s)
      for (std::int64_t t = 0; t <= steps; ++t)
        least = std::min(least, jacobian(corners, r, s, t, steps));
  return least;
}

Corners random_corners(std::mt19937_64& random, int side, int shift) {
  std::uniform_int_distribution<int> move(-shift, shift);
  return mapped(unit_cube(), [&](const Point& p) {
    return Point{side * p.x + move(random), side * p.y + move(random), side * p.z + move(random)};
  });
}

/// Corners positive, some other sample not: the cell that a test of corners alone accepts.
std::optional<Corners> invalid_inside(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (int trial = 0; trial < 100000; ++trial) {
    const Corners corners = random_corners(random, 8, 5);
    if (least_sample(corners, 1) > 0 && least_sample(corners, 4) < 0) return corners;
  }
  return std::nullopt;
}

TEST(Hexahedron, KnownShapes) {
  EXPECT_EQ(quality::validity_of_hexahedron(unit_cube()), Validity::valid);
  const Corners sheared = mapped(unit_cube(), [](const Point& p) {
    return Point{p.x + 5 * p.y - 3 * p.z, p.y + p.z, p.z};
  });
  EXPECT_EQ(quality::validity_of_hexahedron(sheared), Validity::valid);
  const Corners flat = mapped(unit_cube(), [](const Point& p) { return Point{p.x, p.y, 0}; });
  EXPECT_EQ(quality::validity_of_hexahedron(flat), Validity::invalid);
  EXPECT_EQ(quality::validity_of_hexahedron(Corners{}), Validity::invalid);
  Corners one_corner_pushed_through = unit_cube();
  one_corner_pushed_through[7] = {0.1, 0.1, 0.1};
  EXPECT_EQ(quality::validity_of_hexahedron(one_corner_pushed_through), Validity::invalid);
  Corners collapsed_edge = unit_cube();
  collapsed_edge[7] = collapsed_edge[6];
  EXPECT_EQ(quality::validity_of_hexahedron(collapsed_edge), Validity::invalid);
}

TEST(Hexahedron, InvertedMeansACorner) {
  EXPECT_FALSE(quality::verdict_of_hexahedron(unit_cube()).inverted);
  EXPECT_TRUE(quality::verdict_of_hexahedron(mirrored(unit_cube())).inverted);
  const auto inside = invalid_inside(20261106);
  ASSERT_TRUE(inside.has_value());
  const quality::Verdict verdict = quality::verdict_of_hexahedron(*inside);
  EXPECT_EQ(verdict.validity, Validity::invalid);
  EXPECT_FALSE(verdict.inverted);
}

TEST(Hexahedron, AgreesWithSamples) {
  std::mt19937_64 random(20261107);
  int valid = 0;
  int invalid = 0;
  int undecided = 0;
  for (int trial = 0; trial < support::share_of(1500); ++trial) {
    const Corners corners = random_corners(random, 8, 2 + trial % 5);
    const Validity validity = quality::validity_of_hexahedron(corners);
    if (validity == Validity::valid) {
      ASSERT_GT(least_sample(corners, 5), 0);
    }
    ASSERT_EQ(validity == Validity::invalid, least_sample(corners, 16) <= 0);
    valid += validity == Validity::valid ? 1 : 0;
    invalid += validity == Validity::invalid ? 1 : 0;
    undecided += validity == Validity::undecided ? 1 : 0;
  }
  EXPECT_GT(valid, support::share_of(200));
  EXPECT_GT(invalid, support::share_of(200));
  EXPECT_LT(undecided, support::share_of(50));
}

TEST(Hexahedron, MirrorImagesAndScales) {
  std::mt19937_64 random(20261108);
  for (int trial = 0; trial < 1000; ++trial) {
    const Corners corners = random_corners(random, 8, 2 + trial % 5);
    const quality::Verdict verdict = quality::verdict_of_hexahedron(corners);
    if (verdict.validity == Validity::valid) {
      ASSERT_EQ(quality::validity_of_hexahedron(mirrored(corners)), Validity::invalid);
    }
    for (const int exponent : {-1074, -1000, -340, 340, 1000, 1018}) {
      const quality::Verdict other = quality::verdict_of_hexahedron(scaled(corners, exponent));
      ASSERT_EQ(other.validity, verdict.validity);
      ASSERT_EQ(other.inverted, verdict.inverted);
    }
  }
}

TEST(Hexahedron, ScaledJacobianOfParallelepipeds) {
  EXPECT_DOUBLE_EQ(quality::scaled_jacobian(unit_cube()), 1);
  EXPECT_DOUBLE_EQ(quality::scaled_jacobian(mirrored(unit_cube())), -1);
  EXPECT_DOUBLE_EQ(quality::scaled_jacobian(Corners{}), 0);
  // Unit edges with pairwise cosines a, b, c: the volume is sqrt(1 + 2abc - a^2 - b^2 - c^2).
  const double a = 0.3;
  const double b = -0.2;
  const double c = 0.5;
  const double height = std::sqrt(1 - a * a);
  const double lean = (c - a * b) / height;
  const double rise = std::sqrt(1 - b * b - lean * lean);
  const Corners cell = mapped(unit_cube(), [&](const Point& p) {
    return Point{3 * p.x + a * p.y + 7 * b * p.z, height * p.y + 7 * lean * p.z, 7 * rise * p.z};
  });
  const double expected = std::sqrt(1 + 2 * a * b * c - a * a - b * b - c * c);
  EXPECT_NEAR(quality::scaled_jacobian(cell), expected, 1e-15);
  for (const int exponent : {-1000, -500, 500, 1020})
    EXPECT_NEAR(quality::scaled_jacobian(scaled(cell, exponent)), expected, 1e-14);
}

TEST(Hexahedron, ScaledJacobianCountsTheWorstCorner) {
  Corners cell = unit_cube();
  cell[7] = {1, 1, 2};  // corner 7: edges to 6, 5, 3 are (-1,0,-1), (0,-1,-1), (0,0,-2)
  EXPECT_NEAR(quality::scaled_jacobian(cell), 0.5, 1e-15);
  cell[7] = cell[6];
  EXPECT_NEAR(quality::scaled_jacobian(cell), 0, 1e-15);
}

}  // namespace
