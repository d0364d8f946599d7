#pragma once
/// \file
/// Laplacian smoothing: a first placement of interior vertices.

#include <cstddef>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hexahedrize {

/// Moves the points from `first_free` on, each to the mean of its neighbours along edges, by
/// Gauss-Seidel sweeps in the order of the points, until no point moves by more than 1e-6 of
/// the size of the fixed points or 1000 sweeps are done. They start at the mean of the fixed points
/// that are used. Deterministic. Not promised: hexahedra of positive volume.
void smooth(mesh::HexMesh& mesh, std::size_t first_free);

}  // namespace hexatlas::hexahedrize
