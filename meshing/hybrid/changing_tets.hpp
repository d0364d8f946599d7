#pragma once
/// \file
/// Private to meshing/hybrid: tetrahedra of which some belong to cells and some are replaced. What
/// replaces them is of their region, and no facet between regions, or of a surface, is replaced.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "meshing/hybrid/glued_tets.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

/// The facet of a tetrahedron opposite to its vertex `facet`.
struct Side {
  TetIndex tetrahedron = TetGraph::kOutside;
  unsigned facet = 0;
};

/// Free tetrahedra around an edge, from one triangle at it to another: vertices[i] and
/// vertices[i + 1] lie opposite to the edge in tetrahedra[i].
struct Fan {
  std::vector<TetIndex> tetrahedra;
  std::vector<Index> vertices;
};

class ChangingTets {
 public:
  using Owner = std::uint32_t;
  static constexpr Owner kFree = 0xFFFF'FFFF;     ///< owned by no cell
  static constexpr Owner kGone = 0xFFFF'FFFE;     ///< replaced
  static constexpr Owner kPyramid = 0xFFFF'FFFD;  ///< half of an inserted pyramid

  explicit ChangingTets(const TetGraph& graph);

  [[nodiscard]] std::size_t size() const noexcept { return tets_.size(); }
  [[nodiscard]] const Tetrahedron& operator[](TetIndex t) const noexcept { return tets_[t]; }
  [[nodiscard]] TetIndex across(Side side) const noexcept {
    return tets_.across(side.tetrahedron, side.facet);
  }
  [[nodiscard]] Owner owner(TetIndex t) const noexcept { return owner_[t]; }
  void own(TetIndex t, Owner owner) noexcept { owner_[t] = owner; }
  /// Whether any has another region than 0.
  [[nodiscard]] bool has_regions() const;
  [[nodiscard]] std::uint32_t region(TetIndex t) const noexcept { return regions_[t]; }
  /// Whether the facet has to stay: it is on the boundary, between two regions, or on a surface.
  [[nodiscard]] bool has_to_stay(Side side) const;

  /// The tetrahedra around the edge p r, from the triangle p r `from` of the tetrahedron `first`
  /// on, to the triangle p r `to`. If one is not free, the answer is its owner; kGone, which none
  /// has, stands for the outside, and for what lies beyond a facet that has to stay.
  struct FanAnswer {
    Fan fan;
    std::optional<Owner> obstacle;
  };
  [[nodiscard]] FanAnswer fan(Index p, Index r, Index from, Index to, TetIndex first) const;

  /// Puts tetrahedra in the place of others with the same union, each with its owner.
  /// Requires that the boundary of both is the same, and that no facet between the old ones has to
  /// stay.
  void replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh,
               std::span<const Owner> owners);

 private:
  GluedTets tets_;
  std::vector<Owner> owner_;
  std::vector<std::uint32_t> regions_;
  std::set<std::array<Index, 3>> on_surfaces_;  ///< triangles inside, vertices ascending
};

}  // namespace hexatlas::hybrid
