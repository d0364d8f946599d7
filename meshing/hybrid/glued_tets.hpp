#pragma once
/// \file
/// Private to meshing/hybrid: tetrahedra with what lies beyond their facets, of which some are
/// exchanged for others with the same union.

#include <cstddef>
#include <span>
#include <vector>

#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

class GluedTets {
 public:
  static constexpr TetIndex kOutside = TetGraph::kOutside;

  /// As the graph has them.
  explicit GluedTets(const TetGraph& graph);
  /// Requires tetrahedra that meet in common facets, fewer than 2^30.
  explicit GluedTets(std::vector<Tetrahedron> tetrahedra);

  /// Of the list, with those that were replaced, which keep their vertices.
  [[nodiscard]] std::size_t size() const noexcept { return tetrahedra_.size(); }
  [[nodiscard]] const Tetrahedron& operator[](TetIndex t) const noexcept { return tetrahedra_[t]; }
  /// Beyond the facet opposite to a vertex of t.
  [[nodiscard]] TetIndex across(TetIndex t, std::size_t facet) const noexcept {
    return across_[std::size_t{t} * 4 + facet];
  }

  /// Puts tetrahedra in the place of others; they come last in the list, in their order.
  /// Requires the same orientation, union and boundary, else InternalError or nonsense.
  /// Cost: for n tetrahedra n log n.
  void replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh);

 private:
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<TetIndex> across_;
};

/// The place of a vertex in a tetrahedron; 4 if it is none of its vertices.
[[nodiscard]] inline std::size_t place_of(const Tetrahedron& t, Index v) noexcept {
  std::size_t i = 0;
  while (i < 4 && t[i] != v) ++i;
  return i;
}

}  // namespace hexatlas::hybrid
