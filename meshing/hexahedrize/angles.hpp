#pragma once
/// \file
/// The interior angles along the edges of a surface.

#include <span>

#include "enum/flips/angles.hpp"
#include "enum/flips/peeling.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hexahedrize {

/// By darts, in whole degrees. Quads need not be planar: at an edge the direction of a quad is that
/// from the edge's midpoint to the midpoint of the opposite edge. An edge where that says nothing
/// counts as flat. Requires a point for each vertex of the peeling, which has taken nothing off.
/// In double precision, rounded: two machines may differ by a degree where one lies halfway.
[[nodiscard]] flips::Angles interior_angles(const flips::Peeling& peeling,
                                            std::span<const mesh::Point> points);

}  // namespace hexatlas::hexahedrize
