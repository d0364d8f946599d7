#pragma once
/// \file
/// Facets and edges of the tetrahedron, the prism and the pyramid, and the edges of the cube, whose
/// facets and numbering are in cube.hpp.
///
/// Numbering. Tetrahedron 0 1 2 3, right-handed: 3 sees 0 1 2 counter-clockwise. Prism: bottom 0 1
/// 2, top 3 4 5, i + 3 above i; the top sees the bottom counter-clockwise. Pyramid: base 0 1 2 3,
/// apex 4, which sees the base counter-clockwise. A facet lists its vertices counter-clockwise seen
/// from outside; of a triangle the last stands twice.

#include <array>
#include <cstdint>

namespace hexatlas::cells {

using ShapeVertex = std::uint8_t;
using ShapeEdge = std::array<ShapeVertex, 2>;
using ShapeFacet = std::array<ShapeVertex, 4>;

inline constexpr std::array<ShapeFacet, 4> kTetrahedronFacets{
    {{1, 2, 3, 3}, {0, 3, 2, 2}, {0, 1, 3, 3}, {0, 2, 1, 1}}};
inline constexpr std::array<ShapeFacet, 5> kPrismFacets{
    {{0, 2, 1, 1}, {3, 4, 5, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
inline constexpr std::array<ShapeFacet, 5> kPyramidFacets{
    {{0, 3, 2, 1}, {0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {3, 0, 4, 4}}};

/// Corners v and v + 2^k, for each axis k.
inline constexpr std::array<ShapeEdge, 12> kCubeEdges{{{0, 1},
                                                       {2, 3},
                                                       {4, 5},
                                                       {6, 7},
                                                       {0, 2},
                                                       {1, 3},
                                                       {4, 6},
                                                       {5, 7},
                                                       {0, 4},
                                                       {1, 5},
                                                       {2, 6},
                                                       {3, 7}}};
inline constexpr std::array<ShapeEdge, 9> kPrismEdges{
    {{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}}};
inline constexpr std::array<ShapeEdge, 8> kPyramidEdges{
    {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

[[nodiscard]] constexpr bool is_triangle(const ShapeFacet& facet) noexcept {
  return facet[2] == facet[3];
}

}  // namespace hexatlas::cells
