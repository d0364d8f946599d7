#pragma once
/// \file
/// Zones below which a layer of hexahedra has a good shape, by the angles along the edges of a
/// cavity.
///
/// A layer below a disc has a hexahedron below each quad of the disc. Where the disc ends that
/// hexahedron also has a quad of the zone as a side; so the angle between the two is one of its
/// own, and where the boundary is flat there, no places of its other vertices make it valid. So a
/// zone is sharp if its disc ends in edges that are: M. Mueller-Hannemann, "Hexahedral mesh
/// generation by successive dual cycle elimination", 1999, has such a condition.
///
/// Angles are interior ones in quarter turns: 1 at an edge of a cube, 2 where the boundary is flat,
/// above 2 where it is reflex. They come from outside and decide nothing but what is tried.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/peeling.hpp"

namespace hexatlas::flips {

/// At dart d the angle along its edge; darts that are twins have the same.
using Angles = std::vector<float>;

/// take_layer() of pillow.hpp with what is known of the angles afterwards: of the quads that come
/// up those of the quads above them, less a quarter turn across the zone. Requires 4 *
/// peeling.quad_numbers() angles, and leaves as many.
std::optional<std::vector<std::uint32_t>> take_layer(Peeling& peeling,
                                                     std::span<const std::uint32_t> quads,
                                                     Angles& angles);

/// Removes sharp zones one after another, those first that cost the fewest hexahedra for each of
/// their quads, until there is none. The angles of hexahedra, as far as those given tell, then lie
/// between 14 and 166 degrees, at the rim of a disc between 36 and 144, and as long as possible
/// between 63 and 117 there; what is left of the cavity has at least 45. Gives how
/// many zones. Angles as for take_layer(). Deterministic. Cost: that of remove_zones() at most.
std::size_t remove_sharp_zones(Peeling& peeling, Angles& angles);

/// The cavity as a layer: hexahedra between two discs that are alike, by their quads and, where
/// they bend, by their angles, joined by a zone that does not cross itself and is sharp on both
/// sides. If there are several, those with the fewest hexahedra. Right-handed, on the vertices of
/// the peeling. nullopt if there is none, or what was taken off relates two vertices of a
/// hexahedron that no quad does. Not promised: the strict rule among these hexahedra. Requires
/// angles as above. Cost: linear for each zone.
[[nodiscard]] std::optional<std::vector<complex::Hexahedron>> single_layer(const Peeling& peeling,
                                                                           const Angles& angles);

/// Takes off an *overhang*: hexahedra between two pieces of the boundary that are alike, flat, and
/// joined by a zone as above, up to where one of them bends inwards; as the rim of a plate on a
/// neck. What comes up are walls, with a quarter turn less at either end, and among each other what
/// the hexahedra there leave of a full turn. Says whether there was one. Angles as above. Cost:
/// linear for each zone.
bool take_overhang(Peeling& peeling, Angles& angles);

}  // namespace hexatlas::flips
