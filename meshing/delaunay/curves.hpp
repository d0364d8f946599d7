#pragma once
/// \file
/// Private to meshing/delaunay: places along space-filling curves.
///
/// Definition. A Moore curve: a closed curve of eight Hilbert curves through the cells of a cube.
/// Source: C. Hamilton, A. Rau-Chaplin, "Compact Hilbert indices" (2008).

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::delaunay {

/// Curves through a cube with 2^levels cells along each axis, around some points: curve 0 fills it,
/// the others fill one of twice its size that has it elsewhere inside, so that arcs of different
/// ones have different borders.
class Curves {
 public:
  Curves() = default;
  /// at(item) is the point of an item. Requires an item, finite coordinates, 1 <= levels <= 20.
  template <class Item, class At>
  Curves(std::span<const Item> items, At&& at, unsigned levels) : levels_(levels) {
    mesh::Point high = low_ = at(items.front());
    for (const Item& item : items) {
      const mesh::Point& p = at(item);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    width_ = std::max({half(high.x, low_.x), half(high.y, low_.y), half(high.z, low_.z)});
    if (width_ == 0) width_ = 1;
  }

  /// Where a point, one of those it was made around, lies on a curve: below 2^key_bits(curve).
  [[nodiscard]] std::uint64_t key_of(const mesh::Point& p, unsigned curve = 0) const;
  [[nodiscard]] unsigned key_bits(unsigned curve = 0) const noexcept {
    return 3 * (levels_ + (curve == 0 ? 0 : 1));
  }

 private:
  /// Half of the difference, so that it is finite.
  [[nodiscard]] static double half(double to, double from) { return to / 2 - from / 2; }
  [[nodiscard]] std::uint32_t cell(double value, double low) const {
    const std::uint32_t cells = 1U << levels_;
    return std::min(cells - 1, static_cast<std::uint32_t>(half(value, low) / width_ * cells));
  }

  unsigned levels_ = 0;
  mesh::Point low_{};
  double width_ = 1;
};

}  // namespace hexatlas::delaunay
