#pragma once
/// \file
/// Points scaled by a common power of two so that all coordinates are integers of fixed width,
/// where they are. Private to realize/exact.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "realize/exact/binary.hpp"
#include "realize/exact/limbs.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// The coordinates of points, taken apart. All are integers below 2^width times 2^unit_exponent.
template <std::size_t kCount>
class TakenApart {
 public:
  /// Requires. Finite coordinates; not checked.
  explicit TakenApart(const std::array<Point3, kCount>& points) noexcept {
    int top = std::numeric_limits<int>::min();
    for (std::size_t i = 0; i < kCount; ++i) {
      parts_[i] = {binary_parts(points[i].x), binary_parts(points[i].y), binary_parts(points[i].z)};
      for (const BinaryParts& part : parts_[i]) {
        if (part.mantissa == 0) continue;
        const auto magnitude =
            static_cast<std::uint64_t>(part.mantissa < 0 ? -part.mantissa : part.mantissa);
        top = std::max(top, part.exponent + static_cast<int>(std::bit_width(magnitude)));
        unit_exponent_ = std::min(unit_exponent_, part.exponent);
      }
    }
    if (top > unit_exponent_) width_ = top - unit_exponent_;
  }

  /// Whether the differences of the points are below 2^(64 kLimbs - 2).
  template <std::size_t kLimbs>
  [[nodiscard]] bool fits() const noexcept {
    return width_ <= static_cast<int>(64 * kLimbs) - 3;
  }

  /// The points minus the first one, times a power of two. Requires. fits<kLimbs>().
  template <std::size_t kLimbs>
  [[nodiscard]] std::array<Vector3<Limbs<kLimbs>>, kCount - 1> differences() const noexcept {
    std::array<Vector3<Limbs<kLimbs>>, kCount - 1> result{};
    const auto first = scaled<kLimbs>(parts_[0]);
    for (std::size_t i = 1; i < kCount; ++i)
      result[i - 1] = difference(scaled<kLimbs>(parts_[i]), first);
    return result;
  }

 private:
  template <std::size_t kLimbs>
  [[nodiscard]] Vector3<Limbs<kLimbs>> scaled(const std::array<BinaryParts, 3>& parts) const {
    return {scaled<kLimbs>(parts[0]), scaled<kLimbs>(parts[1]), scaled<kLimbs>(parts[2])};
  }
  template <std::size_t kLimbs>
  [[nodiscard]] Limbs<kLimbs> scaled(const BinaryParts& part) const noexcept {
    static_assert(kLimbs == 1 || kLimbs == 2);
    if (part.mantissa == 0) return {};
    const auto shift = static_cast<unsigned>(part.exponent - unit_exponent_);
    if constexpr (kLimbs == 1) {
      return {{static_cast<std::uint64_t>(part.mantissa) << shift}};
    } else {
      const auto value = static_cast<UnsignedWide>(Wide{part.mantissa}) << shift;
      return {{static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 64U)}};
    }
  }

  std::array<std::array<BinaryParts, 3>, kCount> parts_{};
  int unit_exponent_ = std::numeric_limits<int>::max();
  int width_ = 0;
};

}  // namespace hexatlas::exact
