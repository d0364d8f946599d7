#pragma once
/// \file
/// Quadrangulated surfaces of any size, as a mesher receives them: lists of quads over points
/// that need not all be used, in any orientation. Here they are found to be spheres, or told
/// why not, and found to be 3-connected, or told why not.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "enum/complex/broken_law.hpp"
#include "enum/complex/hex_complex.hpp"

namespace hexatlas::complex {

/// A sphere: quads oriented coherently over vertices that are all used.
struct QuadSphere {
  std::vector<BoundaryQuad> quads;  ///< over 0 .. vertices-1, in the order given
  std::vector<VertexId> point_of;   ///< given point of each vertex, ascending
  std::size_t reversed = 0;         ///< quads turned over to agree with the majority
  std::size_t unused_points = 0;
  [[nodiscard]] std::size_t vertices() const noexcept { return point_of.size(); }
};

/// The sphere, or the first broken law of: at least one quad; four distinct vertices in each; each
/// edge in exactly two quads; the link of each vertex a circle; connected; orientable; Euler
/// characteristic 2. Quads that disagree with the majority in orientation are turned over; a tie
/// goes to the first quad. Requires indices below `points`. Cost: O(n log n).
[[nodiscard]] std::variant<QuadSphere, BrokenLaw> sphere_of(std::span<const BoundaryQuad> quads,
                                                            std::size_t points);

/// Why no hexahedral mesh under the strict rule can have this boundary, in one sentence, or
/// nullopt if no reason is known: an odd number of quads, fewer than 6, or not 3-connected.
/// Proofs: docs/theory/proofs/parity.md, three-connected.md. Vertices are named as given points,
/// from 0.
[[nodiscard]] std::optional<std::string> reason_against_filling(const QuadSphere& sphere);

}  // namespace hexatlas::complex
