#pragma once
/// \file
/// Internal to the judge: the states of a certificate of a lower bound (docs/formats/bound.md),
/// with the relations of pairs of vertices and the counts that its rules ask for.
///
/// Preconditions: the quads are a 3-connected quadrangulation of the sphere on the vertices
/// 0 .. n + 1, and vertices stay below kMostBoundVertices. Errors: none; what may not be put is a
/// value. Cost: a hexahedron is put and taken back in constant time.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

inline constexpr std::size_t kMostBoundVertices = 64;

/// The vertices of a facet around it, or the four tops of a hexahedron.
using BoundCorners = std::array<std::uint8_t, 4>;

/// The bottom, then the tops above its vertices.
using BoundHexahedron = std::array<std::uint8_t, 8>;

/// Bit v is vertex v.
using VertexSet = std::uint64_t;

[[nodiscard]] constexpr VertexSet vertex_set(const BoundCorners& corners) noexcept {
  VertexSet set = 0;
  for (const std::uint8_t v : corners) set |= VertexSet{1} << v;
  return set;
}

/// How many new vertices there may be.
struct BoundNewVertices {
  int all = 0;
  std::array<int, 2> of_colour = {kMostBoundVertices, kMostBoundVertices};  ///< light, dark
};

enum class PairRelation : std::uint8_t { kFree, kEdge, kFacetDiagonal, kBodyDiagonal };

struct BoundFacet {
  BoundCorners corners{};
  VertexSet vertices = 0;
  bool is_open = false;
};

/// How many there are at a vertex.
struct VertexCounts {
  int edges = 0;
  int facets = 0;
  int hexahedra = 0;
  int open_facets = 0;
};

struct PlacedHexahedron {
  BoundHexahedron vertices{};
  std::array<std::uint16_t, 6> facets{};  ///< the bottom, then the others in the format's order
  // What there was before it.
  std::size_t old_vertices = 0;
  std::size_t old_facets = 0;
  std::size_t old_pairs = 0;
};

class BoundState {
 public:
  /// The empty state. `is_ball`: only what is a ball counts as a mesh.
  BoundState(std::span<const Quad> quads, bool is_ball);

  [[nodiscard]] bool is_ball() const noexcept { return is_ball_; }
  [[nodiscard]] std::size_t boundary_vertices() const noexcept { return boundary_vertices_; }
  [[nodiscard]] std::size_t boundary_quads() const noexcept { return boundary_vertices_ - 2; }
  [[nodiscard]] std::size_t vertices() const noexcept { return vertices_; }
  [[nodiscard]] std::size_t edges() const noexcept { return edges_; }
  [[nodiscard]] const std::vector<BoundFacet>& facets() const noexcept { return facets_; }
  [[nodiscard]] const std::vector<PlacedHexahedron>& hexahedra() const noexcept { return placed_; }
  [[nodiscard]] const VertexCounts& at(std::size_t v) const noexcept { return at_[v]; }
  [[nodiscard]] bool is_interior(std::size_t v) const noexcept { return v >= boundary_vertices_; }

  /// The two colours of a bipartition by edges: that of vertex 0 is light. Kept for balls only.
  [[nodiscard]] bool is_dark(std::size_t v) const noexcept { return (dark_ >> v & 1U) != 0; }

  /// Vertices at which no further edge ends, in any ball that follows.
  [[nodiscard]] VertexSet saturated() const noexcept { return saturated_; }
  void saturate(VertexSet vertices) noexcept { saturated_ = vertices; }

  /// Numbers of the open facets, ascending: place P of a record is element P.
  [[nodiscard]] std::vector<std::uint16_t> open_facets() const;
  [[nodiscard]] std::size_t open_count() const noexcept { return open_count_; }
  [[nodiscard]] int open_at_edge(std::size_t u, std::size_t v) const noexcept {
    return open_at_edge_[u][v];
  }

  [[nodiscard]] PairRelation relation(std::size_t u, std::size_t v) const noexcept {
    return relation_[u][v];
  }
  [[nodiscard]] bool is_free(std::size_t u, std::size_t v) const noexcept {
    return relation_[u][v] == PairRelation::kFree;
  }
  /// The facet of a facet diagonal.
  [[nodiscard]] const BoundFacet& facet_of_diagonal(std::size_t u, std::size_t v) const {
    return facets_[facet_of_[u][v]];
  }

  /// u v may be an edge of a hexahedron to come.
  [[nodiscard]] bool may_be_edge(std::size_t u, std::size_t v) const noexcept;
  /// u v may be a diagonal of one of its facets.
  [[nodiscard]] bool may_be_diagonal(std::size_t u, std::size_t v) const noexcept;
  /// A facet of it with these corners is either new or open.
  [[nodiscard]] bool may_be_facet(const BoundCorners& corners) const;
  /// u may be above corner i of an open facet; u is there already.
  [[nodiscard]] bool may_be_above(std::size_t u, const BoundFacet& facet, unsigned i) const;

  /// The tops of all hexahedra with at most `most` new vertices that may be put on an open facet,
  /// in lexicographic order; new vertices have the next numbers. Requires that all these are below
  /// kMostBoundVertices.
  [[nodiscard]] std::vector<BoundCorners> tops_on(std::size_t facet,
                                                  const BoundNewVertices& most) const;

  /// Requires that the hexahedron may be put there.
  void put(std::size_t facet, const BoundCorners& tops);
  /// Undoes the last put.
  void take_back();

 private:
  template <class Value>
  using PairTable = std::array<std::array<Value, kMostBoundVertices>, kMostBoundVertices>;
  class TopSearch;

  std::uint16_t add_facet(const BoundCorners& corners);
  void set_open(std::size_t facet, bool is_open);
  void relate(std::size_t u, std::size_t v, PairRelation relation, std::size_t facet);
  void unrelate_last();
  [[nodiscard]] bool may_bend(std::size_t u, std::size_t corner, std::size_t v) const;
  void colour_boundary();

  bool is_ball_;
  std::size_t boundary_vertices_;
  std::size_t vertices_;
  std::size_t edges_ = 0;
  std::size_t open_count_ = 0;
  VertexSet dark_ = 0;
  VertexSet saturated_ = 0;
  std::vector<BoundFacet> facets_;
  std::vector<PlacedHexahedron> placed_;
  std::vector<std::pair<std::uint8_t, std::uint8_t>> related_;  ///< in the order of relate()
  std::array<VertexCounts, kMostBoundVertices> at_{};
  PairTable<PairRelation> relation_{};
  PairTable<std::uint16_t> facet_of_{};
  PairTable<std::uint8_t> open_at_edge_{};
};

/// The bottom and the further facets of a hexahedron, in the order of the format.
[[nodiscard]] std::array<BoundCorners, 6> facets_of(const BoundHexahedron& hexahedron);

}  // namespace hexatlas::check
