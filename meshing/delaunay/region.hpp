#pragma once
/// \file
/// Private to meshing/delaunay: the part of a closed curve that belongs to one thread.

#include <cstdint>
#include <utility>

#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

/// `length` keys from `first` on, round the circle of all keys from 0 to `last_key`, which is one
/// less than a power of two; of greater keys the bits above do not count.
struct Region {
  std::uint64_t first = 0, length = 0, last_key = 0;
  [[nodiscard]] bool has(const Site& site) const noexcept { return excess(site) >> 63U != 0; }
  [[nodiscard]] bool has_all(const FourSites& sites) const noexcept {
    const auto& [a, b, c, d] = sites;
    return (excess(*a) & excess(*b) & excess(*c) & excess(*d)) >> 63U != 0;
  }
  /// The keys before and from the given one on, which is one of them.
  [[nodiscard]] std::pair<Region, Region> cut_at(std::uint64_t key) const noexcept {
    const std::uint64_t before = (key - first) & last_key;
    return {{first, before, last_key}, {key, length - before, last_key}};
  }
  /// Whether the other one begins where this one ends.
  [[nodiscard]] bool is_before(const Region& other) const noexcept {
    return ((first + length) & last_key) == other.first;
  }
  /// Requires that it is_before() the other one.
  [[nodiscard]] Region joined(const Region& other) const noexcept {
    return {first, length + other.length, last_key};
  }

 private:
  /// How far beyond the end: the highest bit says negative, since keys have fewer bits.
  [[nodiscard]] std::uint64_t excess(const Site& site) const noexcept {
    return ((site.key - first) & last_key) - length;
  }
};

}  // namespace hexatlas::delaunay
