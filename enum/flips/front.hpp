#pragma once
/// \file
/// The front of a hexahedral ball: its boundary and all that the strict rule needs to know of
/// its interior.
///
/// Strict rule. Two hexahedra meet in nothing, one vertex, one edge of both, or one quad that is
/// a facet of both. Two vertices are *related* if some hexahedron contains both.
///
/// Theorem (docs/theory/proofs/front.md). Let M be a ball under the strict rule. Gluing a
/// hexahedron C on a patch of the boundary of M gives such a ball if and only if the vertices
/// of C are distinct and two of them that are on the boundary of M are related only if they lie
/// in one quad of the patch. So of the interior only the relation on boundary vertices matters.
/// Related pairs that lie in no boundary quad are the *scars* of M: they are what distinguishes
/// two balls with the same boundary, and fewer scars permit more.

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/quad_flip.hpp"

namespace hexatlas::flips {

/// A set of boundary vertices, one bit each.
using VertexSet = std::uint64_t;

inline constexpr int kMaxFrontQuads = 62;  ///< 64 vertices: one word per vertex set

[[nodiscard]] constexpr VertexSet bit(complex::Vertex v) noexcept { return VertexSet{1} << v; }

/// The vertices of a quad, kNewVertex left out.
[[nodiscard]] constexpr VertexSet set_of(const complex::QuadVertices& vertices) noexcept {
  VertexSet result = 0;
  for (const complex::Vertex v : vertices)
    if (v != kNewVertex) result |= bit(v);
  return result;
}

/// For each vertex the vertices related to it, itself included.
using Relation = std::array<VertexSet, kMaxFrontQuads + 2>;

struct Front {
  complex::Quadrangulation boundary;
  Relation related{};
};

/// Relates all of these vertices to each other.
inline void relate(VertexSet vertices, Relation& related) noexcept {
  for (VertexSet rest = vertices; rest != 0; rest &= rest - 1)
    related[static_cast<std::size_t>(std::countr_zero(rest))] |= vertices;
}

/// The relation of quads alone: two vertices of one quad. It is the relation of a single
/// hexahedron, and of the outer side of any boundary that nothing has been glued to.
[[nodiscard]] Relation relation_of_quads(const complex::Quadrangulation& q);

/// The front of a single hexahedron.
[[nodiscard]] Front single_hexahedron();

/// Whether the hexahedron may be glued on. Requires prism == prism_of(front.boundary, flip).
/// Cost: a few operations per vertex of the hexahedron.
[[nodiscard]] bool may_glue(const Front& front, Flip flip, const Prism& prism) noexcept;

/// The front after gluing, with where its vertices come from. Requires may_glue().
struct Glued {
  Front front;
  Flipped flipped;
};
[[nodiscard]] Glued glued(const Front& front, Flip flip, const Prism& prism);

/// The sets of sides, one bit each, that pass some cheap necessary conditions for prism_of() and
/// may_glue(): a test of most of the 16 sets at once. Cost: that of one or two may_glue().
[[nodiscard]] std::uint16_t possible_sides(const Front& front, complex::Quad bottom) noexcept;

/// The part of for_each_glueable() with this bottom.
template <class Visit>
void for_each_glueable_on(const Front& front, complex::Quad bottom, int max_quads, Visit&& visit) {
  for (unsigned left = possible_sides(front, bottom); left != 0; left &= left - 1) {
    const Flip flip{bottom, static_cast<std::uint8_t>(std::countr_zero(left))};
    const int after = front.boundary.quads() + 6 - 2 * flip.consumed();
    if (after < 6 || after > max_quads) continue;
    const std::optional<Prism> prism = prism_of(front.boundary, flip);
    if (!prism || !may_glue(front, flip, *prism)) continue;
    if (is_preferred(front.boundary, flip)) visit(flip, *prism);
  }
}

/// Calls visit(flip, prism) for each hexahedron that may be glued on so that the boundary has
/// at least 6 and at most `max_quads` quads; once per patch, in increasing order of
/// (bottom, sides). Requires max_quads <= kMaxFrontQuads.
template <class Visit>
void for_each_glueable(const Front& front, int max_quads, Visit&& visit) {
  for (int bottom = 0; bottom < front.boundary.quads(); ++bottom)
    for_each_glueable_on(front, static_cast<complex::Quad>(bottom), max_quads, visit);
}

/// A ball built hexahedron by hexahedron, each glued on a patch of the boundary: a shelling.
/// Undo is exact, since every former front is kept.
class Shelling {
 public:
  using Cell = std::array<std::uint16_t, 8>;  ///< in the numbering of enum/cells/cube.hpp

  /// Starts from the reference cube, whose vertices are 0 .. 7.
  Shelling();

  [[nodiscard]] const Front& front() const noexcept { return steps_.back().front; }
  [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return cells_; }
  [[nodiscard]] int vertices() const noexcept { return steps_.back().vertices; }
  /// Mesh vertex of a boundary vertex.
  [[nodiscard]] std::uint16_t vertex_of(complex::Vertex v) const noexcept {
    return steps_.back().label[v];
  }

  /// Glues a hexahedron on if the strict rule allows it and the boundary then has from 6 to
  /// kMaxFrontQuads quads; otherwise says no and changes nothing. Gives the inverse flip.
  [[nodiscard]] std::optional<Flip> push(Flip flip);
  /// Takes the last hexahedron off. Requires at least two.
  void pop();

 private:
  struct Step {
    Front front;
    std::array<std::uint16_t, complex::kMaxVertices> label{};
    int vertices = 0;
  };
  std::vector<Step> steps_;
  std::vector<Cell> cells_;
};

}  // namespace hexatlas::flips
