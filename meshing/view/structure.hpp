#pragma once
/// \file
/// What a picture or a report of a hexahedral or hybrid mesh needs to know of its combinatorics:
/// which hexahedra are behind which facets, how deep each one lies, which edges are singular, and
/// how many hexahedra are around interior edges and vertices.
///
/// Definitions. Two facets are the same if their four vertices are. A facet is *free* if it is in
/// one hexahedron only; an edge or a vertex is *on the boundary* if a free facet has it, otherwise
/// *interior*. The *valence* of an edge is the number of hexahedra that have it. An interior edge
/// is *singular* if its valence is not 4, an edge on the boundary if it is not 2. The *layer* of a
/// hexahedron is 0 if it has a free facet, and otherwise one more than the least layer of the
/// hexahedra with which it shares a facet: the distance from the boundary, in steps from
/// hexahedron to hexahedron.
///
/// Requires. Indices below the number of points, else PreconditionViolated. No law of complexes
/// is required: a facet may be in three hexahedra or more, or twice in one.
/// Cost: n log n for n hexahedra, in sorting; some 100 bytes for each.
/// Not promised: that a facet, an edge or a layer means anything where hexahedra meet in more
/// than one vertex, edge or facet.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "enum/cells/cube.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::view {

inline constexpr std::uint32_t kNobody = 0xFFFF'FFFFU;

/// For each hexahedron and facet of the cube, the hexahedron on the other side; kNobody for a free
/// facet. Of a facet in more than two hexahedra, they follow each other in a circle.
using Neighbours = std::vector<std::array<std::uint32_t, cells::kCubeFacets>>;
[[nodiscard]] Neighbours neighbours_of(const mesh::HexMesh& mesh);

enum class Shape : std::uint8_t { tetrahedron, hexahedron, prism, pyramid };

/// The cells of a hybrid mesh in one list: tetrahedra, hexahedra, prisms, pyramids. Each has places
/// for eight corners; those beyond its own repeat its last one.
struct Solids {
  std::size_t points = 0;
  std::vector<Shape> shapes;
  std::vector<std::array<mesh::Index, 8>> corners;
};
[[nodiscard]] Solids solids_of(const mesh::HybridMesh& mesh);

/// The facets of a shape as places of corners, counterclockwise seen from outside; a triangle
/// repeats its last corner. Those of a hexahedron are in the order of the cube.
[[nodiscard]] std::span<const std::array<std::uint8_t, 4>> facets_of(Shape shape);

/// The same as for hexahedra; on the places beyond the facets of its shape a cell is its own
/// neighbour.
[[nodiscard]] Neighbours neighbours_of(const Solids& solids);

/// The layer of each hexahedron. Those that no way leads to from the boundary, in a mesh without
/// free facets, are in layer 0.
[[nodiscard]] std::vector<std::uint32_t> layers_of(const Neighbours& neighbours);

struct Edge {
  mesh::Index a = 0, b = 0;  ///< a < b
  std::uint32_t valence = 0;
  bool is_boundary = false;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// The singular edges, by a, then b. Requires the neighbours of this mesh.
[[nodiscard]] std::vector<Edge> singular_edges(const mesh::HexMesh& mesh,
                                               const Neighbours& neighbours);

/// The edges of triangles and quads that are not in two of them, by a, then b; the valence is the
/// number of facets, and is_boundary is set if it is one.
[[nodiscard]] std::vector<Edge> singular_edges(const mesh::FacetMesh& surface);

struct VertexCounts {
  std::size_t used = 0;      ///< in some cell
  std::size_t interior = 0;  ///< used, and not on the boundary
};
[[nodiscard]] VertexCounts count_vertices(const mesh::HexMesh& mesh, const Neighbours& neighbours);
/// Requires the neighbours of these solids.
[[nodiscard]] VertexCounts count_vertices(const Solids& solids, const Neighbours& neighbours);

/// For each number of hexahedra, how many interior edges, and how many interior vertices, are in so
/// many; numbers that do not occur are left out.
struct InteriorValences {
  std::map<std::uint32_t, std::size_t> edges;
  std::map<std::uint32_t, std::size_t> vertices;
};
/// Requires the neighbours of this mesh.
[[nodiscard]] InteriorValences interior_valences(const mesh::HexMesh& mesh,
                                                 const Neighbours& neighbours);

}  // namespace hexatlas::view
