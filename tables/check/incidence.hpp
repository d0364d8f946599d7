#pragma once
/// \file
/// Internal to the judge: which vertices, edges and quads lie in which hexahedra.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tables/check/mesh.hpp"
#include "tables/check/verdict.hpp"

namespace hexatlas::check {

/// Quads of a hexahedron, counter-clockwise from outside; corners in VTK order.
inline constexpr std::array<std::array<unsigned, 4>, 6> kQuadCorners = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
inline constexpr std::array<std::array<unsigned, 2>, 12> kEdgeCorners = {{{0, 1},
                                                                          {1, 2},
                                                                          {2, 3},
                                                                          {3, 0},
                                                                          {4, 5},
                                                                          {5, 6},
                                                                          {6, 7},
                                                                          {7, 4},
                                                                          {0, 4},
                                                                          {1, 5},
                                                                          {2, 6},
                                                                          {3, 7}}};
/// Coordinates x + 2 y + 4 z of the corners.
inline constexpr std::array<unsigned, 8> kCornerBits = {0, 1, 3, 2, 4, 5, 7, 6};

[[nodiscard]] constexpr bool are_adjacent_corners(unsigned a, unsigned b) {
  const unsigned differing = kCornerBits[a] ^ kCornerBits[b];
  return differing == 1 || differing == 2 || differing == 4;
}

/// The corners for which `are_joined` to each corner, ascending.
template <std::size_t count>
[[nodiscard]] constexpr std::array<std::array<unsigned, count>, 8> corners_joined(
    bool (*are_joined)(unsigned, unsigned)) {
  std::array<std::array<unsigned, count>, 8> joined{};
  for (unsigned a = 0; a < 8; ++a) {
    std::size_t found = 0;
    for (unsigned b = 0; b < 8; ++b) {
      if (are_joined(a, b)) joined[a][found++] = b;
    }
  }
  return joined;
}
inline constexpr auto kCornerNeighbours = corners_joined<3>(are_adjacent_corners);
/// Those that make a diagonal with it, of a quad or of the hexahedron.
inline constexpr auto kCornerOpposites =
    corners_joined<4>([](unsigned a, unsigned b) { return a != b && !are_adjacent_corners(a, b); });

/// The corner of a hexahedron that is `vertex`. Requires that there is one.
[[nodiscard]] inline std::size_t corner_at(const Hexahedron& cell, std::uint32_t vertex) {
  return static_cast<std::size_t>(std::find(cell.begin(), cell.end(), vertex) - cell.begin());
}

/// Two vertices as one number, in the order of the lesser vertices, then of the greater ones.
[[nodiscard]] constexpr std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
}
[[nodiscard]] constexpr std::array<std::uint32_t, 2> pair_of(std::uint64_t key) {
  return {static_cast<std::uint32_t>(key >> 32U), static_cast<std::uint32_t>(key)};
}

struct Failure {
  Law law;
  std::string reason;
};
using Finding = std::optional<Failure>;

/// A list of lists of numbers in one array.
struct Lists {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> items;
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {items.data() + start[i], items.data() + start[i + 1]};
  }
};

/// A quad of hexahedra: place 6 c + q is quad q of hexahedron c.
struct Facet {
  std::uint32_t uses = 0;                   ///< hexahedra that contain it
  std::array<std::uint32_t, 2> place = {};  ///< in the first two of them
};

struct Incidence {
  std::span<const Hexahedron> cells;
  std::uint32_t vertex_count = 0;
  Lists cells_at;                                      ///< per vertex
  std::vector<Facet> facets;                           ///< each set of vertices once
  std::vector<std::array<std::uint32_t, 6>> facet_of;  ///< per hexahedron
  std::vector<std::array<std::uint32_t, 2>> edges;     ///< each pair of vertices once
  std::vector<std::array<std::uint32_t, 12>> edge_of;  ///< per hexahedron
  std::vector<bool> on_boundary;                       ///< per vertex

  /// Vertices of the quad at a place, counter-clockwise from outside its hexahedron.
  [[nodiscard]] Quad quad_at(std::uint32_t place) const;
};

/// Requires: all vertices are less than `vertex_count`, those of each hexahedron distinct.
/// The cells must outlive the result. Cost: O(H log H).
[[nodiscard]] Incidence incidence_of(std::span<const Hexahedron> cells, std::uint32_t vertex_count);

/// The quads that lie in one hexahedron, counter-clockwise from outside the mesh.
[[nodiscard]] std::vector<Quad> boundary_quads(const Incidence& incidence);

/// "(1, 2, 3, 4)".
template <typename Numbers>
[[nodiscard]] std::string listed(const Numbers& numbers) {
  std::string text;
  for (const auto number : numbers) text += (text.empty() ? "(" : ", ") + std::to_string(number);
  return text + ")";
}

}  // namespace hexatlas::check
