// Claim. sign_of_orientation() is exact for any finite doubles, and the filter is never wrong.
// Oracle. Points with integer coordinates below 2^54, times a power of two: the determinant by
// Leibniz' formula over integers written in base 2^27 with 128-bit digits. Symmetry: exchanging
// two points changes the sign.
#include "realize/exact/orientation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "enum/core/errors.hpp"
#include "tests/realize/exact/sign_trials.hpp"

namespace {

using namespace hexatlas;
using exact::Point3;
using exact::Sign;
using sign_trials::Tally;

__extension__ using Wide = __int128;
using IntegerPoint = std::array<std::int64_t, 3>;
using IntegerTetrahedron = std::array<IntegerPoint, 4>;

constexpr std::int64_t kBase = std::int64_t{1} << 27;

/// The sign of d0 + d1 B + d2 B^2 + d3 B^3, B = 2^27, with any 128-bit digits.
Sign sign_of_digits(std::array<Wide, 4> digits) {
  bool rest_is_zero = true;
  for (std::size_t i = 0; i < 3; ++i) {
    Wide remainder = digits[i] % kBase;
    if (remainder < 0) remainder += kBase;
    digits[i + 1] += (digits[i] - remainder) / kBase;
    rest_is_zero = rest_is_zero && remainder == 0;
  }
  if (digits[3] != 0) return digits[3] > 0 ? Sign::positive : Sign::negative;
  return rest_is_zero ? Sign::zero : Sign::positive;
}

Sign oracle(const IntegerTetrahedron& p) {
  constexpr std::array<std::array<std::size_t, 3>, 6> kPermutations{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  std::array<Wide, 4> digits{};
  for (std::size_t term = 0; term < 6; ++term)
    for (unsigned choice = 0; choice < 8; ++choice) {
      Wide product = term < 3 ? 1 : -1;
      for (std::size_t row = 0; row < 3; ++row) {
        const std::int64_t entry =
            p[row + 1][kPermutations[term][row]] - p[0][kPermutations[term][row]];
        product *= (choice >> row & 1U) != 0 ? entry / kBase : entry % kBase;
      }
      digits[static_cast<std::size_t>(__builtin_popcount(choice))] += product;
    }
  return sign_of_digits(digits);
}

Point3 scaled(const IntegerPoint& p, int exponent) {
  return {std::ldexp(static_cast<double>(p[0]), exponent),
          std::ldexp(static_cast<double>(p[1]), exponent),
          std::ldexp(static_cast<double>(p[2]), exponent)};
}

void check(const IntegerTetrahedron& p, int exponent, Tally& tally) {
  const Sign expected = oracle(p);
  std::array<Point3, 4> q{};
  for (std::size_t i = 0; i < 4; ++i) q[i] = scaled(p[i], exponent);
  ASSERT_EQ(exact::sign_of_orientation(q[0], q[1], q[2], q[3]), expected);
  ASSERT_EQ(exact::sign_of_orientation(q[1], q[0], q[2], q[3]), exact::opposite(expected));
  add(expected, exact::filtered_sign_of_orientation(q[0], q[1], q[2], q[3]), tally);
}

TEST(Orientation, OfTheUnitTetrahedronIsPositive) {
  EXPECT_EQ(exact::sign_of_orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::positive);
}

TEST(Orientation, SmallGridsAtEveryScale) {
  std::mt19937_64 random(20261101);
  Tally tally;
  for (const int exponent :
       {0, -1074, -1000, -700, -361, -360, -359, -358, -357, -356, -340, -300, 300, 700, 1018})
    for (int trial = 0; trial < 4000; ++trial) {
      IntegerTetrahedron p{};
      const auto size = static_cast<std::int64_t>(2 + random() % 6);
      for (auto& point : p)
        for (auto& c : point)
          c = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(size)) - size / 2;
      check(p, exponent, tally);
    }
  EXPECT_GT(tally.zero, 1000);
  EXPECT_GT(tally.negative, 1000);
  EXPECT_GT(tally.positive, 1000);
}

/// d is a + b - c up to a few units in the last place: coplanar, or nearly so.
TEST(Orientation, PerturbedByUlps) {
  std::mt19937_64 random(20261102);
  Tally tally;
  constexpr std::int64_t kFirst = std::int64_t{1} << 52;  // 53 bits: the ulp is 1
  for (int trial = 0; trial < 40000; ++trial) {
    IntegerTetrahedron p{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        p[i][k] = kFirst + kFirst / 3 + static_cast<std::int64_t>(random() >> 14U) / 4;
      p[3][k] = p[0][k] + p[1][k] - p[2][k] + static_cast<std::int64_t>(random() % 3) - 1;
      ASSERT_LE(p[3][k], 2 * kFirst);
      ASSERT_GE(p[3][k], kFirst);
    }
    check(p, trial % 2 == 0 ? -53 : 0, tally);
  }
  EXPECT_GT(tally.zero, 500);
  EXPECT_GT(tally.negative, 10000);
  EXPECT_GT(tally.positive, 10000);
  EXPECT_GT(tally.left_by_filter, 20000);
}

TEST(Orientation, FilterDecidesWellShapedTetrahedra) {
  std::mt19937_64 random(20261103);
  Tally tally;
  for (int trial = 0; trial < 10000; ++trial) {
    IntegerTetrahedron p{};
    for (auto& point : p)
      for (auto& c : point) c = static_cast<std::int64_t>(random() >> 11U);
    check(p, -53, tally);
  }
  EXPECT_LT(tally.left_by_filter, 5);
}

TEST(Orientation, MixedMagnitudes) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = std::numeric_limits<double>::max();
  EXPECT_EQ(exact::sign_of_orientation({0, 0, 0}, {greatest, 0, 0}, {0, least, 0}, {0, 0, least}),
            Sign::positive);
  EXPECT_EQ(exact::sign_of_orientation({-greatest, 0, 0}, {greatest, 0, 0}, {0, greatest, 0},
                                       {0, 0, greatest}),
            Sign::positive);
  // Leaves the plane x + y + z = 1 by the least double.
  EXPECT_EQ(exact::sign_of_orientation({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, least}),
            Sign::positive);
  EXPECT_EQ(exact::sign_of_orientation({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, -least}),
            Sign::negative);
}

TEST(Orientation, RefusesCoordinatesThatAreNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {infinity, -infinity, nan})
    EXPECT_THROW((void)exact::sign_of_orientation({0, 0, 0}, {1, 0, 0}, {0, bad, 0}, {0, 0, 1}),
                 core::PreconditionViolated);
}

}  // namespace
