#include <algorithm>
#include <bitset>
#include <utility>

#include "enum/complex/tetrahedra_at_triangles.hpp"
#include "enum/complex/triangulation.hpp"

namespace hexatlas::complex {
namespace {

constexpr std::size_t kPairs = kMaxTriangulationVertices * (kMaxTriangulationVertices - 1) / 2;
using EdgeChain = std::bitset<kPairs>;

std::size_t rank_of_edge(int a, int b) {
  return static_cast<std::size_t>(b) * static_cast<std::size_t>(b - 1) / 2 +
         static_cast<std::size_t>(a);
}

std::vector<VertexSet> edges_of(const std::vector<VertexSet>& faces) {
  std::vector<VertexSet> edges;
  for (const VertexSet face : faces)
    for (VertexSet a = face; a != 0; a = without_least(a))
      for (VertexSet b = without_least(a); b != 0; b = without_least(b))
        edges.push_back(static_cast<VertexSet>(bit_of(least_vertex(a)) | bit_of(least_vertex(b))));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Whether the faces are joined through common vertices.
bool is_connected(const std::vector<VertexSet>& faces) {
  unsigned reached = faces.empty() ? 0 : faces.front();
  unsigned all = 0;
  for (const VertexSet face : faces) all |= face;
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (const VertexSet face : faces)
      if ((face & reached) != 0) reached |= face;
  }
  return reached == all;
}

/// Whether triangles form a sphere or a disc: each edge in at most two, links of vertices
/// connected, connected, and the right Euler characteristic.
bool is_sphere_or_disc(const std::vector<VertexSet>& triangles) {
  unsigned all = 0;
  for (const VertexSet triangle : triangles) all |= triangle;
  const std::vector<VertexSet> edges = edges_of(triangles);
  bool is_closed = true;
  for (const VertexSet edge : edges) {
    const auto at = std::count_if(triangles.begin(), triangles.end(),
                                  [&](VertexSet t) { return (t & edge) == edge; });
    if (at > 2) return false;
    is_closed = is_closed && at == 2;
  }
  for (unsigned rest = all; rest != 0; rest &= rest - 1U) {
    const unsigned vertex = rest & (~rest + 1U);
    std::vector<VertexSet> link;
    for (const VertexSet triangle : triangles)
      if ((triangle & vertex) != 0) link.push_back(static_cast<VertexSet>(triangle & ~vertex));
    if (!is_connected(link)) return false;
  }
  const auto euler =
      std::popcount(all) - static_cast<int>(edges.size()) + static_cast<int>(triangles.size());
  return is_connected(triangles) && euler == (is_closed ? 2 : 1);
}

bool has_good_links(const Triangulation& triangulation) {
  for (int v = 0; v < triangulation.vertices; ++v) {
    std::vector<VertexSet> link;
    for (const VertexSet tetrahedron : triangulation.tetrahedra)
      if ((tetrahedron & bit_of(v)) != 0)
        link.push_back(static_cast<VertexSet>(tetrahedron & ~static_cast<unsigned>(bit_of(v))));
    if (!link.empty() && !is_sphere_or_disc(link)) return false;
  }
  return true;
}

/// Dimension of the first homology modulo 2 of a connected complex: edges - rank of the boundary
/// map to vertices - rank of the boundary map of the triangles.
std::size_t first_betti_number(const Triangulation& triangulation) {
  std::vector<EdgeChain> basis(kPairs);  // by leading edge
  std::size_t rank = 0;
  for (const TrianglePlace& place : tetrahedra_at_triangles(triangulation)) {
    EdgeChain chain;
    for (const VertexSet edge : edges_of({place.triangle}))
      chain.set(rank_of_edge(least_vertex(edge), least_vertex(without_least(edge))));
    for (std::size_t e = 0; e < kPairs && chain.any(); ++e) {
      if (!chain[e]) continue;
      if (basis[e].none()) {
        basis[e] = chain;
        ++rank;
        break;
      }
      chain ^= basis[e];
    }
  }
  unsigned all = 0;
  for (const VertexSet tetrahedron : triangulation.tetrahedra) all |= tetrahedron;
  const std::size_t edges = edges_of(triangulation.tetrahedra).size();
  return edges - static_cast<std::size_t>(std::popcount(all) - 1) - rank;
}

Triangulation coned(const Triangulation& triangulation, const std::vector<VertexSet>& boundary) {
  Triangulation result = triangulation;
  for (const VertexSet triangle : boundary)
    result.tetrahedra.push_back(static_cast<VertexSet>(triangle | bit_of(triangulation.vertices)));
  ++result.vertices;
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  return result;
}

}  // namespace

Topology topology_of(const Triangulation& triangulation) {
  if (triangulation.tetrahedra.empty() || !is_connected(triangulation.tetrahedra))
    return Topology::other;
  std::vector<VertexSet> boundary;
  for (const TrianglePlace& place : tetrahedra_at_triangles(triangulation)) {
    if (place.count > 2) return Topology::other;
    if (place.count == 1) boundary.push_back(place.triangle);
  }
  const Topology wanted = boundary.empty() ? Topology::sphere : Topology::ball;
  if (search_shelling(triangulation).outcome == ShellingSearch::found) return wanted;
  // A vertex with a good link in the cone is the apex only if the boundary is a sphere.
  if (!has_good_links(triangulation) || (!boundary.empty() && !is_sphere_or_disc(boundary)))
    return Topology::other;
  if (!boundary.empty() && triangulation.vertices < kMaxTriangulationVertices &&
      search_shelling(coned(triangulation, boundary)).outcome == ShellingSearch::found)
    return Topology::ball;
  return first_betti_number(triangulation) == 0 ? Topology::undecided : Topology::other;
}

}  // namespace hexatlas::complex
