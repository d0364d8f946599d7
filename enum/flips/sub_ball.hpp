#pragma once
/// \file
/// Balls of hexahedra inside a mesh, grown one by one: what an exchange replaces.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/front.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::flips {

/// A flip that glues on a certain hexahedron, whose corners (enum/cells/cube.hpp) are the bottom's
/// and the top's.
struct PlacedFlip {
  Flip flip;
  std::array<cells::CubeVertex, 4> bottom{}, top{};
};

/// The flip that glues a hexahedron on: `corner` has the boundary vertices at its corners,
/// kNewVertex at those not on the boundary; `patch` its facets on the boundary. nullopt if these
/// are no patch of `boundary`. Requires that no two quads of `boundary` have the same vertices.
[[nodiscard]] std::optional<PlacedFlip> flip_of(const complex::Quadrangulation& boundary,
                                                const std::array<complex::Vertex, 8>& corner,
                                                FacetSet patch);

/// A ball of hexahedra inside a mesh.
class SubBall {
 public:
  /// For each hexahedron and facet (enum/cells/cube.hpp) the hexahedron across, or kOutside.
  static constexpr std::uint32_t kOutside = 0xFFFFFFFF;
  using Neighbours = std::vector<std::array<std::uint32_t, 6>>;
  [[nodiscard]] static Neighbours neighbours_of(const complex::HexComplex& mesh);
  /// For each vertex its hexahedra.
  using CellsAt = std::vector<std::vector<std::uint32_t>>;

  /// A single hexahedron. `mesh` obeys the strict rule; it and `neighbours` outlive the ball.
  SubBall(const complex::HexComplex& mesh, const Neighbours& neighbours, std::uint32_t first);

  /// Begins again with a single hexahedron. The mesh may have changed since the ball was begun.
  /// Cost: that of the ball, not of the mesh.
  void restart(std::uint32_t first);

  /// Adds a hexahedron if the result is a ball whose boundary has at most kMaxSearchQuads quads;
  /// otherwise says no and changes nothing.
  bool grow(std::uint32_t cell);
  /// Grows by one of the hexahedra that touch: mostly by one with many facets on the ball, which
  /// keeps the boundary short, the more so the greater the weight; by another one if that is
  /// impossible.
  bool grow_somewhere(core::Random& random, int weight = 4);

  [[nodiscard]] bool contains(std::uint32_t cell) const noexcept { return inside_[cell]; }
  [[nodiscard]] const std::vector<std::uint32_t>& cells() const noexcept { return cells_; }
  [[nodiscard]] const Front& front() const noexcept { return front_; }
  /// Mesh vertex of a vertex of front().boundary.
  [[nodiscard]] complex::VertexId rim(complex::Vertex v) const noexcept { return rim_[v]; }
  /// Vertex of front().boundary at a mesh vertex, or kNewVertex.
  [[nodiscard]] complex::Vertex boundary_vertex(complex::VertexId v) const noexcept {
    return on_rim_[v];
  }
  /// Of the pairs of boundary vertices those that some hexahedron outside contains. Cost: linear
  /// in the mesh, or, where the hexahedra at each vertex are known, in those at the boundary.
  [[nodiscard]] Relation related_outside() const;
  [[nodiscard]] Relation related_outside(const CellsAt& cells_at) const;

 private:
  const complex::HexComplex& mesh_;
  const Neighbours& neighbours_;
  void take_in(std::uint32_t cell);
  void relate(std::uint32_t cell, Relation& related) const;

  std::vector<bool> inside_;
  std::vector<std::uint8_t> shared_;  ///< facets with the ball, of each hexahedron outside
  /// touching_: the hexahedra outside that share a facet with the ball, in no particular order.
  std::vector<std::uint32_t> cells_, touching_;
  Front front_;
  std::array<complex::VertexId, kMaxFrontQuads + 2> rim_{};
  std::vector<complex::Vertex> on_rim_;
};

}  // namespace hexatlas::flips
