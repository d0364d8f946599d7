#pragma once
/// \file
/// Differences of points that share a power of two by which all coordinates are integers of fixed
/// width. Private to realize/exact.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "realize/exact/binary.hpp"
#include "realize/exact/limbs.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// All points but the first, minus the first, times a power of two: below 2^(64 kLimbs - 2) in
/// absolute value, since the coordinates are below half of that.
template <std::size_t kLimbs, std::size_t kCount>
using LimbDifferences = std::array<Vector3<Limbs<kLimbs>>, kCount - 1>;

/// An integer k > -1022 with |c| < 2^k for all coordinates; 1025 if one of them is not finite.
template <std::size_t kCount>
[[nodiscard]] int exponent_above(const std::array<Point3, kCount>& points) noexcept {
  constexpr std::uint64_t kMagnitude = ~std::uint64_t{0} >> 1U;
  constexpr int kFractionBits = std::numeric_limits<double>::digits - 1;
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  std::uint64_t z = 0;
  for (const Point3& p : points) {
    x = std::max(x, std::bit_cast<std::uint64_t>(p.x) & kMagnitude);
    y = std::max(y, std::bit_cast<std::uint64_t>(p.y) & kMagnitude);
    z = std::max(z, std::bit_cast<std::uint64_t>(p.z) & kMagnitude);
  }
  const std::uint64_t greatest = std::max({x, y, z});
  return static_cast<int>(greatest >> kFractionBits) + std::numeric_limits<double>::min_exponent -
         1;
}

/// nullopt if the coordinates are not multiples below 2^61 of one power of two, or if one is not
/// finite. Not promised: an answer if all are below 2^-900.
template <std::size_t kCount>
[[nodiscard]] std::optional<LimbDifferences<1, kCount>> one_limb_differences(
    const std::array<Point3, kCount>& points) noexcept {
  constexpr int kBits = 61;
  const int top = exponent_above(points);
  if (top < -900 || top > std::numeric_limits<double>::max_exponent) return std::nullopt;
  const double scale = power_of_two(kBits - top);
  const double unit = power_of_two(top - kBits);
  std::array<std::array<std::int64_t, 3>, kCount> integers{};
  std::uint64_t changed = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::array<double, 3> from{points[i].x, points[i].y, points[i].z};
    for (std::size_t k = 0; k < 3; ++k) {
      integers[i][k] = static_cast<std::int64_t>(from[k] * scale);
      const double back = static_cast<double>(integers[i][k]) * unit;
      changed |= std::bit_cast<std::uint64_t>(back) ^ std::bit_cast<std::uint64_t>(from[k]);
    }
  }
  if (changed << 1U != 0) return std::nullopt;  // a sign differs for -0 only
  LimbDifferences<1, kCount> result{};
  for (std::size_t i = 1; i < kCount; ++i) {
    const auto entry = [&](std::size_t k) -> Limbs<1> {
      return {{static_cast<std::uint64_t>(integers[i][k] - integers[0][k])}};
    };
    result[i - 1] = {entry(0), entry(1), entry(2)};
  }
  return result;
}

/// nullopt if the coordinates are not multiples below 2^125 of one power of two.
/// Requires. Finite coordinates; not checked.
template <std::size_t kCount>
[[nodiscard]] std::optional<LimbDifferences<2, kCount>> two_limb_differences(
    const std::array<Point3, kCount>& points) noexcept {
  constexpr int kBits = 125;
  std::array<std::array<BinaryParts, 3>, kCount> parts{};
  int unit = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < kCount; ++i) {
    parts[i] = {binary_parts(points[i].x), binary_parts(points[i].y), binary_parts(points[i].z)};
    for (const BinaryParts& part : parts[i])
      if (part.mantissa != 0) unit = std::min(unit, part.exponent);
  }
  if (unit < exponent_above(points) - kBits) return std::nullopt;
  const auto scaled = [&](const BinaryParts& part) -> Limbs<2> {
    if (part.mantissa == 0) return {};
    Limbs<2> result{};
    result.set_pair(0, static_cast<UnsignedWide>(Wide{part.mantissa}) << (part.exponent - unit));
    return result;
  };
  LimbDifferences<2, kCount> result{};
  for (std::size_t i = 1; i < kCount; ++i)
    result[i - 1] = {scaled(parts[i][0]) - scaled(parts[0][0]),
                     scaled(parts[i][1]) - scaled(parts[0][1]),
                     scaled(parts[i][2]) - scaled(parts[0][2])};
  return result;
}

}  // namespace hexatlas::exact
