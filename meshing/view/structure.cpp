#include "meshing/view/structure.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "enum/cells/shapes.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::view {
namespace {

using mesh::Index;

struct FacetOfCell {
  std::array<Index, 4> key{};  ///< the vertices, ascending
  std::uint32_t cell = 0;
  std::uint32_t facet = 0;
};

template <class Cells>
void expect_indices(const Cells& cells, std::size_t points) {
  for (const auto& cell : cells)
    for (const Index v : cell) core::expects(v < points, "view: index of a point out of range");
}

void expect_indices(const mesh::HexMesh& mesh) {
  expect_indices(mesh.hexahedra, mesh.points.size());
}

using Facet = cells::ShapeFacet;

/// The vertices, ascending; what a triangle, or a facet with a vertex twice, lacks is kNobody.
template <class Cell>
std::array<Index, 4> key_of(const Cell& cell, const Facet& facet) {
  std::array<Index, 4> key{};
  std::transform(facet.begin(), facet.end(), key.begin(),
                 [&](std::uint8_t corner) { return cell[corner]; });
  std::sort(key.begin(), key.end());
  const auto* const end = std::unique(key.begin(), key.end());
  std::fill(key.begin() + (end - key.begin()), key.end(), kNobody);
  return key;
}

/// Neighbours from facets in any order; `neighbours` has a row for each cell.
void connect(std::vector<FacetOfCell> facets, Neighbours& neighbours) {
  std::sort(facets.begin(), facets.end(), [](const FacetOfCell& x, const FacetOfCell& y) {
    return std::tie(x.key, x.cell, x.facet) < std::tie(y.key, y.cell, y.facet);
  });
  for (std::size_t begin = 0, end = 0; begin < facets.size(); begin = end) {
    while (end < facets.size() && facets[end].key == facets[begin].key) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t next = i + 1 < end ? i + 1 : begin;
      neighbours[facets[i].cell][facets[i].facet] = next == i ? kNobody : facets[next].cell;
    }
  }
}

/// One edge of one cell: the same edge comes once for each cell that has it.
struct Use {
  Index a = 0, b = 0;
  bool is_boundary = false;
};

Use use_of(Index v, Index w, bool is_boundary) {
  return {std::min(v, w), std::max(v, w), is_boundary};
}

/// The edges for which is_wanted(edge) is true.
template <class Wanted>
std::vector<Edge> edges_of(std::vector<Use> uses, Wanted is_wanted) {
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
  std::vector<Edge> found;
  for (std::size_t i = 0; i < uses.size();) {
    Edge edge{uses[i].a, uses[i].b, 0, false};
    for (; i < uses.size() && uses[i].a == edge.a && uses[i].b == edge.b; ++i) {
      ++edge.valence;
      edge.is_boundary |= uses[i].is_boundary;
    }
    if (is_wanted(edge)) found.push_back(edge);
  }
  return found;
}

/// Bit v for each corner v of the cube in this facet.
constexpr std::array<unsigned, cells::kCubeFacets> corner_sets() {
  std::array<unsigned, cells::kCubeFacets> sets{};
  for (std::size_t f = 0; f < sets.size(); ++f)
    for (const cells::CubeVertex v : cells::kFacetVertices[f]) sets[f] |= 1U << v;
  return sets;
}
constexpr auto kCornerSets = corner_sets();

void expect_neighbours_of(const mesh::HexMesh& mesh, const Neighbours& neighbours) {
  expect_indices(mesh);
  core::expects(neighbours.size() == mesh.hexahedra.size(), "view: neighbours are of this mesh");
}

std::vector<Use> uses_of_edges(const mesh::HexMesh& mesh, const Neighbours& neighbours) {
  expect_neighbours_of(mesh, neighbours);
  std::vector<Use> uses;
  uses.reserve(mesh.hexahedra.size() * cells::kCubeEdges.size());
  for (std::size_t cell = 0; cell < mesh.hexahedra.size(); ++cell)
    for (const auto& [v, w] : cells::kCubeEdges) {
      bool is_boundary = false;
      for (std::size_t f = 0; f < kCornerSets.size(); ++f)
        is_boundary |= neighbours[cell][f] == kNobody && (kCornerSets[f] >> v & 1U) != 0 &&
                       (kCornerSets[f] >> w & 1U) != 0;
      uses.push_back(use_of(mesh.hexahedra[cell][v], mesh.hexahedra[cell][w], is_boundary));
    }
  return uses;
}

enum class Place : std::uint8_t { unused, interior, boundary };

/// Of each point.
std::vector<Place> places_of(const mesh::HexMesh& mesh, const Neighbours& neighbours) {
  expect_neighbours_of(mesh, neighbours);
  std::vector<Place> place(mesh.points.size(), Place::unused);
  for (std::size_t cell = 0; cell < mesh.hexahedra.size(); ++cell) {
    unsigned on_boundary = 0;
    for (std::size_t f = 0; f < kCornerSets.size(); ++f)
      if (neighbours[cell][f] == kNobody) on_boundary |= kCornerSets[f];
    for (std::size_t v = 0; v < cells::kCubeVertices; ++v) {
      Place& known = place[mesh.hexahedra[cell][v]];
      known = std::max(known, (on_boundary >> v & 1U) != 0 ? Place::boundary : Place::interior);
    }
  }
  return place;
}

VertexCounts count(const std::vector<Place>& place) {
  const auto interiors = std::count(place.begin(), place.end(), Place::interior);
  const auto idle = std::count(place.begin(), place.end(), Place::unused);
  return {place.size() - static_cast<std::size_t>(idle), static_cast<std::size_t>(interiors)};
}

}  // namespace

Neighbours neighbours_of(const mesh::HexMesh& mesh) {
  expect_indices(mesh);
  std::vector<FacetOfCell> facets;
  facets.reserve(mesh.hexahedra.size() * cells::kCubeFacets);
  for (std::uint32_t cell = 0; cell < mesh.hexahedra.size(); ++cell)
    for (std::uint32_t f = 0; f < cells::kCubeFacets; ++f)
      facets.push_back({key_of(mesh.hexahedra[cell], cells::kFacetVertices[f]), cell, f});
  Neighbours neighbours(mesh.hexahedra.size());
  connect(std::move(facets), neighbours);
  return neighbours;
}

Solids solids_of(const mesh::HybridMesh& mesh) {
  Solids solids{mesh.points.size(), {}, {}};
  const auto add = [&](Shape shape, const auto& cells) {
    for (const auto& cell : cells) {
      solids.shapes.push_back(shape);
      auto& corners = solids.corners.emplace_back();
      corners.fill(cell.back());
      std::copy(cell.begin(), cell.end(), corners.begin());
    }
  };
  add(Shape::tetrahedron, mesh.tetrahedra);
  add(Shape::hexahedron, mesh.hexahedra);
  add(Shape::prism, mesh.prisms);
  add(Shape::pyramid, mesh.pyramids);
  expect_indices(solids.corners, solids.points);
  return solids;
}

std::span<const std::array<std::uint8_t, 4>> facets_of(Shape shape) {
  switch (shape) {
    case Shape::tetrahedron:
      return cells::kTetrahedronFacets;
    case Shape::hexahedron:
      return cells::kFacetVertices;
    case Shape::prism:
      return cells::kPrismFacets;
    case Shape::pyramid:
      break;
  }
  return cells::kPyramidFacets;
}

Neighbours neighbours_of(const Solids& solids) {
  Neighbours neighbours(solids.corners.size());
  std::vector<FacetOfCell> facets;
  for (std::uint32_t cell = 0; cell < neighbours.size(); ++cell) {
    neighbours[cell].fill(cell);
    const auto own = facets_of(solids.shapes[cell]);
    for (std::uint32_t f = 0; f < own.size(); ++f)
      facets.push_back({key_of(solids.corners[cell], own[f]), cell, f});
  }
  connect(std::move(facets), neighbours);
  return neighbours;
}

std::vector<std::uint32_t> layers_of(const Neighbours& neighbours) {
  std::vector<std::uint32_t> layer(neighbours.size(), kNobody);
  std::vector<std::uint32_t> front;
  for (std::uint32_t cell = 0; cell < neighbours.size(); ++cell)
    if (std::find(neighbours[cell].begin(), neighbours[cell].end(), kNobody) !=
        neighbours[cell].end()) {
      layer[cell] = 0;
      front.push_back(cell);
    }
  for (std::size_t at = 0; at < front.size(); ++at)  // breadth first; grows as it goes
    for (const std::uint32_t next : neighbours[front[at]])
      if (next != kNobody && layer[next] == kNobody) {
        layer[next] = layer[front[at]] + 1;
        front.push_back(next);
      }
  std::replace(layer.begin(), layer.end(), kNobody, 0U);
  return layer;
}

std::vector<Edge> singular_edges(const mesh::HexMesh& mesh, const Neighbours& neighbours) {
  return edges_of(uses_of_edges(mesh, neighbours),
                  [](const Edge& edge) { return edge.valence != (edge.is_boundary ? 2U : 4U); });
}

std::vector<Edge> singular_edges(const mesh::FacetMesh& surface) {
  std::vector<Use> uses;
  for (const mesh::Facet& facet : surface.facets)
    for (std::size_t i = 0; i < facet.size; ++i)
      uses.push_back(use_of(facet.vertices[i], facet.vertices[(i + 1) % facet.size], false));
  std::vector<Edge> edges =
      edges_of(std::move(uses), [](const Edge& edge) { return edge.valence != 2; });
  for (Edge& edge : edges) edge.is_boundary = edge.valence == 1;
  return edges;
}

VertexCounts count_vertices(const mesh::HexMesh& mesh, const Neighbours& neighbours) {
  return count(places_of(mesh, neighbours));
}

VertexCounts count_vertices(const Solids& solids, const Neighbours& neighbours) {
  core::expects(neighbours.size() == solids.corners.size(), "view: neighbours are of this mesh");
  std::vector<Place> place(solids.points, Place::unused);
  for (std::size_t cell = 0; cell < neighbours.size(); ++cell) {
    const auto mark = [&](std::uint8_t corner, Place here) {
      Place& known = place[solids.corners[cell][corner]];
      known = std::max(known, here);
    };
    const auto own = facets_of(solids.shapes[cell]);
    for (std::size_t f = 0; f < own.size(); ++f)
      for (const std::uint8_t corner : own[f])
        mark(corner, neighbours[cell][f] == kNobody ? Place::boundary : Place::interior);
  }
  return count(place);
}

InteriorValences interior_valences(const mesh::HexMesh& mesh, const Neighbours& neighbours) {
  InteriorValences result;
  for (const Edge& edge :
       edges_of(uses_of_edges(mesh, neighbours), [](const Edge& one) { return !one.is_boundary; }))
    ++result.edges[edge.valence];
  std::vector<std::uint32_t> around(mesh.points.size(), 0);
  for (const auto& cell : mesh.hexahedra)
    for (const Index v : cell) ++around[v];
  const std::vector<Place> place = places_of(mesh, neighbours);
  for (std::size_t v = 0; v < place.size(); ++v)
    if (place[v] == Place::interior) ++result.vertices[around[v]];
  return result;
}

}  // namespace hexatlas::view
