#pragma once
/// \file
/// Lower bounds for what is missing from a partial mesh: each one refutes states from which no mesh
/// within the limits follows. Definitions and proofs: docs/theory/proofs/hexahedral-search.md.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "enum/hexes/partial_mesh.hpp"

namespace hexatlas::hexes {

/// Whether more than `left` hexahedra are due by counting facets: F open facets need
/// F <= 4 R + 2 c, where the R hexahedra to come have c components.
[[nodiscard]] bool exceeds_face_budget(const PartialMesh& mesh, int left);

/// The open facets, and the vertices that may be above each corner.
class OpenFacets {
 public:
  /// A corner of an open facet: `place` in the list, and which of the four.
  struct Corner {
    std::uint16_t place = 0;
    std::uint8_t at = 0;
  };

  void list(const PartialMesh& mesh);

  [[nodiscard]] std::size_t size() const noexcept { return facet_.size(); }
  [[nodiscard]] const Facet& facet(std::size_t place) const noexcept { return facet_[place]; }
  [[nodiscard]] VertexSet vertices_of(std::size_t place) const noexcept { return set_[place]; }
  [[nodiscard]] const std::array<VertexSet, 4>& above(std::size_t place) const noexcept {
    return above_[place];
  }
  /// The corners at a vertex.
  [[nodiscard]] std::span<const Corner> at(Vertex v) const noexcept {
    return std::span(corners_).subspan(begin_[v], begin_[v + std::size_t{1}] - begin_[v]);
  }

 private:
  std::vector<Facet> facet_;
  std::vector<VertexSet> set_;
  std::vector<std::array<VertexSet, 4>> above_;
  std::vector<Corner> corners_;
  std::array<std::uint16_t, kMaxMeshVertices + 1> begin_{};
};

/// Whether the link of a vertex of the last hexahedron cannot become a sphere or a disc. For balls
/// only. Requires a hexahedron.
[[nodiscard]] bool closes_badly(const PartialMesh& mesh);

/// Whether new_vertices_within() needs no look: there is room for all vertices that may be new.
[[nodiscard]] bool is_ample(const PartialMesh& mesh, int left) noexcept;

/// How many new vertices `left` hexahedra may bring, by counting corners; negative if they are too
/// few for the vertices that there are. With `ears`, two open facets with a common edge are asked
/// whether one hexahedron may have both. Without them, and for balls, `open` is not looked at.
[[nodiscard]] int new_vertices_within(const PartialMesh& mesh, const OpenFacets& open, int left,
                                      bool ears);

/// Where the next hexahedron should go.
struct Tightest {
  int facet = -1;  ///< the one on which the fewest hexahedra can be put; of several the first
  bool is_refuted = false;  ///< on some facet there can be none
};
/// Of the kCounted facets with the fewest combinations of top vertices, whose hexahedra are
/// counted. `new_vertices`: at most these in one hexahedron. Requires an open facet. Restores the
/// mesh.
[[nodiscard]] Tightest tightest(PartialMesh& mesh, const NewVertices& new_vertices);
inline constexpr std::size_t kCounted = 10;

/// Places of more than `left` open facets, found greedily, no two of which may be of one
/// hexahedron; empty if none were found.
[[nodiscard]] std::vector<std::size_t> facets_apart(const OpenFacets& open, int left);

}  // namespace hexatlas::hexes
