#pragma once
/// \file
/// Private to meshing/delaunay: a power of two of which all coordinates are multiples.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// The value of the lowest bit that is set; infinite for zero. Requires a finite value.
[[nodiscard]] inline double lowest_bit(double value) noexcept {
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52U) - 1;
  if (value == 0) return std::numeric_limits<double>::infinity();
  const auto bits = std::bit_cast<std::uint64_t>(value);
  // Without a fraction it is a power of two itself.
  return std::abs((bits & kFraction) == 0 ? value
                                          : value - std::bit_cast<double>(bits & (bits - 1)));
}

/// The greatest such power, of all sites that were included.
class CommonUnit {
 public:
  void include(const Site& site) noexcept {
    unit_ = std::min({unit_, lowest_bit(site.x), lowest_bit(site.y), lowest_bit(site.z)});
  }
  void include(const CommonUnit& other) noexcept { unit_ = std::min(unit_, other.unit_); }

  /// For FourFacets::conflict().
  [[nodiscard]] double short_below() const noexcept {
    return unit_ >= 0x1p-180 && unit_ <= 0x1p180 ? 0x1p19 * unit_ * unit_ : -1;
  }

 private:
  double unit_ = std::numeric_limits<double>::infinity();
};

}  // namespace hexatlas::delaunay
