#pragma once
/// \file
/// Isomorphisms of spheres of triangles and quads by walks: a map is read off from a directed edge
/// in one way only, so two maps are isomorphic by a map of one directed edge to another if and only
/// if the two readings agree.
///
/// Source of the idea: L. Weinberg, "A simple and efficient algorithm for determining isomorphism
/// of planar triply connected graphs", IEEE Trans. Circuit Theory 13 (1966).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/complex/cell.hpp"

namespace hexatlas::balls {

/// The map as seen from one of its directed edges.
struct MapWalk {
  /// For each vertex in the order of the walk the numbers of its neighbours in this order, all the
  /// way round, and kEnd.
  using Code = std::array<std::uint8_t, 7 * complex::kMaxCellVertices>;
  static constexpr std::uint8_t kEnd = 255;

  Code code{};                                               ///< filled up with kEnd
  std::array<std::uint8_t, complex::kMaxCellVertices> at{};  ///< vertices in the order of the walk
};

/// A sphere of facets on the vertices 0, 1, .. without parallel edges.
class SphereMap {
 public:
  /// Requires at most kMaxCellVertices vertices.
  explicit SphereMap(int vertices);
  /// The vertices of a facet, counter-clockwise. Requires that no directed edge comes twice.
  void add(std::span<const std::uint8_t> facet);

  struct Dart {
    std::uint8_t from = 0, to = 0;
    bool mirrored = false;  ///< to be read clockwise
  };
  /// Twice as many as directed edges: read in both senses; ascending.
  [[nodiscard]] std::vector<Dart> darts() const;
  /// Codes of two maps are equal if and only if an isomorphism takes the one dart to the other; it
  /// then takes at[i] to at[i]. Requires that the facets added form a sphere.
  [[nodiscard]] MapWalk walk(Dart dart) const;
  [[nodiscard]] int vertices() const noexcept { return vertices_; }

 private:
  static constexpr std::uint8_t kNone = 255;
  using Row = std::array<std::uint8_t, complex::kMaxCellVertices>;

  int vertices_;
  /// turn_[0][v][w]: the neighbour of v that follows w counter-clockwise; turn_[1]: clockwise.
  std::array<std::array<Row, complex::kMaxCellVertices>, 2> turn_{};
};

[[nodiscard]] SphereMap map_of(int vertices, std::span<const complex::CellFacet> facets);
[[nodiscard]] SphereMap map_of(int vertices, std::span<const complex::OrientedTriangle> triangles);

}  // namespace hexatlas::balls
