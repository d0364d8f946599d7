#pragma once
/// \file
/// Some hexahedra of a mesh with a given boundary, and what the strict rule leaves open: the state
/// of an exhaustive search.
///
/// Two vertices of a hexahedron are an edge, a facet diagonal or a body diagonal of it. A set of
/// hexahedra obeys the strict rule (enum/complex/hex_complex.hpp) if and only if each pair of
/// vertices is of one kind in all of them, a body diagonal is in one hexahedron only, and all that
/// contain a facet diagonal share its facet (docs/theory/proofs/strict-rule.md). So the state is
/// the kind of each pair, and of each facet whether a hexahedron is still due on it: then it is
/// *open*. At first the facets are the quads of the boundary, all open.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::hexes {

using Vertex = std::uint8_t;
using VertexSet = std::uint64_t;

inline constexpr int kMaxMeshVertices = 64;  ///< boundary vertices included: one word per set
inline constexpr int kMaxHexahedra = 64;
inline constexpr int kHexahedronWeight = 16;
inline constexpr int kMaxFacets = complex::kMaxQuads + 5 * kMaxHexahedra;

[[nodiscard]] constexpr VertexSet bit(std::size_t v) noexcept { return VertexSet{1} << v; }

/// The vertices of a facet, around it.
using Facet = std::array<Vertex, 4>;

/// How many vertices may be new.
struct NewVertices {
  int all = 0;
  std::array<int, 2> of_colour{kMaxMeshVertices, kMaxMeshVertices};

  [[nodiscard]] bool permit(unsigned colour) const noexcept {
    return all > 0 && of_colour[colour] > 0;
  }
  [[nodiscard]] bool are_negative() const noexcept {
    return all < 0 || of_colour[0] < 0 || of_colour[1] < 0;
  }
  void add(unsigned colour, int count) noexcept {
    all += count;
    of_colour[colour] += count;
  }
};

/// Bottom vertices b0 .. b3 around a facet, then the top vertices t0 .. t3 above them.
using Cell = std::array<Vertex, 8>;

/// A facet of a Cell as places in it, and the places above its corners.
struct TurnedFacet {
  std::array<std::uint8_t, 4> facet, above;
};
/// The bottom, the top, and the sides in the order in which they become facets of the mesh.
inline constexpr std::array<TurnedFacet, 6> kTurnedFacets{{{{0, 1, 2, 3}, {4, 5, 6, 7}},
                                                           {{4, 5, 6, 7}, {0, 1, 2, 3}},
                                                           {{0, 1, 5, 4}, {3, 2, 6, 7}},
                                                           {{1, 2, 6, 5}, {0, 3, 7, 4}},
                                                           {{2, 3, 7, 6}, {1, 0, 4, 5}},
                                                           {{3, 0, 4, 7}, {2, 1, 5, 6}}}};
/// The vertices of a cell above the corners of one of its facets, given in any order around it.
[[nodiscard]] Facet tops_over(const Cell& cell, const Facet& facet) noexcept;

/// A set of facets, by number.
class FacetSet {
 public:
  void add(int facet) noexcept { words_[word(facet)] |= mask(facet); }
  void remove(int facet) noexcept { words_[word(facet)] &= ~mask(facet); }
  [[nodiscard]] bool has(int facet) const noexcept {
    return (words_[word(facet)] & mask(facet)) != 0;
  }
  /// How many members are less than a facet: the place of a member.
  [[nodiscard]] std::size_t place_of(int facet) const noexcept {
    std::size_t place = 0;
    for (std::size_t w = 0; w < word(facet); ++w)
      place += static_cast<std::size_t>(std::popcount(words_[w]));
    return place + static_cast<std::size_t>(std::popcount(words_[word(facet)] & (mask(facet) - 1)));
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t w = 0; w < words_.size(); ++w)
      for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
        visit(static_cast<int>(64 * w) + std::countr_zero(left));
  }

 private:
  [[nodiscard]] static std::size_t word(int facet) noexcept {
    return static_cast<std::size_t>(facet) / 64;
  }
  [[nodiscard]] static std::uint64_t mask(int facet) noexcept {
    return std::uint64_t{1} << (static_cast<unsigned>(facet) % 64);
  }
  std::array<std::uint64_t, (kMaxFacets + 63) / 64> words_{};
};

/// A hexahedron grows on an open facet, the *bottom*, by one top vertex after the other; with the
/// fourth it is complete. Undo is exact.
class PartialMesh {
 public:
  /// Requires a 3-connected quadrangulation, boundary.vertices() <= max_vertices <=
  /// kMaxMeshVertices. `ball`: edges join two colours, and a vertex or an edge without open facets
  /// takes no further hexahedron, as in every ball.
  PartialMesh(const complex::Quadrangulation& boundary, int max_vertices, bool ball);

  [[nodiscard]] bool is_for_balls() const noexcept { return ball_; }

  [[nodiscard]] int vertices() const noexcept { return vertices_; }
  [[nodiscard]] int boundary_vertices() const noexcept { return boundary_vertices_; }
  /// How many more vertices there may be.
  [[nodiscard]] const NewVertices& new_vertices() const noexcept { return new_vertices_; }
  /// How many more there may be if they are at most so many. Where the mesh is balanced they are
  /// negative if there is no balance with as few.
  [[nodiscard]] NewVertices new_vertices(int most) const noexcept;
  [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return cells_; }
  [[nodiscard]] const FacetSet& open() const noexcept { return open_; }
  [[nodiscard]] int open_count() const noexcept { return open_count_; }
  [[nodiscard]] const Facet& facet(int number) const noexcept {
    return facets_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] bool is_open(int number) const noexcept { return open_.has(number); }
  /// The number of the facet with this diagonal, or -1.
  [[nodiscard]] int facet_at(std::size_t u, std::size_t v) const noexcept { return at_[u][v]; }
  /// The hexahedra with this facet; -1 for none.
  [[nodiscard]] const std::array<std::int16_t, 2>& cells_on(int facet) const noexcept {
    return cells_on_[static_cast<std::size_t>(facet)];
  }
  [[nodiscard]] bool is_interior(int v) const noexcept { return v >= boundary_vertices_; }
  /// Hexahedra at a vertex.
  [[nodiscard]] int cells_at(int v) const noexcept {
    return cells_at_[static_cast<std::size_t>(v)];
  }

  /// The vertices there are that may be above corner i of an open facet, as far as pairs with the
  /// facet and the sides of a hexahedron there tell, less those barred.
  [[nodiscard]] VertexSet tops_over(int number, std::size_t i) const noexcept;
  /// Whether a new vertex may be above a corner at v.
  [[nodiscard]] bool may_be_new_over(Vertex v, const NewVertices& new_vertices) const noexcept {
    return new_vertices.permit(other_colour(v)) && !is_saturated(v);
  }
  /// Open facets at a vertex.
  [[nodiscard]] int open_at(Vertex v) const noexcept { return open_at_[v]; }
  /// Open facets at the edge uv.
  [[nodiscard]] int open_at(Vertex u, Vertex v) const noexcept { return open_at_edge_[u][v]; }
  /// Euler characteristic of the part of the link of v that is there, as a part of a sphere: the
  /// outside of the boundary is a face of it.
  [[nodiscard]] int link_euler(Vertex v) const noexcept {
    const int edges = std::popcount(edges_from(v));
    const int facets = std::popcount(diagonals_from(v));
    return edges - facets + cells_at_[v] + (is_interior(v) ? 0 : 1);
  }
  /// Euler characteristic of the part of the 3-sphere that is there: the hexahedra, the boundary,
  /// and the outside.
  [[nodiscard]] int euler() const noexcept {
    return vertices_ - edge_count_ + facet_count_ - static_cast<int>(cells_.size()) - 1;
  }

  /// Vertices with open facets.
  [[nodiscard]] VertexSet open_vertices() const noexcept { return open_vertices_; }
  /// Those of them that share no hexahedron with v yet, nor a quad of the boundary.
  [[nodiscard]] VertexSet unrelated_open(Vertex v) const noexcept {
    return open_vertices_ & ~related_[v];
  }
  [[nodiscard]] VertexSet of_other_colour(Vertex v) const noexcept {
    return colour_[other_colour(v)];
  }
  [[nodiscard]] unsigned other_colour(Vertex v) const noexcept { return 1U - colour_of_[v]; }

  /// From now on the new vertices of the two colours are limited by what they are in every ball
  /// with at most as many interior vertices: their difference is known (section 9 of the proof
  /// note). False if there is no such ball. Requires a state without hexahedra, for balls.
  [[nodiscard]] bool balance() noexcept;

  /// From now on these vertices are not put above a corner of a facet, beside those barred so far,
  /// which are returned.
  VertexSet bar_tops(int facet, std::size_t corner, VertexSet tops) noexcept {
    VertexSet& barred = barred_tops_[static_cast<std::size_t>(facet)][corner];
    return std::exchange(barred, barred | tops);
  }
  /// From now on these are barred there, and no others.
  void permit_tops(int facet, std::size_t corner, VertexSet barred) noexcept {
    barred_tops_[static_cast<std::size_t>(facet)][corner] = barred;
  }

  /// From now on no edge is added at these vertices. Requires that only balls are asked for.
  void saturate(VertexSet vertices) noexcept { saturated_ = vertices; }
  [[nodiscard]] VertexSet saturated() const noexcept { return saturated_; }
  [[nodiscard]] bool is_saturated(Vertex v) const noexcept { return (saturated_ & bit(v)) != 0; }

  /// Begins a hexahedron. Requires that none is begun and the facet is open.
  void begin(int bottom) noexcept;
  [[nodiscard]] bool has_begun() const noexcept { return bottom_ >= 0; }
  [[nodiscard]] int bottom() const noexcept { return bottom_; }
  /// The vertices that may be the next top vertex; vertices() stands for a new one. With the last
  /// one the hexahedron obeys the strict rule. `new_vertices`: what all tops may bring. Requires a
  /// hexahedron begun.
  [[nodiscard]] VertexSet next_tops(const NewVertices& new_vertices) const noexcept;
  /// The hexahedra that may be put on an open facet, with at most `new_vertices`, which are the
  /// sequences of put(): the sum of kHexahedronWeight, halved for each new vertex, over them, or
  /// something not less than `limit`. Requires that none is begun.
  [[nodiscard]] int weight_on(int facet, const NewVertices& new_vertices, int limit) noexcept;
  /// Puts the next top vertex there; with the fourth one the hexahedron is complete, and none is
  /// begun. Requires an element of next_tops().
  void put(Vertex top);
  /// Takes the last top vertex off again. What begin() did stays if it was the first one.
  void take_off() noexcept;
  /// Whether the last put() completed a hexahedron.
  [[nodiscard]] bool has_just_completed() const noexcept { return bottom_ < 0 || tops_ == 0; }

 private:
  struct Step {
    VertexSet edges = 0, diagonals = 0;  ///< vertices whose pairs with the top are new ones
    Vertex top = 0;
    bool is_new = false;
  };
  struct Completed {
    int bottom = 0;
    int facets = 0;  ///< there were before
    int closed_count = 0;
    std::array<int, 6> closed{};
  };

  /// The vertices that may be above each corner of a facet; vertices() stands for a new one.
  using Tops = std::array<VertexSet, 4>;
  struct NewTops {
    NewVertices left;
    int each = 0;  ///< weight of a hexahedron without more of them
  };
  [[nodiscard]] int weight_of_tops(std::size_t i, const Tops& tops, const NewTops& then,
                                   int limit) noexcept;
  /// Across a facet.
  [[nodiscard]] Vertex opposite(int number, Vertex v) const noexcept;
  /// The vertices that have a facet diagonal with v.
  [[nodiscard]] VertexSet diagonals_from(Vertex v) const noexcept {
    return not_edge_[v] & ~not_diagonal_[v];
  }
  [[nodiscard]] VertexSet bent_at(Vertex from, Vertex corner) const noexcept;
  [[nodiscard]] VertexSet closing(Vertex p, Vertex q, Vertex r) const noexcept;
  [[nodiscard]] VertexSet fitting_tops(std::size_t i, VertexSet tops) const noexcept;
  void relate(std::size_t i, Vertex top, Step& step) noexcept;
  void unrelate(std::size_t i, const Step& step) noexcept;
  void complete();
  void undo_complete() noexcept;
  /// The other ends of the edges that are there.
  [[nodiscard]] VertexSet edges_from(Vertex v) const noexcept {
    return not_diagonal_[v] & ~not_edge_[v];
  }
  /// The vertices that make with v no edge of a further hexahedron.
  [[nodiscard]] VertexSet no_edge_from(Vertex v) const noexcept {
    if (!ball_) return not_edge_[v];
    const VertexSet no_new_edge = is_saturated(v) ? ~VertexSet{0} : saturated_;
    return not_edge_[v] | closed_edge_[v] | (no_new_edge & ~edges_from(v));
  }
  [[nodiscard]] bool may_be_new(std::size_t i, const NewVertices& left) const noexcept;
  [[nodiscard]] NewVertices without_new_tops(NewVertices new_vertices) const noexcept;
  void open(int number) noexcept;
  void close(int number) noexcept;
  void add_vertex(Vertex v, unsigned colour) noexcept;
  void remove_vertex(Vertex v) noexcept;

  int boundary_vertices_, vertices_ = 0;
  NewVertices new_vertices_;
  bool ball_, is_balanced_ = false;
  VertexSet all_ = 0;
  std::array<VertexSet, 2> colour_{};
  std::array<std::uint8_t, kMaxMeshVertices> colour_of_{};
  /// For each vertex those that make with it no edge, no facet diagonal, no new pair: those of the
  /// other kinds and itself.
  std::array<VertexSet, kMaxMeshVertices> not_edge_{}, not_diagonal_{}, related_{};
  /// The neighbours of a vertex along edges without an open facet.
  std::array<VertexSet, kMaxMeshVertices> closed_edge_{};
  VertexSet open_vertices_ = 0;
  VertexSet saturated_ = 0;
  template <class T>
  using PerPair = std::array<std::array<T, kMaxMeshVertices>, kMaxMeshVertices>;
  PerPair<std::int16_t> at_{};
  /// For a corner v and a vertex u the third vertices of the open facets with u, v, . in a row.
  PerPair<VertexSet> beyond_{};
  PerPair<std::uint8_t> open_at_edge_{};
  std::array<std::uint8_t, kMaxMeshVertices> open_at_{};
  std::array<std::uint8_t, kMaxMeshVertices> cells_at_{};
  std::array<Facet, kMaxFacets> facets_{};
  std::array<std::array<std::int16_t, 2>, kMaxFacets> cells_on_{};
  std::array<std::array<VertexSet, 4>, kMaxFacets> barred_tops_{};
  int facet_count_ = 0, edge_count_ = 0;
  FacetSet open_;
  int open_count_ = 0;
  std::vector<Cell> cells_;
  int bottom_ = -1;
  std::size_t tops_ = 0;  ///< of the hexahedron begun
  std::array<Vertex, 4> top_{};
  std::vector<Step> steps_;
  std::vector<Completed> completed_;
};

}  // namespace hexatlas::hexes
