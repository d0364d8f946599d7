#pragma once
/// \file
/// Meetings of a collar and a ball that do not quite fit: meshes with a few faults, to begin
/// annealing with.
///
/// Definition. As in meeting.hpp, but the ball and the collar may have scars in common. Each of
/// these is one fault of the mesh (docs/theory/proofs/front.md, section 8). For many a boundary
/// most of the small balls known fit only so, and few steps of a walk take one fault away.
///
/// Faulty meetings are of this project.

#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/faults.hpp"
#include "enum/flips/symmetric_balls.hpp"
#include "enum/flips/walk.hpp"

namespace hexatlas::flips {

struct FaultyMeetingOptions {
  /// As in MeetingOptions; the seed decides what is drawn, too.
  BeamOptions collars;
  int max_collar = 8;  ///< hexahedra
  FaultyWanted wanted;
  int guided = 0;  ///< as in MeetingOptions
};

/// Of all meetings of a collar of `target` with a ball of `balls` that have a fault, some drawn at
/// random: first the number of faults and that of hexahedra, each with the same probability, since
/// of some kinds there are thousands alike. No two have the same collar, ball and position.
/// Meetings in which two facets have the same vertices are left out.
/// Requires that `target` is the code of a 3-connected quadrangulation and that `balls` grew from
/// the single hexahedron. Deterministic for given options, for any number of threads. Cost: that of
/// the collars, and some nanoseconds for each ball known with the boundary of a cavity.
[[nodiscard]] std::vector<FaultyMesh> faulty_meetings(const Beam& balls, const canon::Code& target,
                                                      const FaultyMeetingOptions& options);

/// The same with collars that an involution of the boundary takes to themselves
/// (symmetric_beam.hpp), for each involution in turn; the balls need no symmetry. None for a
/// boundary without an involution. Of the options collars.use_dominance does nothing here, and
/// collars.max_quads is at most kMaxSymmetricQuads; a cavity has at most kMaxStateQuads.
/// `symmetric_balls`, if given, fill as well the cavities that have their involution, with up to
/// kMaxSymmetricQuads; of these meetings those without a fault may be drawn, too.
[[nodiscard]] std::vector<FaultyMesh> faulty_symmetric_meetings(
    const Beam& balls, const canon::Code& target, const FaultyMeetingOptions& options,
    const SymmetricBalls* symmetric_balls = nullptr);

}  // namespace hexatlas::flips
