#pragma once
/// \file
/// A ball of hexahedra inside a mesh exchanged for a ball of a beam with the same boundary.

#include <algorithm>
#include <cstdint>
#include <span>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {

/// Quads of the boundaries that a sub-ball passes while it grows, at most: wider ones than the
/// beam's lie on the way to many that it knows.
[[nodiscard]] inline int widest_on_the_way(const Beam& balls) noexcept {
  return std::max(kMaxSearchQuads, balls.options().max_quads);
}

/// A ball of the beam in place of a sub-ball, and how it is turned.
struct Fit {
  FrontId ball;
  canon::Labelling label{};  ///< canonical label of each boundary vertex of the sub-ball
  bool is_mirrored = false;
};

/// The mesh with a ball in place of the hexahedra `taken_out`; vertices not numbered without gaps
/// yet. `rim[v]`: the mesh vertex of canonical boundary vertex v of the ball, whose layers these
/// are and which grew from the single hexahedron; `is_mirrored`: as of append_ball().
[[nodiscard]] complex::HexComplex exchanged(const complex::HexComplex& mesh,
                                            std::span<const std::uint32_t> taken_out,
                                            const Layers& layers,
                                            std::span<const complex::VertexId> rim,
                                            bool is_mirrored);

/// The mesh with the sub-ball exchanged; vertices not numbered without gaps yet. `layers`: those of
/// the ball of `found`, which must have grown from the single hexahedron. Requires that the
/// boundaries are the same under the label.
/// Not promised: the strict rule, which scars decide (docs/theory/proofs/front.md, section 5).
[[nodiscard]] complex::HexComplex exchanged(const complex::HexComplex& mesh, const SubBall& ball,
                                            const Layers& layers, const Fit& found);

}  // namespace hexatlas::flips
