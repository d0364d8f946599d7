#pragma once
/// \file
/// Crowns: the hexahedra around a new edge on the axis of a half-turn.
///
/// Definition. Let a half-turn of a front fix a boundary vertex v of degree k. A *crown* at v is
/// one hexahedron on each of the k quads at v, glued on one after the other in some order, which
/// all have one new edge in common, that leads from v along the axis, and which the half-turn takes
/// to each other. After it v is inside.
///
/// Why. A hexahedron and its image that have such an edge in common can only be glued on when the
/// ones between them are there, so no orbit goes along it (docs/theory/proofs/symmetric.md,
/// section 6). Without crowns a search by orbits hardly has the meshes whose axis leads through
/// vertices: those with 36 hexahedra of Schneiders' pyramid for one.

#include <functional>

#include "enum/flips/symmetric_front.hpp"

namespace hexatlas::flips {

/// Calls visit(glued) for each crown that may be glued on so that the boundary then has at least 6
/// and at most `max_quads` quads, once, in a fixed order; in between it may have kMaxFrontQuads.
/// Of the vertices that are fixed those with degrees from 4 to kMostInOrbit are tried. Requires
/// what for_each_glueable_orbit() requires. There are none where the involution is no half-turn
/// with fixed vertices. Cost: some 30 to 90 microseconds for each fixed vertex, the more the
/// higher its degree.
void for_each_glueable_crown(const SymmetricFront& front, int max_quads,
                             const std::function<void(const GluedOrbit&)>& visit);

}  // namespace hexatlas::flips
