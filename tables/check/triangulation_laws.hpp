#pragma once
/// \file
/// Internal to the judge: the laws of one triangulation, from its tetrahedra. A function returns
/// nothing if its law holds, else what breaks it. Cost: O(t log t) each.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tables/check/catalogue.hpp"
#include "tables/check/catalogue_read.hpp"

namespace hexatlas::check {

struct BrokenLaw {
  CatalogueLaw law;
  std::string reason;
};
using CatalogueFinding = std::optional<BrokenLaw>;

/// The vertices in ascending order, as digits of the format.
[[nodiscard]] std::string digits_of(VertexBits set);

/// +1 or -1: of the permutation that sorts these different numbers.
[[nodiscard]] int parity_of(const std::array<std::uint8_t, 4>& points) noexcept;

/// Law::kTriangles: no tetrahedron is listed twice, no triangle lies in three.
[[nodiscard]] CatalogueFinding check_triangles(const Tetrahedra& tetrahedra);

/// Law::kVertices: all of 0 .. vertices - 1 are used.
[[nodiscard]] CatalogueFinding check_vertices(const Tetrahedra& tetrahedra, int vertices);

/// The triangles in exactly one tetrahedron, ascending.
[[nodiscard]] std::vector<VertexBits> boundary_triangles(const Tetrahedra& tetrahedra);

/// Three vertices in cyclic order, counter-clockwise from outside.
using OutwardTriangle = std::array<std::uint8_t, 3>;

/// Law::kBoundary: the boundary triangles are the triangular facets and two triangles per quad, on
/// the two sides of one of its diagonals. Sets `outward` to one of them. Requires that the
/// tetrahedra are a ball, so that their boundary is a sphere without double edge, and that the
/// facets are a cell. (Not both diagonals of a quad can be edges of two boundary triangles of it:
/// these four triangles would be the whole sphere, and the cell would have less than four facets.)
[[nodiscard]] CatalogueFinding check_boundary(const Tetrahedra& tetrahedra,
                                              const std::vector<CellFacet>& facets,
                                              OutwardTriangle& outward);

/// Law::kBoundaryTetrahedra: no tetrahedron has all four vertices on one facet.
[[nodiscard]] CatalogueFinding check_boundary_tetrahedra(const Tetrahedra& tetrahedra,
                                                         const std::vector<CellFacet>& facets);

/// The sign of each tetrahedron abcd, a < b < c < d, in any placement that orients them coherently
/// and the first one positively. Requires a ball.
[[nodiscard]] std::vector<int> coherent_signs(const Tetrahedra& tetrahedra);

/// The same, but with this boundary triangle counter-clockwise from outside: the fourth vertex of
/// its tetrahedron makes the sign of the four negative.
[[nodiscard]] std::vector<int> coherent_signs(const Tetrahedra& tetrahedra,
                                              const OutwardTriangle& outward);

}  // namespace hexatlas::check
