#pragma once
/// \file
/// Balls of hexahedra inside a mesh, grown one by one: what an exchange replaces.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/front.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::flips {

/// A ball of hexahedra inside a mesh. For one thread, even where it is const.
class SubBall {
 public:
  /// For each hexahedron and facet (enum/cells/cube.hpp) the hexahedron across, or kOutside.
  static constexpr std::uint32_t kOutside = 0xFFFFFFFF;
  using Neighbours = std::vector<std::array<std::uint32_t, 6>>;
  [[nodiscard]] static Neighbours neighbours_of(const complex::HexComplex& mesh);
  /// The same, or nullopt if not each facet is in one or two hexahedra, in one as often as the
  /// boundary has quads. Requires less than 65,536 vertices.
  [[nodiscard]] static std::optional<Neighbours> neighbours_if_complex(
      const complex::HexComplex& mesh, int quads);
  /// For each vertex its hexahedra.
  using CellsAt = std::vector<std::vector<std::uint32_t>>;

  /// A single hexahedron. `mesh` is glued of hexahedra along facets, and need not obey the strict
  /// rule; it and `neighbours` outlive the ball.
  /// Its boundary will have at most `max_quads` quads, which are at most kMaxStateQuads.
  SubBall(const complex::HexComplex& mesh, const Neighbours& neighbours, std::uint32_t first,
          int max_quads = kMaxStateQuads);

  /// Begins again with a single hexahedron. The mesh may have changed since the ball was begun.
  /// Cost: that of the ball, not of the mesh.
  void restart(std::uint32_t first);

  /// Adds a hexahedron if the result is a ball under the strict rule whose boundary has no more
  /// quads than it may; otherwise says no and changes nothing. Cost: some ten nanoseconds.
  bool grow(std::uint32_t cell);
  /// Grows by one of the hexahedra that touch: mostly by one with many facets on the ball, which
  /// keeps the boundary short, the more so the greater the weight; by another one if that is
  /// impossible.
  bool grow_somewhere(core::Random& random, int weight = 4) {
    return grow_somewhere(random, weight, [](std::uint32_t) { return true; });
  }
  /// The same by one of those hexahedra that `may_take(cell)` admits.
  template <class MayTake>
  bool grow_somewhere(core::Random& random, int weight, MayTake&& may_take);
  /// Grows like that to so many hexahedra. Returns whether it came to them.
  bool grow_to(std::size_t size, core::Random& random, int weight) {
    return grow_to(size, random, weight, [](std::uint32_t) { return true; });
  }
  template <class MayTake>
  bool grow_to(std::size_t size, core::Random& random, int weight, MayTake&& may_take) {
    while (cells_.size() < size)
      if (!grow_somewhere(random, weight, may_take)) return false;
    return true;
  }

  [[nodiscard]] bool contains(std::uint32_t cell) const noexcept { return inside_[cell]; }
  /// In the order in which they were added.
  [[nodiscard]] const std::vector<std::uint32_t>& cells() const noexcept { return cells_; }
  /// The number of quads of its boundary.
  [[nodiscard]] int quads() const noexcept { return quads_; }
  /// Its boundary, in a numbering of its own that changes as the ball grows, and which boundary
  /// vertices a hexahedron inside relates. Cost: linear in the ball when it has just grown, so ask
  /// for this only of balls of interest.
  [[nodiscard]] const Front& front() const { return rim_now().front; }
  /// Mesh vertex of a vertex of front().boundary.
  [[nodiscard]] complex::VertexId rim(complex::Vertex v) const { return rim_now().vertex[v]; }
  /// Vertex of front().boundary at a mesh vertex, or kNewVertex.
  [[nodiscard]] complex::Vertex boundary_vertex(complex::VertexId v) const {
    return rim_now().at[v];
  }
  /// Of the pairs of boundary vertices those that some hexahedron outside contains. Cost: linear
  /// in the mesh, or, where the hexahedra at each vertex are known, in those at the boundary.
  [[nodiscard]] Relation related_outside() const;
  [[nodiscard]] Relation related_outside(const CellsAt& cells_at) const;

 private:
  /// A hexahedron of the ball that contains a certain vertex, and the next such one.
  struct Link {
    std::uint32_t cell = 0;
    std::uint32_t next = 0;  ///< place among the links plus 1, 0: none
  };
  /// The boundary, made when it is asked for.
  struct Rim {
    bool is_current = false;
    Front front;
    int vertices = 0;
    std::array<complex::VertexId, kMaxStateQuads + 2> vertex{};
    std::vector<complex::Vertex> at;  ///< of each mesh vertex
  };

  void take_in(std::uint32_t cell);
  [[nodiscard]] bool are_related(complex::VertexId u, complex::VertexId v) const noexcept;
  [[nodiscard]] bool may_take_in(std::uint32_t cell, FacetSet patch) const noexcept;
  const Rim& rim_now() const;
  void forget_rim() const;
  void make_rim() const;
  void relate_vertices_of(std::uint32_t cell, Relation& related) const;

  const complex::HexComplex& mesh_;
  const Neighbours& neighbours_;
  std::vector<bool> inside_;
  std::vector<std::uint8_t> shared_;  ///< facets with the ball, of each hexahedron outside
  /// touching_: the hexahedra outside that share a facet with the ball, in no particular order.
  std::vector<std::uint32_t> cells_, touching_;
  std::vector<complex::VertexId> reached_;  ///< the vertices of the ball
  std::vector<std::uint32_t> first_link_;   ///< of each mesh vertex: place plus 1, 0: not reached
  std::vector<Link> links_;
  int max_quads_;
  int quads_ = 0;
  std::vector<std::pair<int, std::uint32_t>> candidates_;  ///< of grow_somewhere()
  mutable Rim rim_;
};

template <class MayTake>
bool SubBall::grow_somewhere(core::Random& random, int weight, MayTake&& may_take) {
  candidates_.clear();
  for (const std::uint32_t cell : touching_)
    if (may_take(cell))
      candidates_.emplace_back(weight * shared_[cell] + static_cast<int>(random.below(6)), cell);
  while (!candidates_.empty()) {
    const auto best = std::max_element(candidates_.begin(), candidates_.end());
    if (grow(best->second)) return true;
    *best = candidates_.back();
    candidates_.pop_back();
  }
  return false;
}

}  // namespace hexatlas::flips
