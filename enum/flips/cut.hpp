#pragma once
/// \file
/// Meshes of a boundary put together from two balls that share a disc.
///
/// A *cut* of a boundary Q is a disc of new quads and interior vertices, spanned inside by a circle
/// of edges of Q. It makes of Q the boundaries of two balls: each consists of one side of the
/// circle and the disc. If both are known, their union is a mesh of Q, and obeys the strict rule
/// if and only if no pair of vertices of the disc that lies in no quad of it is related in both
/// (docs/theory/proofs/front.md, section 7).
///
/// The union need not have a shelling with short boundaries: cuts reach what flips do not, such as
/// boundaries around two vertices of high degree.

#include <cstddef>
#include <optional>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/meeting.hpp"

namespace hexatlas::flips {

struct CutOptions {
  int max_circle = 8;     ///< edges of the circle, at most 10
  int max_interior = 4;   ///< vertices inside the disc, at most 8, and 16 with those of the circle
  int max_quads = 24;     ///< of the boundaries of the two balls, at most kMaxStateQuads
  int below = 1 << 14;    ///< only meshes with fewer hexahedra are of interest
  std::size_t count = 1;  ///< of meshes asked for
};

/// Meshes of `target` that are unions of two balls of `balls` along a disc within the limits: of
/// each disc the least one, of these the least, in order of hexahedra. Vertices 0 .. quads+1 are
/// those of the boundary in canonical labels; right-handed if the canonical list of quads is
/// counter-clockwise from outside. Requires that `target` is the code of a 3-connected
/// quadrangulation with at most kMaxSearchQuads quads. Deterministic. Safe to call from several
/// threads. Cost: some ten milliseconds for 20 quads and the default limits, and one balls_with()
/// per boundary of a ball that may lead to a small enough mesh.
[[nodiscard]] std::vector<complex::HexComplex> best_cuts(const BallSource& balls,
                                                         const canon::Code& target,
                                                         const CutOptions& options);

/// The first of these, if there is one.
[[nodiscard]] std::optional<complex::HexComplex> best_cut(const BallSource& balls,
                                                          const canon::Code& target,
                                                          CutOptions options);

}  // namespace hexatlas::flips
