#pragma once
/// \file
/// The quads of a tetrahedral mesh by their corners.
///
/// Definition. A quad is a cycle v x z y of four vertices such that the mesh has the two triangles
/// at one of its diagonals: v x z and v z y, or v x y and x z y. It may have all four. The four
/// triangles may be the facets of one tetrahedron, which is then flat as seen by a cell with this
/// quad.
///
/// Cost: for each edge in k triangles some k^2 quads; twelve bytes for each corner, and two for
/// each pair of neighbours of a vertex with few.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "meshing/hybrid/tet_graph.hpp"
#include "meshing/quality/edge.hpp"

namespace hexatlas::hybrid {

/// The vector from one end of an edge to the other divided by its length.
using Direction = mesh::Point;

using quality::determinant;

/// A quad with a corner at v: its neighbours there, x before y, by position among neighbours(v),
/// and the opposite vertex.
struct Corner {
  std::uint32_t x = 0, y = 0;
  Index z = 0;
  friend auto operator<=>(const Corner&, const Corner&) = default;
};

class Corners {
 public:
  /// Leaves out the corners whose sine is below `least_sine`. The same for any number of threads.
  Corners(const TetGraph& graph, double least_sine, int threads);

  /// The corners at v whose first neighbour is at position x, ascending.
  [[nodiscard]] std::span<const Corner> at(Index v, std::uint32_t x) const noexcept {
    const std::size_t row = graph_->first_edge(v) + x;
    return std::span(corners_).subspan(start_[row], start_[row + 1] - start_[row]);
  }
  /// Those between the neighbours of v at positions x and y, in any order.
  [[nodiscard]] std::span<const Corner> between(Index v, std::uint32_t x,
                                                std::uint32_t y) const noexcept {
    if (x > y) std::swap(x, y);
    const std::size_t table = table_start_[v];
    if (table == kNoTable) return search(v, x, y);
    const std::size_t degree = graph_->neighbours(v).size();
    const std::uint16_t* pair = table_.data() + table + x * degree + y;
    return {corners_.data() + start_[graph_->first_edge(v)] + pair[0],
            static_cast<std::size_t>(pair[1] - pair[0])};
  }

  /// From v to its neighbour at a position.
  [[nodiscard]] const Direction& direction(Index v, std::uint32_t position) const noexcept {
    return directions_[graph_->first_edge(v) + position];
  }

 private:
  static constexpr std::size_t kNoTable = static_cast<std::size_t>(-1);

  void make_tables();
  [[nodiscard]] std::span<const Corner> search(Index v, std::uint32_t x,
                                               std::uint32_t y) const noexcept;

  const TetGraph* graph_;
  std::vector<Direction> directions_;
  std::vector<std::size_t> start_;  ///< of a row for each directed edge
  std::vector<Corner> corners_;
  /// For vertices of small degree n: at x n + y where, among the corners at v, those between x and
  /// y begin; one more at the end.
  std::vector<std::uint16_t> table_;
  std::vector<std::size_t> table_start_;
};

}  // namespace hexatlas::hybrid
