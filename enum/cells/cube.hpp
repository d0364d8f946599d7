#pragma once
/// \file
/// The reference cube and its numbering. Every folder uses this numbering and
/// defines no other; conversions to file formats live in enum/io/ only.
///
///        6-------7      vertex v = x + 2y + 4z   (bit k of v is coordinate k)
///       /|      /|      facet  f = 2k + s        (the side x_k = s)
///      4-------5 |      opposite(f) = f ^ 1
///   z  | 2-----|-3
///   ^y |/      |/       Facet vertices are listed counter-clockwise seen from
///   |/ 0-------1        outside, smallest label first.
///   +--> x

#include <array>
#include <cstdint>
#include <utility>

namespace hexatlas::cells {

inline constexpr int kCubeVertices = 8;
inline constexpr int kCubeFacets = 6;

using CubeVertex = std::uint8_t;  ///< in [0, kCubeVertices)
using CubeFacet = std::uint8_t;   ///< in [0, kCubeFacets)

inline constexpr std::array<std::array<CubeVertex, 4>, kCubeFacets> kFacetVertices{{
    {0, 4, 6, 2},  // x = 0
    {1, 3, 7, 5},  // x = 1
    {0, 1, 5, 4},  // y = 0
    {2, 6, 7, 3},  // y = 1
    {0, 2, 3, 1},  // z = 0
    {4, 5, 7, 6},  // z = 1
}};

[[nodiscard]] constexpr CubeFacet opposite(CubeFacet f) noexcept { return f ^ 1U; }

/// A bottom quad b0 b1 b2 b3, counter-clockwise from outside, and the top vertices above them:
/// kCornerOfPrism[i] is the cube vertex of b_i, kCornerOfPrism[4 + i] that of t_i.
inline constexpr std::array<CubeVertex, kCubeVertices> kCornerOfPrism{0, 2, 3, 1, 4, 6, 7, 5};

/// Exchanges the first two axes of the numbering: of a hexahedron's vertices, listed by corner,
/// it makes its mirror image on the same vertices. A left-handed one becomes right-handed.
template <class Vertex>
constexpr void exchange_axes(std::array<Vertex, kCubeVertices>& vertex_at) noexcept {
  std::swap(vertex_at[1], vertex_at[2]);
  std::swap(vertex_at[5], vertex_at[6]);
}

}  // namespace hexatlas::cells
