#pragma once
/// \file
/// Small meshes of a boundary by annealing in each dual class.
///
/// Method. A walk (walk.hpp) in which a further hexahedron and a further fault each cost a factor
/// of the probability. A cold walk, for which both cost much, and a hotter one trade places.
/// However hot, a walk hardly ever leaves the dual class of the mesh that it began with
/// (enum/complex/dual_class.hpp), and within a few rounds it has found what there is to find around
/// this mesh. So walks are short and many. They begin with meshes of many kinds, those with a few
/// faults among them, and then with *leaps*: a large ball of the mesh is exchanged for another one,
/// half of the time for one with the other parity. Leaps begin with the least meshes known of
/// classes drawn at random, other than those that are much larger. Beginnings that have an
/// involution of the boundary are walked from in the same way by steps that keep it
/// (symmetric_walk.hpp), and the least mesh so found by others then.
///
/// Sources. Annealing: Kirkpatrick, Gelatt, Vecchi (Science 220, 1983); walks that trade places:
/// Swendsen, Wang (Phys. Rev. Lett. 57, 1986); large steps, each followed by a search: Martin,
/// Otto, Felten (Complex Systems 5, 1991).

#include <cstdint>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/symmetric_balls.hpp"
#include "enum/flips/walk.hpp"

namespace hexatlas::flips {

struct AnnealingOptions {
  /// After a beginning or a leap: each is 500 steps of two walks, which then may trade places.
  int rounds = 8;
  int leaps = 120;  ///< to other meshes, half of them to other dual classes
  std::uint64_t seed = 1;
  int threads = 1;           ///< does not change the result
  int symmetric_rounds = 0;  ///< with each of involutions_of() that a beginning has
  const SymmetricBalls* symmetric = nullptr;  ///< for invariant exchanges, if there are any
};

/// What annealing begins with: right-handed meshes of one boundary, whose vertices are 0 ..
/// quads+1.
struct Beginnings {
  std::vector<complex::HexComplex> strict;  ///< balls under the strict rule
  std::vector<FaultyMesh> faulty;           ///< faulty_meeting.hpp, faulty_cut.hpp, transplant.hpp
};

/// The least mesh under the strict rule that was seen, one of begin.strict if there was no smaller
/// one. The vertices of the boundary stay. Requires at least one strict mesh, and that `balls` grew
/// from the single hexahedron. Deterministic.
/// Not promised: that the mesh has a shelling. Cost: about 0.012 s per round of each beginning and
/// leap, 0.02 to 0.1 s per symmetric round.
[[nodiscard]] complex::HexComplex least_by_annealing(const Beginnings& begin, int quads,
                                                     const Beam& balls,
                                                     const AnnealingOptions& options);

}  // namespace hexatlas::flips
