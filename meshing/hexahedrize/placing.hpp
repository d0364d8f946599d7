#pragma once
/// \file
/// Places for the interior vertices of a mesh, or for all.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "meshing/mesh/mesh.hpp"
#include "realize/untangle/untangle.hpp"

namespace hexatlas::hexahedrize {

/// Moves the points from `first_free` on to where realize/untangle/untangle.hpp puts them; the
/// points before stay bit for bit. Requires, promises and costs what that does.
void place(mesh::HexMesh& mesh, std::size_t first_free, const untangle::Options& options);

/// Likewise the points flagged, one flag per point.
void place(mesh::HexMesh& mesh, std::vector<std::uint8_t> is_free,
           const untangle::Options& options);

/// The same from `first_free` on, and once more in the frame in which the other points are about as
/// far apart in all directions (round_frame.hpp) if they are not here and not all hexahedra came
/// out valid; the places with more valid ones stay, of as many those with fewer inverted ones.
void place_in_a_frame(mesh::HexMesh& mesh, std::size_t first_free,
                      const untangle::Options& options);

enum class Boundary : std::uint8_t {
  convex,  ///< a Koebe polyhedron (realize/untangle/koebe.hpp)
  free     ///< begins there, and then moves as the interior does
};

/// A mesh of which only the combinatorics are given, with places for all vertices; the vertices 0,
/// 1, ... are those of its boundary. A free boundary may end anywhere: not promised is that it does
/// not meet itself. Requires a 3-connected boundary and that the mesh has it, else
/// PreconditionViolated.
[[nodiscard]] mesh::HexMesh placed(const complex::HexComplex& cells,
                                   const complex::Quadrangulation& boundary, Boundary kind,
                                   const untangle::Options& options);

}  // namespace hexatlas::hexahedrize
