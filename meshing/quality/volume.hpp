#pragma once
/// \file
/// The signed volume of one cell.
///
/// Definition. The integral of the Jacobian determinant of the cell's map, positive for
/// right-handed cells. Sides of four vertices are bilinear patches, so cells that share a side
/// leave no gap and the volumes of a mesh add up. By the divergence theorem it is the sum over the
/// sides of the volume between a point and the side; for a patch that is the mean of those of its
/// two triangulations, since the patch halves the tetrahedron of its vertices: an exchange of its
/// two variables takes one half to the other.
///
/// In double precision, relative to the first vertex: errors of some 1e-15 times the cube of the
/// diameter. Infinite or NaN if a product of three differences overflows.

#include "meshing/quality/cells.hpp"
#include "meshing/quality/hexahedron.hpp"

namespace hexatlas::quality {

[[nodiscard]] double volume(const TetrahedronCorners& corners);
[[nodiscard]] double volume(const PrismCorners& corners);
[[nodiscard]] double volume(const PyramidCorners& corners);
[[nodiscard]] double volume(const Corners& corners);

}  // namespace hexatlas::quality
