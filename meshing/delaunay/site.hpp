#pragma once
/// \file
/// Private to meshing/delaunay: a point of the triangulation, one half of a cache line.

#include <array>
#include <cstdint>

#include "realize/exact/sign.hpp"

namespace hexatlas::delaunay {

struct alignas(32) Site {
  double x = 0, y = 0, z = 0;
  std::uint64_t key = 0;  ///< where it lies on the space-filling curve

  [[nodiscard]] exact::Point3 point() const noexcept { return {x, y, z}; }
  [[nodiscard]] bool is_at(const Site& other) const noexcept {
    return x == other.x && y == other.y && z == other.z;
  }
};

using FourSites = std::array<const Site*, 4>;

}  // namespace hexatlas::delaunay
