#pragma once
/// \file
/// Unions of a collar and two balls that do not quite fit: meshes with a few faults, to begin
/// annealing with.
///
/// Definition. A collar of a boundary Q leaves a cavity; a cut of the cavity (cut.hpp) makes of it
/// the boundaries of two balls. All three together are a mesh of Q, with a fault for each pair of
/// vertices that two of them relate apart from each other. Such meshes are of other kinds than
/// those of a collar and one ball (faulty_meeting.hpp), and there are many of them where of those
/// there are none.
///
/// Faulty cuts are of this project.

#include <cstddef>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/faults.hpp"
#include "enum/flips/walk.hpp"

namespace hexatlas::flips {

struct FaultyCutOptions {
  /// Limits of the collars' beam, which is narrow; its seed decides what is drawn, too.
  BeamOptions collars{.max_quads = kMaxSearchQuads, .fronts_per_class = 3, .fronts_per_level = 300};
  int max_collar = 6;          ///< hexahedra
  int max_circle = 8;          ///< of the cuts, as in CutOptions
  int max_interior = 4;        ///< of the cuts, as in CutOptions
  std::size_t cavities = 100;  ///< to be cut, the boundary itself among them
  FaultyWanted wanted;
};

/// Some such meshes of `target` with at least one fault, drawn at random: cavities of each
/// thickness alike, then unions of each number of faults and of hexahedra alike. Meshes in which
/// two facets have the same vertices are left out. The boundaries of the two balls have no more
/// quads than those that `balls` grew. Requires that `target` is the code of a
/// 3-connected quadrangulation with at most kMaxSearchQuads quads, and that `balls` grew from the
/// single hexahedron. Deterministic for given options, for any number of threads. Cost: some ten
/// milliseconds per cavity.
/// Not promised: that all kinds that there are may come.
[[nodiscard]] std::vector<FaultyMesh> faulty_cuts(const Beam& balls, const canon::Code& target,
                                                  const FaultyCutOptions& options);

}  // namespace hexatlas::flips
