#pragma once
/// \file
/// Removing sharp zones (angles.hpp): layers of hexahedra of good shape.

#include <cstddef>
#include <cstdint>

#include "enum/flips/angles.hpp"
#include "enum/flips/peeling.hpp"

namespace hexatlas::flips {

/// Which of the zones that are as sharp goes first.
enum class ZoneOrder : std::uint8_t {
  cheapest,  ///< with the fewest hexahedra for each of its quads
  largest    ///< with the most hexahedra: the ends of a wedge before its thick side
};

/// How many zones a layer may end at.
enum class Rims : std::uint8_t {
  one,     ///< it is below a disc
  several  ///< below a piece with holes: around recesses, with a zone around the wall of each
};

struct SharpOptions {
  int within = kLeastAtRim;  ///< degrees of a right angle, at the rim of a piece
  ZoneOrder order = ZoneOrder::cheapest;
  Rims rims = Rims::one;
  bool only_one = false;  ///< one layer, the first in order that may be taken
};

/// Takes layers off that end at sharp zones, until there is none. As far as the angles given tell,
/// angles of their hexahedra at the rim of a piece are within so many degrees of a right angle,
/// others lie between 14 and 166 degrees, and of one that two of them share below a piece each has
/// half of at least 126; where the piece ends, at least 45 are left of the cavity. Gives how many
/// layers. Requires 4 * peeling.quad_numbers() angles, and leaves as many. Deterministic. Cost:
/// linear in the hexahedra, plus that of all zones with what is looked at of their pieces, up to
/// the first bad angle, for each time that zones are sought anew: as often as bodies lie on each
/// other, about.
std::size_t remove_sharp_zones(Peeling& peeling, Angles& angles, const SharpOptions& options = {});

}  // namespace hexatlas::flips
