#pragma once
/// \file
/// Private to meshing/hybrid: the quads around one vertex, as the search for cells joins them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "meshing/hybrid/corners.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

/// The fourth vertex of a quad a x z y, with its position among the neighbours of x and of y.
struct Fourth {
  Index z = 0;
  std::uint32_t at_x = 0, at_y = 0;
};

/// Quads at a between two of its neighbours: those after `first` in the list of fourth vertices.
/// `is_swapped`: there x and y have changed their places.
struct Partner {
  std::uint32_t y = 0;  ///< position among the neighbours of a
  std::uint32_t first = 0, count = 0;
  bool is_swapped = false;
};

/// The quads at a vertex a whose other vertices come after it.
class Around {
 public:
  Around(const TetGraph& graph, const Corners& corners) : graph_(&graph), corners_(&corners) {}

  void visit(Index a);
  [[nodiscard]] Index vertex() const noexcept { return a_; }

  /// Of the neighbour at position x: neighbours y with quads between, ascending.
  [[nodiscard]] std::span<const Partner> partners(std::uint32_t x) const noexcept {
    return std::span(partners_).subspan(row_[x], row_[x + 1] - row_[x]);
  }
  /// The first position of a neighbour after a.
  [[nodiscard]] std::uint32_t first_after() const noexcept { return first_after_; }
  [[nodiscard]] std::uint32_t degree() const noexcept {
    return static_cast<std::uint32_t>(row_.size() - 1);
  }

  [[nodiscard]] std::span<const Fourth> fourths(const Partner& partner) const noexcept {
    return std::span(fourths_).subspan(partner.first, partner.count);
  }
  /// A tetrahedron (a, p, q, r) with det > 0: it lies on the positive side of the triangle a p q.
  struct Beyond {
    Index p = 0, q = 0, r = 0;
    TetIndex tetrahedron = 0;
  };
  /// Three for each tetrahedron at a, ascending by p, then q.
  [[nodiscard]] std::span<const Beyond> triangles() const noexcept { return triangles_; }
  /// The one on the positive side of a p q; nothing if there is none.
  [[nodiscard]] const Beyond* beyond(Index p, Index q) const noexcept;

 private:
  void gather_triangles();
  void gather_quads();

  const TetGraph* graph_;
  const Corners* corners_;
  Index a_ = 0;
  std::uint32_t first_after_ = 0;
  std::vector<Fourth> fourths_;
  std::vector<std::size_t> row_;
  std::vector<Partner> partners_;
  std::vector<Beyond> triangles_;
};

}  // namespace hexatlas::hybrid
