#pragma once
/// \file
/// Private to the filling by lattices: tetrahedra that fill a convex body and are exchanged for
/// others with the same union.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshing/hybrid/glued_tets.hpp"
#include "meshing/mesh/mesh.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::hybrid {

class FlippedTets {
 public:
  static constexpr TetIndex kOutside = GluedTets::kOutside;

  /// Requires right-handed tetrahedra of which no two overlap, fewer than 2^30, that meet in common
  /// facets and have all points as vertices. The points have to stay where they are.
  FlippedTets(std::span<const mesh::Point> points, std::vector<Tetrahedron> tetrahedra);

  /// Of the list, with those that were replaced.
  [[nodiscard]] std::size_t size() const noexcept { return tets_.size(); }
  [[nodiscard]] bool is_there(TetIndex t) const noexcept { return is_gone_[t] == 0; }
  [[nodiscard]] const Tetrahedron& operator[](TetIndex t) const noexcept { return tets_[t]; }
  /// Beyond the facet opposite to a vertex of t.
  [[nodiscard]] TetIndex across(TetIndex t, std::size_t facet) const noexcept {
    return tets_.across(t, facet);
  }
  [[nodiscard]] std::span<const mesh::Point> points() const noexcept { return points_; }
  [[nodiscard]] exact::Sign orientation(Index a, Index b, Index c, Index d) const;

  /// The tetrahedra at a vertex, until the next question.
  [[nodiscard]] std::span<const TetIndex> star(Index v) const;
  /// One that has these vertices, if there is one.
  [[nodiscard]] std::optional<TetIndex> with(std::span<const Index> vertices) const;

  /// The tetrahedra around an edge a b inside the body: tetrahedra[i] is a b v_i v_(i+1),
  /// right-handed in this order.
  struct Ring {
    std::vector<TetIndex> tetrahedra;
    std::vector<Index> vertices;
  };
  /// Requires a tetrahedron with both; nothing if the edge is on the boundary of the body.
  [[nodiscard]] std::optional<Ring> ring(Index a, Index b, TetIndex at) const;

  /// Requires right-handed tetrahedra with the same union and the same boundary.
  void replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh);

 private:
  std::span<const mesh::Point> points_;
  GluedTets tets_;
  std::vector<std::uint8_t> is_gone_;
  std::vector<TetIndex> at_;  ///< one per vertex
  mutable std::vector<std::uint32_t> seen_;
  mutable std::uint32_t question_ = 0;
  mutable std::vector<TetIndex> found_;
};

}  // namespace hexatlas::hybrid
