// Claim. neighbours_of(), layers_of(), singular_edges(), count_vertices() and interior_valences()
// are what their header defines. Oracle. Grids, where all of it is known by counting; a cube
// divided into four around an interior vertex, counted by hand; and, on random sets of cells of a
// grid with random numbers, a brute force that compares all pairs of facets and walks from all
// cells at once.
#include "meshing/view/structure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/core/random.hpp"

namespace {

using namespace hexatlas;
using Cell = std::array<mesh::Index, 8>;
using Place = std::array<std::uint32_t, 3>;

/// The cells of a grid for which keep(x, y, z) holds; points are numbered by place.
mesh::HexMesh grid(std::uint32_t n, const std::function<bool(Place)>& keep) {
  mesh::HexMesh mesh;
  const std::uint32_t m = n + 1;
  mesh.points.resize(std::size_t{m} * m * m);
  for (std::uint32_t z = 0; z < n; ++z)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        if (!keep({x, y, z})) continue;
        Cell cell{};
        for (std::uint32_t v = 0; v < 8; ++v)
          cell[v] = x + (v & 1U) + m * (y + (v >> 1U & 1U) + m * (z + (v >> 2U)));
        mesh.hexahedra.push_back(cell);
      }
  return mesh;
}

mesh::HexMesh whole_grid(std::uint32_t n) {
  return grid(n, [](Place) { return true; });
}

/// Turned about an axis: another numbering of the same hexahedron.
Cell turned(const Cell& c) { return {c[1], c[3], c[0], c[2], c[5], c[7], c[4], c[6]}; }

using Key = std::set<mesh::Index>;

/// The six facets, by coordinates: the corners with bit k equal to s.
std::array<Key, 6> facets_of(const Cell& cell) {
  std::array<Key, 6> facets;
  for (unsigned f = 0; f < 6; ++f)
    for (unsigned v = 0; v < 8; ++v)
      if ((v >> (f / 2) & 1U) == f % 2) facets[f].insert(cell[v]);
  return facets;
}

/// The cells on the other side, by comparing all pairs.
view::Neighbours slow_neighbours(const mesh::HexMesh& mesh) {
  view::Neighbours result(mesh.hexahedra.size());
  for (std::size_t a = 0; a < result.size(); ++a) {
    const auto own = facets_of(mesh.hexahedra[a]);
    for (std::size_t f = 0; f < 6; ++f) {
      result[a][f] = view::kNobody;
      for (std::uint32_t b = 0; b < result.size(); ++b) {
        const auto others = facets_of(mesh.hexahedra[b]);
        if (a != b && std::find(others.begin(), others.end(), own[f]) != others.end())
          result[a][f] = b;
      }
    }
  }
  return result;
}

/// Lowers what can be lowered until nothing can.
std::vector<std::uint32_t> slow_layers(const mesh::HexMesh& mesh) {
  const view::Neighbours neighbours = slow_neighbours(mesh);
  std::vector<std::uint32_t> layer(neighbours.size(), 1'000'000);
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (std::size_t cell = 0; cell < layer.size(); ++cell) {
      std::uint32_t least = layer[cell];
      for (const std::uint32_t n : neighbours[cell])
        least = std::min(least, n == view::kNobody ? 0 : layer[n] + 1);
      is_changed |= least != layer[cell];
      layer[cell] = least;
    }
  }
  return layer;
}

/// All edges.
std::vector<view::Edge> slow_edges(const mesh::HexMesh& mesh) {
  std::map<Key, int> facets;
  std::map<std::pair<mesh::Index, mesh::Index>, std::uint32_t> edges;
  for (const Cell& cell : mesh.hexahedra) {
    for (const Key& facet : facets_of(cell)) ++facets[facet];
    for (unsigned v = 0; v < 8; ++v)
      for (unsigned w = v + 1; w < 8; ++w)
        if (const unsigned bits = v ^ w; (bits & (bits - 1)) == 0)
          ++edges[std::minmax(cell[v], cell[w])];
  }
  // The vertices of an edge are also the ends of no diagonal of a free facet in these meshes.
  std::vector<view::Edge> result;
  for (const auto& [ends, valence] : edges) {
    const bool is_boundary =
        std::any_of(facets.begin(), facets.end(), [&ends = ends](const auto& f) {
          return f.second == 1 && f.first.contains(ends.first) && f.first.contains(ends.second);
        });
    result.push_back({ends.first, ends.second, valence, is_boundary});
  }
  return result;
}

std::vector<view::Edge> slow_singular_edges(const mesh::HexMesh& mesh) {
  std::vector<view::Edge> edges = slow_edges(mesh);
  std::erase_if(
      edges, [](const view::Edge& edge) { return edge.valence == (edge.is_boundary ? 2U : 4U); });
  return edges;
}

using Counts = std::map<std::uint32_t, std::size_t>;

Counts slow_edge_valences(const mesh::HexMesh& mesh) {
  Counts counts;
  for (const view::Edge& edge : slow_edges(mesh))
    if (!edge.is_boundary) ++counts[edge.valence];
  return counts;
}

/// A vertex is interior if no edge on the boundary has it; so it is in grids.
Counts slow_vertex_valences(const mesh::HexMesh& mesh) {
  std::set<mesh::Index> on_boundary;
  for (const view::Edge& edge : slow_edges(mesh))
    if (edge.is_boundary) on_boundary.insert({edge.a, edge.b});
  Counts counts;
  for (mesh::Index v = 0; v < mesh.points.size(); ++v) {
    const auto around = std::count_if(
        mesh.hexahedra.begin(), mesh.hexahedra.end(),
        [v](const Cell& cell) { return std::find(cell.begin(), cell.end(), v) != cell.end(); });
    if (around > 0 && !on_boundary.contains(v)) ++counts[static_cast<std::uint32_t>(around)];
  }
  return counts;
}

TEST(ViewStructure, OfOneCube) {
  const mesh::HexMesh cube = whole_grid(1);
  const view::Neighbours neighbours = view::neighbours_of(cube);
  for (const std::uint32_t n : neighbours.at(0)) EXPECT_EQ(n, view::kNobody);
  EXPECT_EQ(view::layers_of(neighbours), std::vector<std::uint32_t>{0});
  const auto edges = view::singular_edges(cube, neighbours);
  EXPECT_EQ(edges.size(), 12U);
  for (const view::Edge& edge : edges) {
    EXPECT_EQ(edge.valence, 1U);
    EXPECT_TRUE(edge.is_boundary);
  }
  EXPECT_EQ(view::count_vertices(cube, neighbours).interior, 0U);
}

TEST(ViewStructure, LayersOfGrids) {
  for (std::uint32_t n = 2; n <= 7; ++n) {
    const auto layers = view::layers_of(view::neighbours_of(whole_grid(n)));
    std::size_t at = 0;
    for (std::uint32_t z = 0; z < n; ++z)
      for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x)
          EXPECT_EQ(layers[at++], std::min({x, y, z, n - 1 - x, n - 1 - y, n - 1 - z}));
  }
}

TEST(ViewStructure, EdgesOfGridsAreSingularOnTheTwelveEdgesOfTheBox) {
  for (std::uint32_t n = 2; n <= 5; ++n) {
    const mesh::HexMesh mesh = whole_grid(n);
    const view::Neighbours neighbours = view::neighbours_of(mesh);
    const auto edges = view::singular_edges(mesh, neighbours);
    EXPECT_EQ(edges.size(), 12U * n);
    EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const view::Edge& edge) {
      return edge.valence == 1 && edge.is_boundary;
    }));
    const view::VertexCounts counts = view::count_vertices(mesh, neighbours);
    EXPECT_EQ(counts.used, std::size_t{n + 1} * (n + 1) * (n + 1));
    EXPECT_EQ(counts.interior, std::size_t{n - 1} * (n - 1) * (n - 1));
    const view::InteriorValences valences = view::interior_valences(mesh, neighbours);
    EXPECT_EQ(valences.edges, (Counts{{4, std::size_t{3} * n * (n - 1) * (n - 1)}}));
    EXPECT_EQ(valences.vertices, (Counts{{8, counts.interior}}));
  }
}

/// A tetrahedron cut into four hexahedra at its corners: 4 corners, 6 middles of edges, 4 of
/// facets, the middle 14. Interior edges lead from the middle to those of the facets, and are in 3
/// hexahedra.
TEST(ViewStructure, OfATetrahedronInFour) {
  mesh::HexMesh mesh;
  mesh.points.resize(15);
  const auto middle = [](unsigned i, unsigned j) {
    constexpr std::array<std::array<unsigned, 4>, 4> kMiddles{
        {{0, 4, 5, 6}, {4, 0, 7, 8}, {5, 7, 0, 9}, {6, 8, 9, 0}}};
    return kMiddles[i][j];
  };
  for (unsigned c = 0; c < 4; ++c) {
    const unsigned i = (c + 1) % 4, j = (c + 2) % 4, k = (c + 3) % 4;
    const auto facet = [](unsigned without) { return 10 + without; };
    mesh.hexahedra.push_back(
        {c, middle(c, i), middle(c, j), facet(k), middle(c, k), facet(j), facet(i), 14});
  }
  const view::Neighbours neighbours = view::neighbours_of(mesh);
  const auto edges = view::singular_edges(mesh, neighbours);
  std::map<std::pair<std::uint32_t, bool>, int> count;
  for (const view::Edge& edge : edges) ++count[{edge.valence, edge.is_boundary}];
  // On the boundary, the 12 halves of edges have 1, the 12 edges within facets the regular 2.
  const std::map<std::pair<std::uint32_t, bool>, int> expected{{{3, false}, 4}, {{1, true}, 12}};
  EXPECT_EQ(count, expected);
  EXPECT_EQ(view::count_vertices(mesh, neighbours).interior, 1U);
  const view::InteriorValences valences = view::interior_valences(mesh, neighbours);
  EXPECT_EQ(valences.edges, (Counts{{3, 4}}));
  EXPECT_EQ(valences.vertices, (Counts{{4, 1}}));
  EXPECT_EQ(view::layers_of(neighbours), std::vector<std::uint32_t>(4, 0));
}

TEST(ViewStructure, AgreesWithBruteForce) {
  core::Random random(7);
  for (int round = 0; round < 30; ++round) {
    const std::uint32_t n = 3 + static_cast<std::uint32_t>(random.below(2));
    const std::size_t dropped = random.below(4);
    mesh::HexMesh mesh = grid(n, [&](Place) { return random.below(10) >= dropped; });
    std::vector<mesh::Index> numbers(mesh.points.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {  // a random order
      const std::size_t j = random.below(i + 1);
      numbers[i] = numbers[j];
      numbers[j] = static_cast<mesh::Index>(i);
    }
    for (Cell& cell : mesh.hexahedra) {
      for (mesh::Index& v : cell) v = numbers[v];
      for (std::size_t turns = random.below(4); turns > 0; --turns) cell = turned(cell);
    }
    const view::Neighbours neighbours = view::neighbours_of(mesh);
    EXPECT_EQ(neighbours, slow_neighbours(mesh));
    EXPECT_EQ(view::layers_of(neighbours), slow_layers(mesh));
    EXPECT_EQ(view::singular_edges(mesh, neighbours), slow_singular_edges(mesh));
    const view::InteriorValences valences = view::interior_valences(mesh, neighbours);
    EXPECT_EQ(valences.edges, slow_edge_valences(mesh));
    EXPECT_EQ(valences.vertices, slow_vertex_valences(mesh));
  }
}

TEST(ViewStructure, AFacetInThreeHexahedraGoesInACircle) {
  mesh::HexMesh mesh;
  mesh.points.resize(16);
  mesh.hexahedra = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 8, 9, 10, 11}, {0, 1, 2, 3, 12, 13, 14, 15}};
  const view::Neighbours neighbours = view::neighbours_of(mesh);
  for (std::uint32_t cell = 0; cell < 3; ++cell) EXPECT_EQ(neighbours[cell][4], (cell + 1) % 3);
}

TEST(ViewStructure, WithoutBoundaryAllIsLayerZero) {
  mesh::HexMesh mesh;  // a torus of 3 x 3 x 3: no facet is free
  mesh.points.resize(27);
  for (std::uint32_t place = 0; place < 27; ++place) {
    Cell cell{};
    for (std::uint32_t v = 0; v < 8; ++v)
      cell[v] = (place % 3 + (v & 1U)) % 3 + 3 * ((place / 3 % 3 + (v >> 1U & 1U)) % 3) +
                9 * ((place / 9 + (v >> 2U)) % 3);
    mesh.hexahedra.push_back(cell);
  }
  const view::Neighbours neighbours = view::neighbours_of(mesh);
  EXPECT_EQ(view::layers_of(neighbours), std::vector<std::uint32_t>(27, 0));
  EXPECT_TRUE(view::singular_edges(mesh, neighbours).empty());
  EXPECT_EQ(view::interior_valences(mesh, neighbours).edges, (Counts{{4, 81}}));
  EXPECT_EQ(view::interior_valences(mesh, neighbours).vertices, (Counts{{8, 27}}));
  EXPECT_EQ(view::count_vertices(mesh, neighbours).interior, 27U);
}

TEST(ViewStructure, PointsOfNoHexahedronAreNotCounted) {
  mesh::HexMesh cube = whole_grid(1);
  cube.points.resize(20);
  EXPECT_EQ(view::count_vertices(cube, view::neighbours_of(cube)).used, 8U);
}

TEST(ViewStructure, EdgesOfASurface) {
  mesh::FacetMesh surface;  // two triangles at an edge, and a quad at the same edge
  surface.points.resize(6);
  surface.facets = {{{0, 1, 2, 0}, 3, 0}, {{1, 0, 3, 0}, 3, 0}};
  EXPECT_EQ(view::singular_edges(surface),
            (std::vector<view::Edge>{
                {0, 2, 1, true}, {0, 3, 1, true}, {1, 2, 1, true}, {1, 3, 1, true}}));
  surface.facets.push_back({{0, 1, 4, 5}, 4, 0});
  const auto edges = view::singular_edges(surface);
  EXPECT_EQ(edges.size(), 8U);
  EXPECT_EQ(edges.front(), (view::Edge{0, 1, 3, false}));
}

TEST(ViewStructure, RefusesAnIndexOutOfRange) {
  mesh::HexMesh cube = whole_grid(1);
  cube.hexahedra[0][3] = 8;
  EXPECT_THROW((void)view::neighbours_of(cube), core::PreconditionViolated);
  EXPECT_THROW((void)view::singular_edges(cube, view::Neighbours(1)), core::PreconditionViolated);
  EXPECT_THROW((void)view::singular_edges(whole_grid(2), view::Neighbours(1)),
               core::PreconditionViolated);
  EXPECT_THROW((void)view::interior_valences(whole_grid(2), view::Neighbours(1)),
               core::PreconditionViolated);
}

/// A cube, on its top a roof of one prism, beside it a pyramid, and on this a tetrahedron.
const mesh::HybridMesh kFour{std::vector<mesh::Point>(13),
                             {{1, 10, 5, 11}},
                             {{0, 1, 3, 2, 4, 5, 7, 6}},
                             {{4, 7, 8, 5, 6, 9}},
                             {{1, 2, 6, 5, 10}}};

TEST(Solids, AreListedWithTheirNeighbours) {
  const view::Solids solids = view::solids_of(kFour);
  using enum view::Shape;
  EXPECT_EQ(solids.shapes, (std::vector{tetrahedron, hexahedron, prism, pyramid}));
  EXPECT_EQ(solids.corners[0], (Cell{1, 10, 5, 11, 11, 11, 11, 11}));
  EXPECT_EQ(solids.corners[2], (Cell{4, 7, 8, 5, 6, 9, 9, 9}));
  const view::Neighbours neighbours = view::neighbours_of(solids);
  constexpr std::uint32_t kNo = view::kNobody;
  EXPECT_EQ(neighbours[0], (std::array<std::uint32_t, 6>{kNo, kNo, kNo, 3, 0, 0}));
  EXPECT_EQ(neighbours[1], (std::array<std::uint32_t, 6>{kNo, 3, kNo, kNo, kNo, 2}));
  EXPECT_EQ(neighbours[2], (std::array<std::uint32_t, 6>{kNo, kNo, 1, kNo, kNo, 2}));
  EXPECT_EQ(neighbours[3], (std::array<std::uint32_t, 6>{1, kNo, kNo, kNo, 0, 3}));
  EXPECT_EQ(view::layers_of(neighbours), std::vector<std::uint32_t>(4, 0));
  const view::VertexCounts vertices = view::count_vertices(solids, neighbours);
  EXPECT_EQ(vertices.used, 12U);
  EXPECT_EQ(vertices.interior, 0U);
}

TEST(Solids, OfHexahedraAloneAreAsThese) {
  const mesh::HexMesh grid = whole_grid(4);
  const view::Solids solids = view::solids_of({grid.points, {}, grid.hexahedra, {}, {}});
  const view::Neighbours neighbours = view::neighbours_of(solids);
  EXPECT_EQ(neighbours, view::neighbours_of(grid));
  EXPECT_EQ(view::count_vertices(solids, neighbours).interior, 27U);
}

/// Each cube of a grid is six pyramids around its centre.
TEST(Solids, PyramidsOfAGrid) {
  const mesh::HexMesh grid = whole_grid(3);
  mesh::HybridMesh mesh{grid.points, {}, {}, {}, {}};
  for (const Cell& h : grid.hexahedra) {
    const auto centre = static_cast<mesh::Index>(mesh.points.size());
    mesh.points.emplace_back();
    for (const auto& f : view::facets_of(view::Shape::hexahedron))
      mesh.pyramids.push_back({h[f[3]], h[f[2]], h[f[1]], h[f[0]], centre});
  }
  const view::Solids solids = view::solids_of(mesh);
  const view::Neighbours neighbours = view::neighbours_of(solids);
  const std::vector<std::uint32_t> layers = view::layers_of(neighbours);
  // 54 have a free facet; 54 pairs meet face to face, and in a cube five others are beside each
  // one.
  EXPECT_EQ(std::count(layers.begin(), layers.end(), 0U), 54);
  std::size_t free = 0;
  for (const auto& row : neighbours)
    free += static_cast<std::size_t>(std::count(row.begin(), row.end(), view::kNobody));
  EXPECT_EQ(free, 54U);
  const view::VertexCounts vertices = view::count_vertices(solids, neighbours);
  EXPECT_EQ(vertices.used, 64U + 27U);
  EXPECT_EQ(vertices.interior, 8U + 27U);
}

TEST(Solids, FacetsAreTheSurface) {
  // Each edge of a shape is passed once in each direction.
  for (const view::Shape shape : {view::Shape::tetrahedron, view::Shape::hexahedron,
                                  view::Shape::prism, view::Shape::pyramid}) {
    std::set<std::pair<int, int>> passed;
    std::size_t edges = 0;
    for (const auto& facet : view::facets_of(shape)) {
      const std::size_t size = facet[2] == facet[3] ? 3 : 4;
      for (std::size_t i = 0; i < size; ++i, ++edges)
        EXPECT_TRUE(passed.insert({facet[i], facet[(i + 1) % size]}).second);
    }
    for (const auto& [v, w] : passed) EXPECT_TRUE(passed.contains({w, v}));
    EXPECT_EQ(edges, (std::array{12U, 24U, 18U, 16U}[static_cast<std::size_t>(shape)]));
  }
}

TEST(Solids, Preconditions) {
  mesh::HybridMesh bad = kFour;
  bad.pyramids[0][4] = 13;
  EXPECT_THROW(static_cast<void>(view::solids_of(bad)), core::PreconditionViolated);
  EXPECT_THROW(static_cast<void>(view::count_vertices(view::solids_of(kFour), {})),
               core::PreconditionViolated);
}

}  // namespace
