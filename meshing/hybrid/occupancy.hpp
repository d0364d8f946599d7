#pragma once
/// \file
/// Private to meshing/hybrid: the cells chosen so far, and whether another fits beside them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "enum/cells/shapes.hpp"
#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/selection.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

/// A candidate of any shape.
struct CellView {
  Shape shape = Shape::hexahedron;
  std::span<const Index> vertices;
  std::span<const TetIndex> inner, flat;  ///< one after the other in the candidates' list
  double quality = 0;

  [[nodiscard]] std::span<const TetIndex> all() const noexcept {
    return {inner.data(), inner.size() + flat.size()};
  }
};

[[nodiscard]] CellView view_of(const Candidates& candidates, Cell cell);

/// Positions of vertices in a cell.
using LocalEdge = cells::ShapeEdge;
[[nodiscard]] std::span<const LocalEdge> edges_of(Shape shape);
using LocalQuad = cells::ShapeFacet;
/// Cyclic, counter-clockwise from outside.
[[nodiscard]] std::span<const LocalQuad> quads_of(Shape shape);

/// As selection.hpp defines it.
[[nodiscard]] bool are_compatible(const CellView& a, const CellView& b);

class Occupancy {
 public:
  static constexpr std::uint32_t kFree = 0xFFFF'FFFF;

  explicit Occupancy(std::size_t tetrahedra) : owner_(tetrahedra, kFree), flats_(tetrahedra, 0) {}

  /// Whether it is compatible with all cells in.
  [[nodiscard]] bool fits(const CellView& cell) const;
  /// Requires fits(cell); `name` is what owner() answers for its inner tetrahedra.
  void put(const CellView& cell, std::uint32_t name);
  /// Requires that it is in.
  void take(const CellView& cell);

  [[nodiscard]] std::uint32_t owner(TetIndex t) const noexcept { return owner_[t]; }

 private:
  /// What a pair of vertices is to the cells in. As a diagonal it belongs to one quad, known by
  /// its other diagonal.
  struct Pair {
    std::uint32_t edges = 0, diagonals = 0;
    std::uint64_t other = 0;
  };

  [[nodiscard]] bool fits_pairs(const CellView& cell) const;

  std::vector<std::uint32_t> owner_;
  std::vector<std::uint8_t> flats_;  ///< cells that have the tetrahedron as a flat one
  std::unordered_map<std::uint64_t, Pair> pairs_;
};

}  // namespace hexatlas::hybrid
