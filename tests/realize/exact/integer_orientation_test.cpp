// Claim. The sign of the orientation of four integer points up to the bound is exact.
// Oracle. sign_of_orientation of doubles, which ends in integers of any length.
#include "realize/exact/integer_orientation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

#include "realize/exact/orientation.hpp"

namespace {

using namespace hexatlas;
using exact::IntegerPoint3;
using exact::Sign;

exact::Point3 as_doubles(const IntegerPoint3& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

TEST(IntegerOrientation, AgreesWithDoubles) {
  std::mt19937_64 random(20261121);
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 20000; ++trial) {
    const std::int64_t bound = trial % 4 == 0 ? exact::kIntegerPointBound : 1 + trial % 4;
    std::uniform_int_distribution<std::int64_t> coordinate(-bound, bound);
    std::array<IntegerPoint3, 4> p{};
    for (IntegerPoint3& point : p)
      for (std::int64_t& x : point) x = coordinate(random);
    const Sign sign = exact::sign_of_orientation(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(sign, exact::sign_of_orientation(as_doubles(p[0]), as_doubles(p[1]), as_doubles(p[2]),
                                               as_doubles(p[3])));
    ++seen[static_cast<std::size_t>(static_cast<int>(sign) + 1)];
  }
  for (const int count : seen) EXPECT_GT(count, 500);
}

/// Corners of the greatest cube, where products are as long as they can be.
TEST(IntegerOrientation, CornersOfTheRange) {
  constexpr std::int64_t kEnd = exact::kIntegerPointBound;
  std::array<IntegerPoint3, 8> corner{};
  for (std::size_t v = 0; v < 8; ++v)
    for (std::size_t k = 0; k < 3; ++k) corner[v][k] = (v >> k & 1U) != 0 ? kEnd : -kEnd;
  for (std::size_t i = 0; i < 4096; ++i) {
    const auto& [a, b, c, d] =
        std::array{corner[i & 7U], corner[i >> 3U & 7U], corner[i >> 6U & 7U], corner[i >> 9U]};
    ASSERT_EQ(
        exact::sign_of_orientation(a, b, c, d),
        exact::sign_of_orientation(as_doubles(a), as_doubles(b), as_doubles(c), as_doubles(d)));
  }
}

}  // namespace
