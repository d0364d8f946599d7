#pragma once
/// \file
/// Meeting of two beams: meshes of a boundary put together from a ball and a collar.
///
/// A *collar* of a boundary Q is a set of hexahedra taken off inwards from Q; it leaves a cavity
/// with a boundary Q'. A ball with boundary Q' fills the cavity, and the union obeys the strict
/// rule if and only if the scars of the ball and of the collar on Q' are disjoint
/// (docs/theory/proofs/front.md). So a collar of d hexahedra and a ball of h make a mesh of Q
/// with d + h.

#include <cstdint>
#include <optional>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"

namespace hexatlas::flips {

/// A mesh whose vertices 0 .. quads+1 are the boundary's in canonical labels, right-handed if the
/// canonical list of quads is counter-clockwise from outside. The hexahedra can be taken off in
/// the order given: a shelling backwards.
struct Filling {
  complex::HexComplex mesh;
};

/// The ball of one state of a beam that was grown from the single hexahedron.
[[nodiscard]] Filling filling_of(const Beam& balls, FrontId id);

struct MeetingOptions {
  BeamOptions collars;  ///< limits of the collars' beam
  int max_collar = 12;  ///< hexahedra
  int below = 1 << 14;  ///< only fillings with fewer hexahedra are of interest
};

/// The least filling of `target` among all meetings of a collar with a ball of `balls`, or
/// nullopt. Requires that `balls` was grown from the single hexahedron and that `target` is the
/// code of a 3-connected quadrangulation: the scars say nothing of faults of the boundary itself.
/// Not promised: minimality beyond what the two beams contain.
/// Deterministic for given options, for any number of threads.
[[nodiscard]] std::optional<Filling> best_meeting(const Beam& balls, const canon::Code& target,
                                                  const MeetingOptions& options);

}  // namespace hexatlas::flips
