#pragma once
/// \file
/// Meshes made smaller by exchanging a ball of their hexahedra for a smaller one.
///
/// Let G be hexahedra of a mesh M whose union is a ball, and B a ball with the same boundary. The
/// exchange (M without G) and B obeys the strict rule if and only if no pair of boundary vertices
/// of G is a scar of both B and the rest of M (docs/theory/proofs/front.md, section 5). Here G
/// grows hexahedron by hexahedron from a random one, and every ball that it passes is looked up
/// among the states of a beam.
///
/// Source. Exchange of cavities: Verhetsel, Pellerin, Remacle (IMR 2018) by search of each cavity;
/// the look-up by scars is of this project.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"

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

/// A ball of hexahedra inside a mesh, grown one by one.
class SubBall {
 public:
  /// For each hexahedron and facet (enum/cells/cube.hpp) the hexahedron across, or kOutside.
  static constexpr std::uint32_t kOutside = 0xFFFFFFFF;
  using Neighbours = std::vector<std::array<std::uint32_t, 6>>;
  [[nodiscard]] static Neighbours neighbours_of(const complex::HexComplex& mesh);

  /// A single hexahedron. `mesh` obeys the strict rule; it and `neighbours` outlive the ball.
  SubBall(const complex::HexComplex& mesh, const Neighbours& neighbours, std::uint32_t first);

  /// Adds a hexahedron if the result is a ball whose boundary has at most kMaxSearchQuads quads;
  /// otherwise says no and changes nothing.
  bool grow(std::uint32_t cell);

  [[nodiscard]] bool contains(std::uint32_t cell) const noexcept { return inside_[cell]; }
  [[nodiscard]] const std::vector<std::uint32_t>& cells() const noexcept { return cells_; }
  /// The hexahedra outside that share a facet with the ball, in no particular order, and how many
  /// facets one shares with it.
  [[nodiscard]] const std::vector<std::uint32_t>& touching() const noexcept { return touching_; }
  [[nodiscard]] int shared(std::uint32_t cell) const noexcept { return shared_[cell]; }
  [[nodiscard]] const Front& front() const noexcept { return front_; }
  /// Mesh vertex of a vertex of front().boundary.
  [[nodiscard]] complex::VertexId rim(complex::Vertex v) const noexcept { return rim_[v]; }
  /// Vertex of front().boundary at a mesh vertex, or kNewVertex.
  [[nodiscard]] complex::Vertex boundary_vertex(complex::VertexId v) const noexcept {
    return on_rim_[v];
  }
  /// Of the pairs of boundary vertices those that some hexahedron outside contains.
  [[nodiscard]] Relation related_outside() const;

 private:
  const complex::HexComplex& mesh_;
  const Neighbours& neighbours_;
  void take_in(std::uint32_t cell);

  std::vector<bool> inside_;
  std::vector<std::uint8_t> shared_;
  std::vector<std::uint32_t> cells_, touching_;
  Front front_;
  std::array<complex::VertexId, kMaxFrontQuads + 2> rim_{};
  std::vector<complex::Vertex> on_rim_;
};

struct ReplacementOptions {
  int growths = 100;  ///< balls grown, each from a hexahedron chosen at random
  std::uint64_t seed = 1;
  /// Only exchanges after which the mesh has a shelling as add_ball() requires; and the hexahedra
  /// of the result can be taken off in the order given.
  bool keep_shellable = true;
  /// How many hexahedra more than the least mesh so far the meshes on the way may have: to leave
  /// what no exchange makes smaller at once. Deterministic threshold accepting, with returns to the
  /// least mesh: Dueck, Scheuer (J. Comput. Phys. 90, 1990).
  unsigned uphill = 0;
};

/// A mesh with the same boundary and fewer hexahedra, or nullopt if none was found. The vertices of
/// the boundary, 0 .. quads+1, stay; the others are numbered anew. Exchanges that leave the number
/// of hexahedra as it is are made on the way. Requires that the mesh is a ball under the strict
/// rule, right-handed, and that `balls` grew from the single hexahedron. Deterministic. Safe to
/// call from several threads.
/// Cost: a few microseconds per ball passed.
[[nodiscard]] std::optional<complex::HexComplex> smaller_by_replacement(
    const complex::HexComplex& mesh, int quads, const Beam& balls,
    const ReplacementOptions& options);

/// The same mesh with its hexahedra in an order in which they can be taken off, all boundaries
/// having at most kMaxSearchQuads quads; nullopt if none was found, which proves nothing. Requires
/// a ball under the strict rule. Deterministic. Cost: microseconds per try and hexahedron.
[[nodiscard]] std::optional<complex::HexComplex> in_shelling_order(const complex::HexComplex& mesh,
                                                                   int tries, std::uint64_t seed);

/// Adds the ball to a beam that grew from the single hexahedron, with all balls on the way to it.
/// `mesh` as above: its hexahedra can be taken off in the order given. Returns the state of the
/// whole ball or one that dominates it.
FrontId add_ball(Beam& balls, const complex::HexComplex& mesh, FrontOrigin origin);

}  // namespace hexatlas::flips
