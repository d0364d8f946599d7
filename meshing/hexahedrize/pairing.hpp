#pragma once
/// \file
/// The quads of a sphere, two by two.
///
/// Claim. A quadrangulation of the sphere without multiple edges, with an even number of quads, can
/// be divided into pairs of quads that share an edge: its dual graph is 4-regular and has no edge
/// cut of fewer than three edges, so it has a perfect matching (Petersen's theorem as sharpened by
/// F. Baebler, 1937; docs/theory/proofs/linear-bound.md, section 2).
///
/// Method. Maximum matching by augmenting paths, J. Edmonds, "Paths, trees, and flowers" (1965).

#include <array>
#include <cstdint>
#include <vector>

#include "enum/complex/quad_surface.hpp"

namespace hexatlas::hexahedrize {

/// What lies at side s of a quad, which runs from its vertex s to the next one.
struct Side {
  std::uint32_t quad = 0;  ///< the other quad there
  std::uint32_t edge = 0;  ///< edges are numbered from 0, 2n of n quads
};
using Sides = std::vector<std::array<Side, 4>>;

/// The sides of all quads of a sphere without multiple edges. Cost: O(n log n).
[[nodiscard]] Sides sides_of(const complex::QuadSphere& sphere);

/// The partner of each quad. Requires an even number of quads, 3-connected.
/// Cost: seconds for 100,000 quads, growing with the square for much larger ones; usually less.
[[nodiscard]] std::vector<std::uint32_t> partners(const Sides& sides);

}  // namespace hexatlas::hexahedrize
