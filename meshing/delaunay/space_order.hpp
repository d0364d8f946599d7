#pragma once
/// \file
/// Private to meshing/delaunay: the order in which points are inserted.
///
/// Definition. Points are dealt into rounds, each about eight times as large as the one before,
/// by a random choice that depends on their numbers and a seed only; within a round they follow a
/// curve (curves.hpp). So a point is near the one before it, and whatever the input is, each prefix
/// of rounds is a random sample. Source: N. Amenta, S. Choi, G. Rote, "Incremental constructions
/// con BRIO" (2003).
///
/// Cost: linear, some 100 ns per point.

#include <cstdint>
#include <span>
#include <vector>

#include "meshing/delaunay/curves.hpp"
#include "meshing/delaunay/page_allocator.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::delaunay {

struct Placed {
  std::uint64_t key;    ///< along the curve, the same scale for all rounds
  std::uint32_t point;  ///< its number in the input
};

using PlacedList = std::vector<Placed, PageAllocator<Placed>>;

struct SpaceOrder {
  PlacedList points;                ///< in the order of insertion
  std::vector<std::size_t> rounds;  ///< where each round begins, and at last the number of points
  Curves curves;                    ///< the keys are those of curve 0
};

/// By the lowest `bits` bits of the keys; equal ones stay in order. Requires threads >= 1.
void sort_by_key(PlacedList& points, unsigned bits, int threads);

/// Requires finite coordinates, threads >= 1. The same for any number of threads.
[[nodiscard]] SpaceOrder space_order(std::span<const mesh::Point> points, std::uint64_t seed,
                                     int threads);

}  // namespace hexatlas::delaunay
