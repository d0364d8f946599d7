#pragma once
/// \file
/// Private to meshing/delaunay: the part of a closed curve that belongs to one thread.

#include <cstdint>

#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// `length` keys from `first` on, round the circle of all keys from 0 to `last_key`, which is one
/// less than a power of two.
struct Region {
  std::uint64_t first = 0, length = 0, last_key = 0;
  [[nodiscard]] bool has(const Site& site) const noexcept { return excess(site) >> 63U != 0; }
  [[nodiscard]] bool has_all(const FourSites& sites) const noexcept {
    const auto& [a, b, c, d] = sites;
    return (excess(*a) & excess(*b) & excess(*c) & excess(*d)) >> 63U != 0;
  }

 private:
  /// How far beyond the end: the highest bit says negative, since keys have fewer bits.
  [[nodiscard]] std::uint64_t excess(const Site& site) const noexcept {
    return ((site.key - first) & last_key) - length;
  }
};

}  // namespace hexatlas::delaunay
