#pragma once
/// \file
/// Pieces of a cavity that are one layer thick, between quads of its boundary that face each other.
/// Angles are explained in angles.hpp; there have to be 4 * peeling.quad_numbers().

#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/angles.hpp"
#include "enum/flips/peeling.hpp"

namespace hexatlas::flips {

/// The cavity as a layer: hexahedra between two discs that are alike, by their quads and, where
/// they bend, by their angles, joined by a zone that does not cross itself and is sharp on both
/// sides. If there are several, those with the fewest hexahedra. Right-handed, on the vertices of
/// the peeling. nullopt if there is none, or what was taken off relates two vertices of a
/// hexahedron that no quad does. Not promised: the strict rule among these hexahedra. Cost: that of
/// all zones, and for each that is sharp on both sides of as many quads as are alike.
[[nodiscard]] std::optional<std::vector<complex::Hexahedron>> single_layer(const Peeling& peeling,
                                                                           const Angles& angles);

/// Which overhangs are taken.
enum class Extent : std::uint8_t {
  all_around,  ///< from a whole zone on
  any          ///< from a run of quads of a zone, too, that are sharp on both sides
};

/// Takes off *overhangs*: hexahedra between two pieces of the boundary that are alike, flat, and
/// joined by a zone as above, or by a run of its quads, up to where one of them bends inwards, all
/// around; as the rim of a plate on a neck, or a wall between two recesses. What comes up are
/// walls, with a right angle less at either end, and among each other what the hexahedra there
/// leave of a full turn. Zones that come up are not tried. Says whether any was taken. Cost: as
/// above, and linear in the quads for each that is tried.
bool take_overhangs(Peeling& peeling, Angles& angles, Extent extent = Extent::all_around);

}  // namespace hexatlas::flips
