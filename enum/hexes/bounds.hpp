#pragma once
/// \file
/// Lower bounds for what is missing from a partial mesh: each one refutes states from which no mesh
/// within the limits follows. Definitions and proofs: docs/theory/proofs/hexahedral-search.md.

#include <array>
#include <cstddef>
#include <vector>

#include "enum/hexes/partial_mesh.hpp"

namespace hexatlas::hexes {

/// Whether more than `left` hexahedra are due by counting facets: F open facets need
/// F <= 4 R + 2 c, where the R hexahedra to come have c components.
[[nodiscard]] bool exceeds_face_budget(const PartialMesh& mesh, int left);

/// How many new vertices `left` hexahedra may bring, by counting corners; negative if they are too
/// few for the vertices that there are.
[[nodiscard]] int new_vertices_within(const PartialMesh& mesh, int left);

/// The open facets, with the vertices that may be above each corner.
struct OpenFacets {
  std::vector<int> number;
  std::vector<std::array<VertexSet, 4>> above;
  /// The one with the fewest combinations of top vertices; of several the first.
  std::size_t tightest = 0;
  /// Whether some corner has no candidate, not even a new vertex.
  bool is_refuted = false;
};
/// `new_vertices`: whether there may be some.
void list_open_facets(const PartialMesh& mesh, bool new_vertices, OpenFacets& result);

/// Whether open facets a and b, by place in the list, may be facets of one hexahedron, as far as
/// pairs of vertices and facets tell.
[[nodiscard]] bool fit_one_hexahedron(const PartialMesh& mesh, const OpenFacets& open,
                                      std::size_t a, std::size_t b);

/// Whether more than `left` open facets, found greedily, cannot be of one hexahedron pairwise.
[[nodiscard]] bool exceeds_cover_bound(const PartialMesh& mesh, const OpenFacets& open, int left);

}  // namespace hexatlas::hexes
