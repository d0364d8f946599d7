#pragma once
/// \file
/// Internal to the judge: cells, which are spheres of triangles and quads, and their groups.
///
/// A permutation of the vertices that maps facets to facets (as cycles, in either direction) maps
/// neighbours to neighbours, if no two vertices are joined by two edges; so it is known from the
/// image of one facet, and all images of the first facet are tried. Cost: O(E^2).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tables/check/catalogue_read.hpp"

namespace hexatlas::check {

/// Image of each vertex; those that are not permuted are fixed.
using VertexPermutation = std::array<std::uint8_t, kMostCatalogueVertices>;

/// The union of the bits of vertices.
[[nodiscard]] VertexBits bits_of(const CellFacet& vertices) noexcept;
[[nodiscard]] VertexBits image_of(VertexBits set, const VertexPermutation& map) noexcept;

/// What keeps the facets from being a cell with the vertices 0 .. boundary_vertices - 1, or
/// nothing: at least four facets; three or four different vertices in each; each edge in two
/// facets, which traverse it in opposite directions, and never twice; connected; Euler
/// characteristic 2; all vertices used. So the surface is a sphere: if vertices were pinched,
/// separating them would give a connected closed surface of Euler characteristic above 2.
[[nodiscard]] std::string broken_cell_law(const std::vector<CellFacet>& facets,
                                          int boundary_vertices);

/// Whether the facets are those of the cell with this name, if the name is one of tetrahedron,
/// pyramid, prism, octahedron (up to isomorphism) and hexahedron (with the vertices x + 2y + 4z of
/// docs/theory/conventions.md). Other names say nothing. Requires a cell.
[[nodiscard]] bool is_cell_of_name(const std::string& name, const std::vector<CellFacet>& facets,
                                   int boundary_vertices);

/// All permutations that map facets to facets, mirror images included. Requires a cell.
[[nodiscard]] std::vector<VertexPermutation> symmetries_of(const std::vector<CellFacet>& facets);

}  // namespace hexatlas::check
