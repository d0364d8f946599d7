// Claim. The signs of the 27 Bernstein coefficients are those of the Jacobian determinant of the
// trilinear map; the verdict of depth d is not_positive exactly if the determinant is <= 0 at a
// point of the grid of step 2^-d, and positive only if it is positive.
// Oracle. Integer corners. The determinant of the 3x3 matrix of partial derivatives, each a
// sum over four edges, at grid points in 128-bit integers; coefficients by interpolation of the
// values at 0, 1/2, 1. Neither uses products of Bernstein polynomials or subdivision.
#include "realize/exact/jacobian.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>

#include "enum/core/errors.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using exact::Hexahedron;
using exact::Positivity;
using exact::Sign;

__extension__ using Wide = __int128;
using IntegerHexahedron = std::array<std::array<std::int64_t, 3>, 8>;

/// steps^6 times the Jacobian determinant at (at[0], at[1], at[2]) / steps.
Wide jacobian(const IntegerHexahedron& p, const std::array<std::int64_t, 3>& at,
              std::int64_t steps) {
  std::array<std::array<Wide, 3>, 3> derivative{};  // [direction][coordinate]
  for (std::size_t direction = 0; direction < 3; ++direction)
    for (std::size_t v = 0; v < 8; ++v) {
      Wide weight = (v >> direction & 1U) != 0 ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k)
        if (k != direction) weight *= (v >> k & 1U) != 0 ? at[k] : steps - at[k];
      for (std::size_t c = 0; c < 3; ++c) derivative[direction][c] += weight * p[v][c];
    }
  const auto& d = derivative;
  Wide sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t e = (c + 1) % 3;
    const std::size_t f = (c + 2) % 3;
    sum += d[0][c] * (d[1][e] * d[2][f] - d[1][f] * d[2][e]);
  }
  return sum;
}

Sign sign_of(Wide value) {
  if (value == 0) return Sign::zero;
  return value > 0 ? Sign::positive : Sign::negative;
}

std::array<Sign, 27> interpolated_signs(const IntegerHexahedron& p) {
  std::array<Wide, 27> b{};
  for (std::int64_t i = 0; i < 27; ++i)
    b[static_cast<std::size_t>(i)] = jacobian(p, {i % 3, i / 3 % 3, i / 9}, 2);
  for (const std::size_t stride : {1U, 3U, 9U})
    for (std::size_t i = 0; i < 27; ++i)
      if (i / stride % 3 == 1) b[i] = 4 * b[i] - b[i - stride] - b[i + stride];
  std::array<Sign, 27> signs{};
  for (std::size_t i = 0; i < 27; ++i) signs[i] = sign_of(b[i]);
  return signs;
}

bool positive_on_grid(const IntegerHexahedron& p, std::int64_t steps) {
  for (std::int64_t x = 0; x <= steps; ++x)
    for (std::int64_t y = 0; y <= steps; ++y)
      for (std::int64_t z = 0; z <= steps; ++z)
        if (jacobian(p, {x, y, z}, steps) <= 0) return false;
  return true;
}

Hexahedron scaled(const IntegerHexahedron& p, int exponent) {
  Hexahedron h{};
  for (std::size_t v = 0; v < 8; ++v)
    h[v] = {std::ldexp(static_cast<double>(p[v][0]), exponent),
            std::ldexp(static_cast<double>(p[v][1]), exponent),
            std::ldexp(static_cast<double>(p[v][2]), exponent)};
  return h;
}

/// A cube of side `size` with each coordinate moved by at most `shift`.
IntegerHexahedron moved_cube(std::int64_t size, std::int64_t shift, std::mt19937_64& random) {
  std::uniform_int_distribution<std::int64_t> move(-shift, shift);
  IntegerHexahedron p{};
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      p[v][k] = size * static_cast<std::int64_t>(v >> k & 1U) + move(random);
  return p;
}

TEST(Jacobian, SignsOfTheCoefficients) {
  std::mt19937_64 random(20261104);
  int zeros = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const IntegerHexahedron p = moved_cube(trial % 8, 1 + trial % 5, random);
    const auto expected = interpolated_signs(p);
    for (const int exponent : {0, -1074, -1000, 900})
      ASSERT_EQ(exact::signs_of_jacobian_coefficients(scaled(p, exponent)), expected);
    for (const Sign sign : expected) zeros += sign == Sign::zero ? 1 : 0;
  }
  EXPECT_GT(zeros, 500);
}

TEST(Jacobian, VerdictOfEachDepth) {
  std::mt19937_64 random(20261105);
  std::array<int, 3> seen{};
  int refuted_inside = 0;
  for (int trial = 0; trial < support::share_of(1500); ++trial) {
    const IntegerHexahedron p = moved_cube(8, 2 + trial % 5, random);
    const Hexahedron h = scaled(p, 0);
    const bool corners_positive = positive_on_grid(p, 1);
    for (const int depth : {0, 1, 2}) {
      const auto verdict = exact::exact_jacobian_verdict(h, depth);
      const bool grid_positive = positive_on_grid(p, std::int64_t{1} << depth);
      ASSERT_EQ(verdict.positivity == Positivity::not_positive, !grid_positive);
      ASSERT_EQ(verdict.corner_not_positive, !corners_positive);
      if (verdict.positivity == Positivity::positive) {
        ASSERT_TRUE(positive_on_grid(p, 6));
      }
    }
    const auto verdict = exact::exact_jacobian_verdict(h, 4);
    ASSERT_EQ(verdict.positivity == Positivity::not_positive, !positive_on_grid(p, 16));
    if (verdict.positivity == Positivity::positive) {
      ASSERT_TRUE(positive_on_grid(p, 12));
    }
    ++seen[static_cast<std::size_t>(verdict.positivity)];
    refuted_inside += verdict.positivity == Positivity::not_positive && corners_positive ? 1 : 0;
    const auto filtered = exact::filtered_jacobian_verdict(h);
    if (filtered) {
      ASSERT_EQ(*filtered, verdict);
    }
  }
  EXPECT_GT(seen[0], support::share_of(150));
  EXPECT_GT(seen[1], support::share_of(150));
  EXPECT_GT(refuted_inside, support::share_of(3));
}

/// A sheared cube of side 2^50 and height h has the determinant h 2^100 everywhere.
TEST(Jacobian, HeightOfOneUlp) {
  constexpr std::int64_t kSide = std::int64_t{1} << 50;
  for (const std::int64_t height : {-1, 0, 1}) {
    IntegerHexahedron p{};
    for (std::size_t v = 0; v < 8; ++v) {
      const std::int64_t x = (v & 1U) != 0 ? kSide : 0;
      const std::int64_t y = (v & 2U) != 0 ? kSide : 0;
      p[v] = {x, y, x + y + ((v & 4U) != 0 ? height : 0)};
    }
    EXPECT_FALSE(exact::filtered_jacobian_verdict(scaled(p, 0)).has_value());
    const auto verdict = exact::exact_jacobian_verdict(scaled(p, 0), 4);
    EXPECT_EQ(verdict.positivity, height > 0 ? Positivity::positive : Positivity::not_positive);
    EXPECT_EQ(verdict.corner_not_positive, height <= 0);
  }
}

TEST(Jacobian, RefusesBadArguments) {
  Hexahedron h{};
  EXPECT_THROW((void)exact::exact_jacobian_verdict(h, -1), core::PreconditionViolated);
  EXPECT_THROW((void)exact::exact_jacobian_verdict(h, exact::kMaxSubdivisionDepth + 1),
               core::PreconditionViolated);
  h[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)exact::filtered_jacobian_verdict(h), core::PreconditionViolated);
  EXPECT_THROW((void)exact::exact_jacobian_verdict(h, 4), core::PreconditionViolated);
  EXPECT_THROW((void)exact::signs_of_jacobian_coefficients(h), core::PreconditionViolated);
}

}  // namespace
