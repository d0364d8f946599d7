#pragma once
/// \file
/// Places for the interior vertices of a mesh.

#include <cstddef>

#include "meshing/mesh/mesh.hpp"
#include "realize/untangle/untangle.hpp"

namespace hexatlas::hexahedrize {

/// Moves the points from `first_free` on to where realize/untangle/untangle.hpp puts them; the
/// points before stay bit for bit. Requires, promises and costs what that does.
void place(mesh::HexMesh& mesh, std::size_t first_free, const untangle::Options& options);

}  // namespace hexatlas::hexahedrize
