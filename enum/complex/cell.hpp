#pragma once
/// \file
/// Cells: spheres of triangles and quads on few vertices, whose insides are to be triangulated.
///
/// Definition: docs/theory/triangulation-definition.txt. The hexahedron has the numbering of
/// enum/cells/cube.hpp. Facets are counter-clockwise from outside, least vertex first.

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "enum/complex/broken_law.hpp"
#include "enum/complex/triangulation.hpp"

namespace hexatlas::complex {

inline constexpr int kMaxCellVertices = 12;

struct CellFacet {
  std::array<std::uint8_t, 4> vertex{};  ///< cyclic; the last is 0 and without meaning if size is 3
  std::uint8_t size = 3;                 ///< 3 or 4

  [[nodiscard]] VertexSet vertices() const noexcept;
  friend auto operator<=>(const CellFacet&, const CellFacet&) = default;
};

struct Cell {
  int vertices = 0;
  std::vector<CellFacet> facets;
};

/// tetrahedron, pyramid, prism, octahedron, hexahedron.
[[nodiscard]] std::span<const std::string_view> cell_names();
/// nullopt if the name is none of cell_names().
[[nodiscard]] std::optional<Cell> cell_named(std::string_view name);

/// The cell with these facets, made coherent: facets that disagree in orientation with the first
/// are turned over; or the first broken law of: at least four facets of three or four distinct
/// vertices below `vertices`; no facet twice; each edge in exactly two facets; links of vertices
/// are circles; connected; orientable; Euler characteristic 2; all of 0 .. vertices-1 used; at most
/// kMaxCellVertices; and some choice of diagonals gives a simplicial sphere.
[[nodiscard]] std::variant<Cell, BrokenLaw> cell_of(const std::vector<CellFacet>& facets,
                                                    int vertices);

/// All permutations of the vertices that map facets to facets, mirror images included; ascending,
/// the identity first. Entries at and above `vertices` are fixed.
[[nodiscard]] std::vector<VertexMap> symmetries(const Cell& cell);

/// An oriented triangle: counter-clockwise seen from outside.
using OrientedTriangle = std::array<std::uint8_t, 3>;

/// Its vertices, without the orientation.
[[nodiscard]] constexpr VertexSet set_of(const OrientedTriangle& triangle) noexcept {
  return static_cast<VertexSet>(bit_of(triangle[0]) | bit_of(triangle[1]) | bit_of(triangle[2]));
}

/// The triangulated spheres obtained by a diagonal in each quad, as far as they are simplicial. Bit
/// i of the choice: the i-th quad in the order of the facets is cut by the diagonal through its
/// second vertex instead of its first. Ascending by choice.
struct CutSurface {
  std::uint32_t choice = 0;
  std::vector<OrientedTriangle> triangles;
};
[[nodiscard]] std::vector<CutSurface> cut_surfaces(const Cell& cell);

}  // namespace hexatlas::complex
