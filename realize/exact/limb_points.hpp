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
/// absolute value.
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

/// The fast way: nullopt if the coordinates are not multiples below 2^61 of one power of two, or if
/// one is not finite. Not promised: an answer if all are below 2^-900.
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

/// The coordinates of points, taken apart.
template <std::size_t kCount>
class TakenApart {
 public:
  /// The exponent of the unit is at most that given. Requires. Finite coordinates; not checked.
  explicit TakenApart(const std::array<Point3, kCount>& points,
                      int greatest_unit = std::numeric_limits<int>::max()) noexcept
      : unit_(greatest_unit) {
    std::array<Point3, kCount> differences{};
    for (std::size_t i = 0; i < kCount; ++i) {
      const Point3& p = points[i];
      parts_[i] = {binary_parts(p.x), binary_parts(p.y), binary_parts(p.z)};
      for (const BinaryParts& part : parts_[i])
        if (part.mantissa != 0) unit_ = std::min(unit_, part.exponent);
      differences[i] = {p.x - points[0].x, p.y - points[0].y, p.z - points[0].z};
    }
    top_ = exponent_above(differences);  // bounds the real ones too, since rounding is monotone
  }

  /// The exponent of a power of two of which all coordinates are multiples, of the greatest one if
  /// the limit allows.
  [[nodiscard]] int unit() const noexcept { return unit_; }

  /// nullopt if the result does not fit. Coordinates that do not fit by themselves wrap around.
  template <std::size_t kLimbs>
  [[nodiscard]] std::optional<LimbDifferences<kLimbs, kCount>> differences() const noexcept {
    if (unit_ < top_ - static_cast<int>(64 * kLimbs - 2)) return std::nullopt;
    LimbDifferences<kLimbs, kCount> result{};
    for (std::size_t i = 1; i < kCount; ++i) {
      const auto entry = [&](std::size_t k) {
        return scaled<kLimbs>(parts_[i][k]) - scaled<kLimbs>(parts_[0][k]);
      };
      result[i - 1] = {entry(0), entry(1), entry(2)};
    }
    return result;
  }

 private:
  template <std::size_t kLimbs>
  [[nodiscard]] Limbs<kLimbs> scaled(const BinaryParts& part) const noexcept {
    static_assert(kLimbs == 1 || kLimbs == 2);
    const int shift = part.exponent - unit_;
    Limbs<kLimbs> result{};
    if (part.mantissa == 0 || shift >= static_cast<int>(64 * kLimbs)) return result;
    if constexpr (kLimbs == 1)
      result.limb[0] = static_cast<std::uint64_t>(part.mantissa) << shift;
    else
      result.set_pair(0, static_cast<UnsignedWide>(Wide{part.mantissa}) << shift);
    return result;
  }

  std::array<std::array<BinaryParts, 3>, kCount> parts_{};
  int unit_;
  int top_ = 0;
};

}  // namespace hexatlas::exact
