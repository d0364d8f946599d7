// Claim. polyhedra() lists all polyhedra with triangles and quads on few vertices. Oracle. All
// labelled graphs with up to seven vertices: 3-connected, and each edge on exactly two induced
// circles that do not separate, which then are the facets (W. T. Tutte, "How to draw a graph",
// 1963; A. K. Kelmans, 1981).
#include "enum/balls/polyhedra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>
#include <vector>

namespace {

using namespace hexatlas;

/// neighbours[v]: a bit per neighbour.
using Graph = std::vector<unsigned>;

bool is_connected(const Graph& graph, unsigned rest) {
  unsigned reached = rest & (~rest + 1U);
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if ((reached >> v & 1U) != 0) reached |= graph[v] & rest;
  }
  return reached == rest;
}

bool is_three_connected(const Graph& graph) {
  if (std::any_of(graph.begin(), graph.end(), [](unsigned row) { return std::popcount(row) < 3; }))
    return false;
  const unsigned all = (1U << graph.size()) - 1U;
  for (unsigned removed = 0; removed <= all; ++removed)
    if (std::popcount(removed) <= 2 && !is_connected(graph, all & ~removed)) return false;
  return true;
}

/// Whether the vertices of the set induce a circle and the rest is connected.
bool is_facet(const Graph& graph, unsigned set) {
  if (std::popcount(set) < 3) return false;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if ((set >> v & 1U) != 0 && std::popcount(graph[v] & set) != 2) return false;
  return is_connected(graph, set) && is_connected(graph, ((1U << graph.size()) - 1U) & ~set);
}

/// Whether it is a polyhedron whose facets are triangles and quads.
bool is_wanted(const Graph& graph) {
  if (!is_three_connected(graph)) return false;
  std::vector<std::vector<int>> facets_at(graph.size(), std::vector<int>(graph.size(), 0));
  for (unsigned set = 0; set < 1U << graph.size(); ++set) {
    if (!is_facet(graph, set)) continue;
    if (std::popcount(set) > 4) return false;
    for (std::size_t a = 0; a < graph.size(); ++a)
      for (std::size_t b = 0; b < graph.size(); ++b)
        if ((set >> a & 1U) != 0 && (set & graph[a] & 1U << b) != 0) ++facets_at[a][b];
  }
  for (std::size_t a = 0; a < graph.size(); ++a)
    for (std::size_t b = 0; b < graph.size(); ++b)
      if ((graph[a] >> b & 1U) != 0 && facets_at[a][b] != 2) return false;
  return true;
}

Graph graph_of(const complex::Cell& cell) {
  Graph graph(static_cast<std::size_t>(cell.vertices), 0);
  for (const auto& facet : cell.facets)
    for (std::size_t i = 0; i < facet.size; ++i) {
      const auto a = facet.vertex[i];
      const auto b = facet.vertex[(i + 1) % facet.size];
      graph[a] |= 1U << b;
      graph[b] |= 1U << a;
    }
  return graph;
}

TEST(Polyhedra, AllGraphsWithUpToSevenVertices) {
  std::uint64_t factorial = 6;
  for (int vertices = 4; vertices <= 7; ++vertices) {
    factorial *= static_cast<std::uint64_t>(vertices);
    std::uint64_t labelled = 0;
    const int pairs = vertices * (vertices - 1) / 2;
    for (unsigned set = 0; set < 1U << static_cast<unsigned>(pairs); ++set) {
      // At least three edges at a vertex, and no more than a planar graph has.
      const int edges = std::popcount(set);
      if (2 * edges < 3 * vertices || edges > 3 * vertices - 6) continue;
      Graph graph(static_cast<std::size_t>(vertices), 0);
      unsigned bit = 0;
      for (std::size_t a = 0; a < graph.size(); ++a)
        for (std::size_t b = a + 1; b < graph.size(); ++b, ++bit)
          if ((set >> bit & 1U) != 0) {
            graph[a] |= 1U << b;
            graph[b] |= 1U << a;
          }
      if (is_wanted(graph)) ++labelled;
    }
    std::uint64_t by_class = 0;
    for (const auto& cell : balls::polyhedra(vertices))
      by_class += factorial / complex::symmetries(cell).size();
    EXPECT_EQ(by_class, labelled);
  }
}

TEST(Polyhedra, Numbers) {
  const std::vector<std::size_t> triangulated{1, 1, 2, 5, 14};
  const std::vector<std::size_t> all{1, 2, 6, 28, 183};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int vertices = static_cast<int>(i) + 4;
    const auto list = balls::polyhedra(vertices);
    EXPECT_EQ(list.size(), all[i]);
    EXPECT_EQ(balls::triangulated_spheres(vertices).size(), triangulated[i]);
    std::set<std::vector<complex::CellFacet>> different;
    for (const auto& cell : list) {
      EXPECT_TRUE(is_wanted(graph_of(cell)));
      different.insert(cell.facets);
    }
    EXPECT_EQ(different.size(), list.size());
  }
}

TEST(Polyhedra, TheOneWithSixQuadsIsTheHexahedron) {
  const auto list = balls::polyhedra(8);
  ASSERT_FALSE(list.empty());
  EXPECT_EQ(list.back().facets.size(), 6U);
  EXPECT_EQ(complex::symmetries(list.back()).size(), 48U);
}

}  // namespace
