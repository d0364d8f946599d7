#pragma once
/// \file
/// Making a cavity smaller by peeling: few hexahedra, each sequence of them chosen so that the
/// cavity's boundary has fewer quads afterwards.
///
/// Two ways. *Local*: at each quad the shortest sequence of flips that begins there and makes the
/// number of quads less by its last flip, while the others keep it, or one of them adds two. Each
/// flip takes away a quad that a former one of the sequence made. *Zones*: the quads crossed by a
/// closed curve that leaves each quad at the side opposite to where it came in. A zone that does
/// not meet itself bounds a disc on either side; a layer of hexahedra below a disc removes the zone
/// (M. Mueller-Hannemann, "Hexahedral mesh generation by successive dual cycle elimination", 1999).
/// Local sequences do for irregular surfaces, zones for grids, where short sequences lead nowhere.

#include <cstddef>
#include <cstdint>

#include "enum/flips/peeling.hpp"

namespace hexatlas::flips {

struct ReducingOptions {
  int depth = 6;               ///< flips of a sequence, at least 1
  std::size_t looks = 20'000;  ///< patches looked at for the sequences from one quad
  bool may_grow = false;       ///< one flip of a sequence may add two quads
  std::uint64_t seed = 0;      ///< of the order in which quads are tried; 0: that of their numbers
};

/// Applies local sequences, shorter ones first, until there is none. Deterministic. Cost: some
/// microseconds for each look, about 100 looks for a quad of an irregular surface.
void reduce(Peeling& peeling, const ReducingOptions& options);

/// Removes zones one after another, those first that cost the fewest hexahedra for each of their
/// quads, as long as that is at most `price`. Gives how many. Deterministic. Cost: linear in the
/// hexahedra, plus that of all zones' discs for each time that zones are sought anew.
std::size_t remove_zones(Peeling& peeling, double price);

/// The quads at which a zone crosses itself. The removal of other zones keeps them, so it leaves at
/// least as many quads. Cost: linear.
[[nodiscard]] std::size_t self_crossings(const Peeling& peeling);

}  // namespace hexatlas::flips
