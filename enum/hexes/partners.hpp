#pragma once
/// \file
/// A pruning for balls with few interior vertices: the hexahedra to come at a vertex need partners,
/// other vertices that it shares no hexahedron with yet. Definitions and proofs:
/// docs/theory/proofs/hexahedral-search.md, section 8.

#include "enum/hexes/partial_mesh.hpp"

namespace hexatlas::hexes {

struct Partners {
  bool are_too_few = false;  ///< no ball within the limit of vertices follows
  VertexSet saturated = 0;   ///< vertices that no further edge ends at, in any ball that follows
};

/// Of a state of a search for balls, without a hexahedron begun; to `saturated`, known so far,
/// others are added. Cost: some microseconds.
[[nodiscard]] Partners partners_of(const PartialMesh& mesh, VertexSet saturated);

}  // namespace hexatlas::hexes
