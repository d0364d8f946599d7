#pragma once
/// \file
/// Triangles of a surface combined into quads: the two-dimensional case of candidates.hpp.
///
/// Definition. A *candidate* is a cycle a b c d of four vertices such that the mesh has the
/// triangles a b c and a c d, coherently oriented and of one colour, of quality above a threshold;
/// its *fold*, the angle between the normals of the two, is limited. So edges where the surface
/// bends stay, and those between its colours.
/// Its quality is the least over its corners of the determinant of the two edges there and the
/// normal, divided by the lengths of the edges: of a plane quad the least sine, negative where it
/// is not convex. The normal is the unit vector along the product of the diagonals. A *doublet* is
/// a vertex inside the surface, or in a fan that is closed around it, with two facets, which share
/// two edges: no cell complex, and no element either.
///
/// Source: the scheme of J. Pellerin, A. Johnen, K. Verhetsel, J.-F. Remacle, CAD 105 (2018). The
/// choice is a matching of triangles; exchanges along paths after a greedy choice as in the search
/// for matchings, without the blossoms of J. Edmonds, "Paths, trees, and flowers" (1965).
///
/// Any surface will do: edges in one, two or more triangles, several sheets. Quality is computed in
/// double precision: a measure that proves nothing.
/// Requires: triangles only, indices below points.size(), finite coordinates.
/// Cost: linear but for sorting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

struct QuadLimits {
  double quality = 0.1;  ///< the least, exclusive, from 0 to below 1
  double fold = 45;      ///< the greatest, in degrees, from 0 to 180
};

struct QuadCandidate {
  std::array<mesh::Index, 4> vertices{};  ///< cyclic, as the triangles are oriented; least first
  std::array<mesh::Index, 2> diagonal{};  ///< the edge that the triangles have in common
  std::array<std::uint32_t, 2> triangles{};
  double quality = 0;
};

/// Each once, ascending by vertices. A triangle without area has no normal, and bends nothing.
[[nodiscard]] std::vector<QuadCandidate> quad_candidates(const mesh::FacetMesh& surface,
                                                         const QuadLimits& limits);

/// How many edges of exactly two triangles both run through in the same direction: no candidate has
/// such an edge as its diagonal, since the triangles are not coherently oriented.
[[nodiscard]] std::size_t incoherent_edges(const mesh::FacetMesh& surface);

/// Candidates of which no two have a triangle in common and which make no doublet, ascending; none
/// can be added. The aim is many quads first, then good ones. The optimum is not promised.
[[nodiscard]] std::vector<std::size_t> quad_selection(const mesh::FacetMesh& surface,
                                                      std::span<const QuadCandidate> candidates);

/// The triangles of no chosen quad, then the quads, with the colour of their triangles; the points
/// stay.
[[nodiscard]] mesh::FacetMesh with_quads(const mesh::FacetMesh& surface,
                                         std::span<const QuadCandidate> candidates,
                                         std::span<const std::size_t> chosen);

}  // namespace hexatlas::hybrid
