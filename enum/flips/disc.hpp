#pragma once
/// \file
/// Quadrangulations of a disc with few quads.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/front.hpp"

namespace hexatlas::flips {

/// Quads, counter-clockwise, of a disc whose boundary is the circle 0, 1, ..., length-1,
/// counter-clockwise; vertices from `length` on are interior.
using Disc = std::vector<complex::QuadVertices>;

/// All quadrangulations of the disc with labelled boundary in which no two edges have the same
/// ends: each one once, whatever the numbers of its interior vertices. Two quads may share two
/// edges. Some discs in which two edges have the same ends come as well. Each has length/2 - 1 +
/// interior quads. Requires an even length of at least 4. Cost: exponential in both; meant for
/// length + interior up to about 12.
[[nodiscard]] std::vector<Disc> discs(int length, int interior);

inline constexpr std::size_t kMaxDiscCircle = 10;
inline constexpr std::size_t kMaxDiscInterior = 8;
inline constexpr std::size_t kMaxDiscVertices = 16;

/// A pair of places on a circle of at most kMaxDiscCircle edges, as a bit.
[[nodiscard]] constexpr std::uint64_t pair_bit(std::size_t i, std::size_t j) noexcept {
  const std::size_t low = std::min(i, j), high = std::max(i, j);
  return std::uint64_t{1} << (high * (high - 1) / 2 + low);
}

/// A disc, with what shows at a glance that it does not fit.
struct MarkedDisc {
  Disc quads;
  VertexSet narrow = 0;      ///< the boundary vertices with one quad
  std::uint64_t chords = 0;  ///< the edges between boundary vertices, those of the circle left out
};

/// Of discs(length, interior) those in which each vertex inside has three quads: no boundary that
/// is 3-connected has another one. Made once for each pair of numbers. Requires at most
/// kMaxDiscCircle, kMaxDiscInterior, and kMaxDiscVertices in all. Safe to call from several
/// threads.
[[nodiscard]] const std::vector<MarkedDisc>& marked_discs(std::size_t length, std::size_t interior);

/// The disc where it is put: vertex i of its circle is rim[i], those inside are numbered from
/// `first_inside` on.
[[nodiscard]] Disc placed(Disc disc, std::span<const complex::Vertex> rim,
                          complex::Vertex first_inside);

}  // namespace hexatlas::flips
