#pragma once
/// \file
/// Internal to the judge: the cells of a hybrid mesh in one list, their facets and edges, and the
/// signs of their Jacobian determinants.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tables/check/jacobian.hpp"
#include "tables/check/mesh.hpp"
#include "tables/check/signs.hpp"

namespace hexatlas::check {

enum class CellShape : std::uint8_t { kTetrahedron, kHexahedron, kPrism, kPyramid };

struct HybridCell {
  CellShape shape = CellShape::kTetrahedron;
  std::uint32_t number = 0;  ///< among those of its shape
  std::array<std::uint32_t, 8> vertices{};

  [[nodiscard]] std::span<const std::uint32_t> corners() const;
};

/// The places of the vertices of a facet, counterclockwise seen from outside; 3 or 4 of them.
struct FacetPlaces {
  std::uint8_t size;
  std::array<std::uint8_t, 4> at;
};

[[nodiscard]] std::span<const FacetPlaces> facets_of(CellShape shape);

/// An edge from `v` to `w`, as places, and the two facets that contain it, each by the vertex next
/// to `v` in it, other than w: the cell is between the half-planes from the edge through `from` and
/// `to`, counterclockwise around v -> w.
struct EdgePlaces {
  std::uint8_t v, w, from, to;
};

/// Each edge in both directions.
[[nodiscard]] const std::vector<EdgePlaces>& edges_of(CellShape shape);

/// All cells: tetrahedra, hexahedra, prisms, pyramids.
[[nodiscard]] std::vector<HybridCell> cells_of(const HybridMesh& mesh);

/// "prism 3 (0, 1, 2, 3, 4, 5)".
[[nodiscard]] std::string name_of(const HybridCell& cell);

/// The sign of the Jacobian determinant on the closed cell, but for the apex of a pyramid: of a
/// tetrahedron it is constant; of a hexahedron as in jacobian.hpp; of a prism it is linear in the
/// two coordinates of the triangle and quadratic in the third one, so that the three vertical edges
/// decide; of a pyramid, as the cone over its base, it is a square times a bilinear function on the
/// base, so that the four corners of the base decide.
/// Requires: vertices among the points. kUnknown: only for hexahedra.
[[nodiscard]] JacobianSign jacobian_sign(const HybridCell& cell, const std::vector<Point>& points,
                                         Signs& signs);

}  // namespace hexatlas::check
