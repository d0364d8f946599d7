#pragma once
/// \file
/// Polyhedra with few vertices whose facets are triangles and quads: by Steinitz' theorem the
/// 3-connected planar graphs with such faces.
///
/// Each comes from a triangulated sphere on the same vertices by removing edges, at most one from
/// each triangle: a diagonal of a facet of a polyhedron is no edge, and no two facets have the same
/// diagonal. The triangulated spheres are reached from the tetrahedron by 1-3 subdivisions and edge
/// flips (K. Wagner, "Bemerkungen zum Vierfarbenproblem", Jber. Deutsch. Math.-Verein. 46, 1936:
/// the flip graph of each number of vertices is connected), so that the lists are complete.

#include <vector>

#include "enum/complex/cell.hpp"

namespace hexatlas::balls {

inline constexpr int kMaxPolyhedronVertices = 8;

/// All triangulated 2-spheres with this number of vertices up to isomorphism, mirror images
/// identified: 1, 1, 2, 5, 14 for 4 .. 8 vertices. In the order of polyhedra(). Requires
/// 4 <= vertices <= kMaxPolyhedronVertices.
[[nodiscard]] std::vector<complex::Cell> triangulated_spheres(int vertices);

/// All polyhedra with this number of vertices, facets triangles and quads, up to isomorphism,
/// mirror images identified: 1, 2, 6, 28, 183 for 4 .. 8 vertices. Ascending by number of quads,
/// then by a code that depends on the class only, as do the labels. Requires 4 <= vertices <=
/// kMaxPolyhedronVertices. Cost: below a second.
[[nodiscard]] std::vector<complex::Cell> polyhedra(int vertices);

}  // namespace hexatlas::balls
