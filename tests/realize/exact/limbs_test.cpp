// Claim. Sums, differences, products and signs of integers of fixed width are right modulo their
// width, and doubles are taken apart without loss.
// Oracle. GMP.
#include "realize/exact/limbs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>

#include "realize/exact/binary.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/limb_points.hpp"

namespace {

using namespace hexatlas;
using exact::Limbs;
using exact::Point3;
using exact::Sign;

template <std::size_t kLimbs>
mpz_class value(const Limbs<kLimbs>& limbs) {
  mpz_class result = 0;
  for (std::size_t i = kLimbs; i-- > 0;)
    result = (result << 64U) + mpz_class(static_cast<unsigned long>(limbs.limb[i]));
  if (limbs.limb[kLimbs - 1] >= std::uint64_t{1} << 63U)
    result -= mpz_class(1) << static_cast<unsigned>(64 * kLimbs);
  return result;
}

/// The number in [-2^(64 k - 1), 2^(64 k - 1)) that is congruent.
mpz_class wrapped(const mpz_class& number, std::size_t limbs) {
  const mpz_class modulus = mpz_class(1) << static_cast<unsigned>(64 * limbs);
  mpz_class result;
  mpz_fdiv_r(result.get_mpz_t(), number.get_mpz_t(), modulus.get_mpz_t());
  return 2 * result >= modulus ? mpz_class(result - modulus) : result;
}

/// Limbs that make carries run: zeros, ones, the ends of both, and random ones.
template <std::size_t kLimbs>
Limbs<kLimbs> random_limbs(std::mt19937_64& random) {
  Limbs<kLimbs> result{};
  for (std::uint64_t& limb : result.limb) {
    const std::uint64_t r = random();
    switch (random() % 6) {
      case 0:
        limb = 0;
        break;
      case 1:
        limb = ~std::uint64_t{0};
        break;
      case 2:
        limb = r % 2;
        break;
      case 3:
        limb = ~(r % 2);
        break;
      case 4:
        limb = std::uint64_t{1} << 63U;
        break;
      default:
        limb = r;
    }
  }
  return result;
}

template <std::size_t kLimbs>
void check_sums(std::mt19937_64& random) {
  for (int trial = 0; trial < 10000; ++trial) {
    const auto a = random_limbs<kLimbs>(random);
    const auto b = trial % 10 == 0 ? a : random_limbs<kLimbs>(random);
    ASSERT_EQ(value(a + b), wrapped(value(a) + value(b), kLimbs));
    ASSERT_EQ(value(a - b), wrapped(value(a) - value(b), kLimbs));
    ASSERT_EQ(exact::sign_of(a), static_cast<Sign>(sgn(value(a))));
    ASSERT_EQ(exact::sign_of(a - a), Sign::zero);
  }
}

template <std::size_t kA, std::size_t kB>
void check_products(std::mt19937_64& random) {
  for (int trial = 0; trial < 10000; ++trial) {
    const auto a = random_limbs<kA>(random);
    const auto b = random_limbs<kB>(random);
    ASSERT_EQ(value(a * b), value(a) * value(b));
    ASSERT_EQ(value(b * a), value(a) * value(b));
  }
}

TEST(Limbs, SumsAndDifferences) {
  std::mt19937_64 random(20261215);
  check_sums<1>(random);
  check_sums<2>(random);
  check_sums<3>(random);
  check_sums<4>(random);
  check_sums<5>(random);
  check_sums<6>(random);
  check_sums<10>(random);
}

TEST(Limbs, Products) {
  std::mt19937_64 random(20261216);
  check_products<1, 1>(random);
  check_products<1, 2>(random);
  check_products<2, 2>(random);
  check_products<2, 3>(random);
  check_products<2, 4>(random);
  check_products<4, 6>(random);
}

TEST(BinaryParts, AreOddAndLoseNothing) {
  std::mt19937_64 random(20261217);
  for (int trial = 0; trial < 100000; ++trial) {
    const double c =
        std::ldexp(static_cast<double>(random() >> (11U + random() % 53U)) * (trial % 2 ? 1 : -1),
                   static_cast<int>(random() % 2000) - 1100);
    if (!std::isfinite(c)) continue;
    const exact::BinaryParts parts = exact::binary_parts(c);
    ASSERT_EQ(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent), c);
    ASSERT_TRUE(c == 0 || parts.mantissa % 2 != 0);
    ASSERT_LT(std::abs(parts.mantissa), std::int64_t{1} << 53);
  }
  for (int exponent = -1022; exponent <= 1023; ++exponent)
    ASSERT_EQ(exact::power_of_two(exponent), std::ldexp(1.0, exponent));
}

/// Whatever way is taken, ratios of the integers are those of the differences.
template <std::size_t kLimbs, class Differences>
void check_differences(const std::array<Point3, 3>& p, const Differences& found, int& answers) {
  if (!found) return;
  ++answers;
  std::array<mpq_class, 6> real{
      mpq_class(p[1].x) - mpq_class(p[0].x), mpq_class(p[1].y) - mpq_class(p[0].y),
      mpq_class(p[1].z) - mpq_class(p[0].z), mpq_class(p[2].x) - mpq_class(p[0].x),
      mpq_class(p[2].y) - mpq_class(p[0].y), mpq_class(p[2].z) - mpq_class(p[0].z)};
  const std::array<mpz_class, 6> integers{value((*found)[0].x), value((*found)[0].y),
                                          value((*found)[0].z), value((*found)[1].x),
                                          value((*found)[1].y), value((*found)[1].z)};
  const mpz_class limit = mpz_class(1) << static_cast<unsigned>(64 * kLimbs - 2);
  for (std::size_t i = 0; i < 6; ++i) {
    ASSERT_LT(abs(integers[i]), limit);
    ASSERT_EQ(sgn(integers[i]), sgn(real[i]));
    for (std::size_t j = 0; j < i; ++j) ASSERT_EQ(real[i] * integers[j], real[j] * integers[i]);
  }
}

TEST(LimbPoints, AreTheDifferencesTimesAPowerOfTwo) {
  std::mt19937_64 random(20261218);
  int fast = 0;
  int one = 0;
  int two = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto spread = 1 + random() % (trial % 2 == 0 ? 12 : 120);
    const int base = trial % 3 == 0 ? -1074 : trial % 3 == 1 ? 800 : -30;
    const unsigned lost = 11 + static_cast<unsigned>(random() % 53);
    const double offset = std::ldexp(1.0, base + static_cast<int>(random() % 140));
    const auto coordinate = [&](bool is_far) {
      return std::ldexp(static_cast<double>(random() >> lost),
                        base + static_cast<int>(random() % spread)) *
                 (random() % 2 == 0 ? 1 : -1) +
             (is_far ? offset : 0);
    };
    std::array<Point3, 3> p;
    for (Point3& q : p) q = {coordinate(true), coordinate(false), coordinate(false)};
    const exact::TakenApart apart(p);
    check_differences<1>(p, exact::one_limb_differences(p), fast);
    check_differences<1>(p, apart.differences<1>(), one);
    check_differences<2>(p, apart.differences<2>(), two);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(fast, 2000);
  EXPECT_GT(one, fast / 2);
  EXPECT_GT(two, one);
  EXPECT_LT(two, 20000);
}

TEST(LimbPoints, FastWayRefusesWhatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(exact::one_limb_differences<2>({{{0, 0, 0}, {1, bad, 0}}}));
}

}  // namespace
