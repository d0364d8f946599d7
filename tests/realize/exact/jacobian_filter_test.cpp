// Claim. The filter for hexahedra proves what it says, decides what is clear, and gives the same
// verdicts one by one, in batches of any size, and by each implementation.
// Oracle. The signs of the coefficients in integers. For small integer corners double precision
// computes every sum without error, and the bound is below one: the filter must then decide
// exactly by these signs. Near the bound it may leave open, and must not contradict.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "realize/exact/jacobian.hpp"
#include "realize/exact/jacobian_lanes.hpp"
#include "tests/realize/exact/placed_cells.hpp"

namespace {

using namespace hexatlas;
using exact::Hexahedron;
using exact::JacobianVerdict;
using exact::Positivity;
using exact::Sign;
using placed_cells::scaled;

constexpr JacobianVerdict kPositive{Positivity::positive, false};
constexpr JacobianVerdict kInverted{Positivity::not_positive, true};

/// A cube of side `side`, its corners moved by whole numbers up to `shift`.
Hexahedron moved_cube(int side, int shift, std::mt19937_64& random) {
  std::uniform_int_distribution<int> move(-shift, shift);
  Hexahedron h{};
  for (std::size_t v = 0; v < 8; ++v) {
    const auto at = [&](std::size_t k) {
      return static_cast<double>(side * static_cast<int>(v >> k & 1U) + move(random));
    };
    h[v] = {at(0), at(1), at(2)};
  }
  return h;
}

bool all_positive(const std::array<Sign, 27>& signs) {
  return std::all_of(signs.begin(), signs.end(), [](Sign s) { return s == Sign::positive; });
}

bool some_corner(const std::array<Sign, 27>& signs, Sign sign) {
  const std::array<std::size_t, 8> corners{0, 2, 6, 8, 18, 20, 24, 26};
  return std::any_of(corners.begin(), corners.end(),
                     [&](std::size_t i) { return signs[i] == sign; });
}

std::optional<JacobianVerdict> expected(const Hexahedron& h) {
  const auto signs = exact::signs_of_jacobian_coefficients(h);
  if (all_positive(signs)) return kPositive;
  if (some_corner(signs, Sign::negative)) return kInverted;
  return std::nullopt;
}

TEST(JacobianFilter, DecidesSmallIntegersByTheirSigns) {
  std::mt19937_64 random(20261126);
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 5000; ++trial) {
    const Hexahedron h = moved_cube(5 + trial % 4, 1 + trial % 5, random);
    const auto verdict = expected(h);
    ASSERT_EQ(exact::filtered_jacobian_verdict(h), verdict);
    if (trial % 16 == 0) {
      for (const int exponent : {-296, 290})
        ASSERT_EQ(exact::filtered_jacobian_verdict(scaled(h, exponent)), verdict);
    }
    ++seen[verdict ? (*verdict == kPositive ? 0U : 1U) : 2U];
  }
  for (const int count : seen) EXPECT_GT(count, 60);
}

/// Sheared by factors of some 2^11 and scaled by an odd number above 2^16, a hexahedron keeps the
/// signs of its coefficients, and double precision rounds the determinants.
Hexahedron sheared(const Hexahedron& h, std::mt19937_64& random) {
  const auto factor = [&random] { return static_cast<double>(1000 + random() % 2000); };
  const double a = factor();
  const double b = factor();
  Hexahedron result = h;
  for (auto& p : result) {
    const double x = p.x + a * (p.y - p.z);
    const double y = p.y + b * p.z;
    p = {100003 * x, 100003 * y, 100003 * (p.z + x - y)};
  }
  return result;
}

/// One coefficient is not positive, all others are: at a corner, on an edge, in a facet. Found
/// among random hexahedra, where the one inside is never alone; the filter must not say `positive`,
/// rounded or not.
TEST(JacobianFilter, NoKindOfCoefficientIsOverlooked) {
  std::mt19937_64 random(20261127);
  std::array<int, 4> alone{};  // by the number of middle indices
  int decided = 0;
  for (int trial = 0; trial < 16000; ++trial) {
    const Hexahedron h = moved_cube(5 + trial % 4, 2 + trial % 4, random);
    const auto signs = exact::signs_of_jacobian_coefficients(h);
    if (all_positive(signs))
      decided += exact::filtered_jacobian_verdict(sheared(h, random)) == kPositive ? 1 : 0;
    if (std::count(signs.begin(), signs.end(), Sign::positive) != 26) continue;
    const auto at = static_cast<std::size_t>(
        std::find_if(signs.begin(), signs.end(), [](Sign s) { return s != Sign::positive; }) -
        signs.begin());
    ++alone[(at % 3 == 1 ? 1U : 0U) + (at / 3 % 3 == 1 ? 1U : 0U) + (at / 9 == 1 ? 1U : 0U)];
    ASSERT_NE(exact::filtered_jacobian_verdict(h), kPositive);
    for (int shear = 0; shear < 10; ++shear)
      ASSERT_NE(exact::filtered_jacobian_verdict(sheared(h, random)), kPositive);
  }
  for (const std::size_t kind : {0U, 1U, 2U}) EXPECT_GT(alone[kind], 5);
  EXPECT_GT(decided, 1000);
}

/// Heights of some 2^-53 to 2^-38 of the side, in a sheared frame: results near the bound.
TEST(JacobianFilter, NeverContradictsIntegers) {
  std::mt19937_64 random(20261128);
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 2000; ++trial) {
    const double side = std::ldexp(1.0, 30 + trial % 20);
    Hexahedron h{};
    for (std::size_t v = 0; v < 8; ++v) {
      const double x = (v & 1U) != 0 ? side : 0;
      const double y = (v & 2U) != 0 ? side : 0;
      const double noise = static_cast<double>(random() % 65) - 32;
      const double height = (v & 4U) != 0 ? static_cast<double>(trial % 5 * 10) : 0;
      h[v] = {x + noise / 4, y - noise / 8, x + y + height + noise / 2};
    }
    const auto verdict = exact::filtered_jacobian_verdict(h);
    const auto signs = exact::signs_of_jacobian_coefficients(h);
    if (verdict == kPositive) {
      ASSERT_TRUE(all_positive(signs));
    } else if (verdict) {
      ASSERT_EQ(*verdict, kInverted);
      ASSERT_TRUE(some_corner(signs, Sign::negative));
    }
    ++seen[verdict ? (*verdict == kPositive ? 0U : 1U) : 2U];
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

/// Subdivision in double precision: the verdict of the integers at the same depth, or none.
TEST(JacobianFilter, SubdivisionAgreesWithIntegers) {
  std::mt19937_64 random(20261132);
  std::array<int, 3> seen{};
  int open = 0;
  for (int trial = 0; trial < 1200; ++trial) {
    const Hexahedron h = moved_cube(6, 2 + trial % 4, random);
    for (const int depth : {0, 1, 3}) {
      const JacobianVerdict verdict = exact::exact_jacobian_verdict(h, depth);
      const int exponent = std::array{0, -280, 280}[trial % 3U];
      for (const Hexahedron& cell : {scaled(h, exponent), sheared(h, random)}) {
        const auto subdivided = exact::subdivided_jacobian_verdict(cell, depth);
        open += subdivided ? 0 : 1;
        if (subdivided) {
          ASSERT_EQ(*subdivided, verdict);
        }
      }
      ++seen[static_cast<std::size_t>(verdict.positivity)];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 20);
  EXPECT_LT(open, 1200);  // zeros, above all
}

/// Corners with scaled Jacobian 3/5, which no double is: the doubles beside it are told apart.
TEST(JacobianFilter, CornersExceedAThreshold) {
  std::mt19937_64 random(20261133);
  Hexahedron h = moved_cube(1, 0, random);
  for (auto& p : h) p = {p.x + 4 * p.z, p.y, 3 * p.z};
  const double below = 0.6;  // by 2e-17
  const double above = std::nextafter(below, 1);
  for (const int exponent : {0, -1074, 900}) {
    EXPECT_TRUE(exact::corners_exceed(scaled(h, exponent), below));
    EXPECT_FALSE(exact::corners_exceed(scaled(h, exponent), above));
  }
  EXPECT_TRUE(exact::corners_exceed(h, 0));
  Hexahedron half = moved_cube(2, 0, random);  // all edges at right angles but one corner
  half[7] = {2, 2, 4};                         // 1/2 there, exactly
  EXPECT_FALSE(exact::corners_exceed(half, 0.5));
  EXPECT_TRUE(exact::corners_exceed(half, std::nextafter(0.5, 0)));
  for (auto& p : h) p.z = -p.z;
  EXPECT_FALSE(exact::corners_exceed(h, 0));
  for (auto& p : h) p.z = 0;
  EXPECT_FALSE(exact::corners_exceed(h, 0));
  EXPECT_THROW((void)exact::corners_exceed(h, 1), core::PreconditionViolated);
}

std::vector<Hexahedron> all_sorts() {
  std::mt19937_64 random(20261129);
  std::vector<Hexahedron> result;
  for (int trial = 0; trial < 403; ++trial) {
    const int exponent = std::array{0, -400, 0, 1000, -310, 0, 290, -1074}[trial % 8U];
    result.push_back(scaled(moved_cube(6, 1 + trial % 4, random), exponent));
  }
  return result;
}

TEST(JacobianFilter, SameInBatchesOfAnySize) {
  const std::vector<Hexahedron> hexahedra = all_sorts();
  for (const std::size_t size : {0U, 1U, 2U, 3U, 4U, 5U, 7U, 8U, 403U}) {
    std::vector<std::optional<JacobianVerdict>> verdicts(size, kInverted);
    exact::filtered_jacobian_verdicts({hexahedra.data(), size}, verdicts);
    for (std::size_t i = 0; i < size; ++i)
      ASSERT_EQ(verdicts[i], exact::filtered_jacobian_verdict(hexahedra[i]));
  }
}

TEST(JacobianFilter, SameByEachImplementation) {
  std::vector<std::pair<std::string, exact::FourJacobians>> others{
      {"chosen", exact::four_jacobians()}};
#if defined(__x86_64__)
  if (exact::four_jacobians_avx2() != nullptr && __builtin_cpu_supports("avx2") != 0)
    others.emplace_back("avx2", exact::four_jacobians_avx2());
#endif
  const std::vector<Hexahedron> h = all_sorts();
  unsigned decided = 0;
  for (std::size_t i = 0; i + 3 < h.size(); ++i) {
    const auto plain = exact::four_jacobians_plain()(h[i].data(), h[i + 1].data(), h[i + 2].data(),
                                                     h[i + 3].data());
    decided |= plain.positive | plain.corner_negative << 4U;
    for (const auto& [name, function] : others) {
      const auto lanes = function(h[i].data(), h[i + 1].data(), h[i + 2].data(), h[i + 3].data());
      ASSERT_EQ(lanes.positive, plain.positive) << name;
      ASSERT_EQ(lanes.corner_negative, plain.corner_negative) << name;
      ASSERT_EQ(lanes.overflow, plain.overflow) << name;
    }
  }
  EXPECT_EQ(decided, 255U);
}

TEST(JacobianFilter, HugeTinyAndFlat) {
  std::mt19937_64 random(20261130);
  const Hexahedron cube = moved_cube(4, 0, random);
  EXPECT_EQ(exact::filtered_jacobian_verdict(cube), kPositive);
  for (const int exponent : {-1000, -303, 299, 1000, 1021})  // outside 2^-300 to 2^300
    EXPECT_FALSE(exact::filtered_jacobian_verdict(scaled(cube, exponent)).has_value());
  Hexahedron overflowing = cube;  // finite corners, infinite differences
  overflowing[0].x = -std::numeric_limits<double>::max();
  overflowing[1].x = std::numeric_limits<double>::max();
  EXPECT_FALSE(exact::filtered_jacobian_verdict(overflowing).has_value());
  EXPECT_FALSE(exact::filtered_jacobian_verdict(Hexahedron{}).has_value());
}

TEST(JacobianFilter, RefusesAnyCoordinateThatIsNotFinite) {
  std::mt19937_64 random(20261131);
  const std::vector<Hexahedron> cubes(6, moved_cube(4, 0, random));
  std::vector<std::optional<JacobianVerdict>> verdicts(6);
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    for (std::size_t i = 0; i < 6 * 24; ++i) {
      std::vector<Hexahedron> some = cubes;
      exact::Point3& p = some[i / 24][i % 8];
      (i / 8 % 3 == 0 ? p.x : i / 8 % 3 == 1 ? p.y : p.z) = wrong;
      EXPECT_THROW(exact::filtered_jacobian_verdicts(some, verdicts), core::PreconditionViolated);
    }
  EXPECT_THROW(exact::filtered_jacobian_verdicts(cubes, {verdicts.data(), 5}),
               core::PreconditionViolated);
}

}  // namespace
