// Claim. The front search meets exactly the triangulations of the definition, each once, with every
// pruning on or off.
// Oracle. All subsets of the candidate tetrahedra, judged by conditions 1 to 5 as they are written;
// up to seven vertices, where an orientable connected complex with good links is a ball.
#include "enum/balls/front_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "enum/complex/cell.hpp"
#include "enum/complex/triangulation.hpp"
#include "enum/search/depth_first.hpp"

namespace {

using namespace hexatlas;
using balls::FrontSearch;
using balls::Prunings;
using complex::Cell;
using complex::VertexSet;
using Tetrahedra = std::vector<VertexSet>;

std::vector<VertexSet> four_on_a_facet(const Cell& cell) {
  std::vector<VertexSet> sets;
  for (const auto& facet : cell.facets)
    if (facet.size == 4) sets.push_back(facet.vertices());
  return sets;
}

/// The least of the numberings of the interior vertices.
Tetrahedra with_least_interior(const Tetrahedra& tetrahedra, int first, int count) {
  complex::VertexMap map{};
  std::iota(map.begin(), map.end(), std::uint8_t{0});
  Tetrahedra least;
  do {
    Tetrahedra image;
    for (const VertexSet t : tetrahedra) image.push_back(complex::image_of(t, map));
    std::sort(image.begin(), image.end());
    if (least.empty() || image < least) least = image;
  } while (std::next_permutation(map.begin() + first, map.begin() + first + count));
  return least;
}

struct Found {
  std::multiset<Tetrahedra> balls;
  std::uint64_t nodes = 0;
};

Found by_search(const Cell& cell, int interior, bool on_facets, Prunings prunings) {
  Found found;
  for (const auto& surface : complex::cut_surfaces(cell)) {
    FrontSearch problem(surface.triangles, cell.vertices, interior,
                        on_facets ? Tetrahedra{} : four_on_a_facet(cell), prunings);
    const auto result = search::explore(problem, {}, {}, [&](const FrontSearch& at) {
      Tetrahedra all(at.tetrahedra().begin(), at.tetrahedra().end());
      std::sort(all.begin(), all.end());
      if (complex::topology_of({cell.vertices + interior, all}) == complex::Topology::ball)
        found.balls.insert(with_least_interior(all, cell.vertices, interior));
      return true;
    });
    found.nodes += result.counts.nodes;
  }
  return found;
}

using Faces = std::map<VertexSet, int>;

bool is_circle_or_path(const std::vector<VertexSet>& edges, bool circle) {
  std::map<int, int> degree;
  unsigned reached = edges.front(), all = 0;
  for (const VertexSet e : edges) {
    all |= e;
    for (int v = 0; v < 16; ++v) degree[v] += (e >> v) & 1;
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const VertexSet e : edges)
      if ((e & reached) != 0) reached |= e;
  int ends = 0;
  for (const auto& [v, d] : degree) {
    if (d > 2) return false;
    ends += d == 1 ? 1 : 0;
  }
  return reached == all && ends == (circle ? 0 : 2);
}

/// Conditions 2 to 5 for one boundary, by counting.
bool is_triangulation(const Tetrahedra& tetrahedra, const std::set<VertexSet>& boundary, int n) {
  Faces triangles, edges;
  unsigned vertices = 0;
  for (const VertexSet t : tetrahedra) {
    vertices |= t;
    for (unsigned face = t; face != 0; face = (face - 1U) & t) {
      if (std::popcount(face) == 3) ++triangles[static_cast<VertexSet>(face)];
      if (std::popcount(face) == 2) ++edges[static_cast<VertexSet>(face)];
    }
  }
  if (vertices != (1U << n) - 1U) return false;
  for (const auto& [triangle, count] : triangles)
    if (count != (boundary.contains(triangle) ? 1 : 2)) return false;
  for (const VertexSet triangle : boundary)
    if (!triangles.contains(triangle)) return false;
  std::map<VertexSet, bool> is_outer;
  for (const VertexSet triangle : boundary)
    for (unsigned e = triangle; e != 0; e = (e - 1U) & triangle)
      if (std::popcount(e) == 2) is_outer[static_cast<VertexSet>(e)] = true;
  for (const auto& [edge, count] : edges) {
    std::vector<VertexSet> link;
    for (const VertexSet t : tetrahedra)
      if ((t & edge) == edge) link.push_back(static_cast<VertexSet>(t & ~unsigned{edge}));
    if (!is_circle_or_path(link, !is_outer[edge])) return false;
  }
  for (int v = 0; v < n;
       ++v) {  // links of vertices: connected, Euler characteristic of disc or sphere
    const unsigned bit = 1U << v;
    std::vector<VertexSet> link;
    bool outer = false;
    int link_vertices = 0, link_edges = 0;
    for (const VertexSet t : tetrahedra)
      if ((t & bit) != 0) link.push_back(static_cast<VertexSet>(t & ~bit));
    for (const auto& [edge, count] : edges)
      if ((edge & bit) != 0) {
        ++link_vertices;
        outer = outer || is_outer[edge];
      }
    for (const auto& [triangle, count] : triangles) link_edges += (triangle & bit) != 0 ? 1 : 0;
    unsigned reached = link.front(), all = 0;
    for (const VertexSet t : link) all |= t;
    for (std::size_t i = 0; i < link.size(); ++i)
      for (const VertexSet t : link)
        if ((t & reached) != 0) reached |= t;
    const int euler = link_vertices - link_edges + static_cast<int>(link.size());
    if (reached != all || euler != (outer ? 1 : 2)) return false;
  }
  unsigned reached = tetrahedra.front();
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    for (const VertexSet t : tetrahedra)
      if (std::popcount(reached & t) >= 1) reached |= t;
  return reached == vertices && complex::orientation_of({n, tetrahedra}).has_value();
}

std::multiset<Tetrahedra> by_all_subsets(const Cell& cell, int interior, bool on_facets) {
  const int n = cell.vertices + interior;
  const auto forbidden = four_on_a_facet(cell);
  Tetrahedra candidates;
  for (unsigned t = 0; t < (1U << n); ++t)
    if (std::popcount(t) == 4 &&
        (on_facets || std::find(forbidden.begin(), forbidden.end(), t) == forbidden.end()))
      candidates.push_back(static_cast<VertexSet>(t));
  std::set<std::set<VertexSet>> boundaries;
  for (const auto& surface : complex::cut_surfaces(cell)) {
    std::set<VertexSet> boundary;
    for (const auto& t : surface.triangles)
      boundary.insert(static_cast<VertexSet>((1U << t[0]) | (1U << t[1]) | (1U << t[2])));
    boundaries.insert(boundary);
  }
  std::set<Tetrahedra> found;
  for (std::uint32_t subset = 1; subset < (1U << candidates.size()); ++subset) {
    Tetrahedra chosen;
    Faces triangles;
    bool possible = true;
    for (std::uint32_t rest = subset; rest != 0 && possible; rest &= rest - 1U) {
      const VertexSet t = candidates[static_cast<std::size_t>(std::countr_zero(rest))];
      chosen.push_back(t);
      for (int v = 0; v < n; ++v)
        if (((t >> v) & 1) != 0)
          possible = possible && ++triangles[static_cast<VertexSet>(t & ~(1U << v))] <= 2;
    }
    if (!possible) continue;
    std::set<VertexSet> boundary;
    for (const auto& [triangle, count] : triangles)
      if (count == 1) boundary.insert(triangle);
    if (boundaries.contains(boundary) && is_triangulation(chosen, boundary, n))
      found.insert(with_least_interior(chosen, cell.vertices, interior));
  }
  return {found.begin(), found.end()};
}

struct Case {
  const char* cell;
  int interior;
  bool on_facets;
};

// Found by name by GoogleTest, which would print the bytes of the struct, an address among them.
void PrintTo(const Case& one, std::ostream* out) {
  *out << one.cell << " with " << one.interior << (one.on_facets ? ", on facets" : "");
}

class SmallCells : public testing::TestWithParam<Case> {};

TEST_P(SmallCells, SearchMeetsWhatTheDefinitionSays) {
  const auto [name, interior, on_facets] = GetParam();
  const Cell cell = *complex::cell_named(name);
  EXPECT_EQ(by_search(cell, interior, on_facets, {}).balls,
            by_all_subsets(cell, interior, on_facets));
}

INSTANTIATE_TEST_SUITE_P(Cells, SmallCells,
                         testing::Values(Case{"tetrahedron", 0, false},
                                         Case{"tetrahedron", 1, false},
                                         Case{"tetrahedron", 2, false}, Case{"pyramid", 0, false},
                                         Case{"pyramid", 0, true}, Case{"pyramid", 1, false},
                                         Case{"pyramid", 1, true}, Case{"prism", 0, false},
                                         Case{"prism", 0, true}, Case{"octahedron", 0, false}),
                         [](const testing::TestParamInfo<Case>& one) {
                           return std::string(one.param.cell) +
                                  std::to_string(one.param.interior) +
                                  (one.param.on_facets ? "facets" : "");
                         });

TEST(FrontSearch, NoPruningLosesATriangulation) {
  for (const auto& [name, interior] : std::vector<std::pair<std::string, int>>{
           {"prism", 1}, {"octahedron", 1}, {"tetrahedron", 3}}) {
    SCOPED_TRACE(name);
    const Cell cell = *complex::cell_named(name);
    const Found all = by_search(cell, interior, false, {});
    EXPECT_GT(all.balls.size(), 100U);
    for (const Prunings off : {Prunings{.edge_links = false}, Prunings{.vertex_links = false},
                               Prunings{.open_triangles = false}, Prunings{false, false, false}}) {
      const Found without = by_search(cell, interior, false, off);
      EXPECT_EQ(without.balls, all.balls);
      EXPECT_GE(without.nodes, all.nodes);
    }
  }
}

TEST(FrontSearch, UndoRestoresTheState) {
  const Cell cell = *complex::cell_named("prism");
  const auto surface = complex::cut_surfaces(cell).front();
  FrontSearch problem(surface.triangles, cell.vertices, 1, four_on_a_facet(cell));
  const auto first = search::explore(problem, {}, {}, [](const FrontSearch&) { return true; });
  const auto second = search::explore(problem, {}, {}, [](const FrontSearch&) { return true; });
  EXPECT_EQ(first.counts, second.counts);
  EXPECT_GT(first.counts.solutions, 0U);
  EXPECT_FALSE(problem.apply({0, 1, 2, 15})) << "no such vertex";
  EXPECT_FALSE(problem.apply({0, 0, 0, 0}));
}

}  // namespace
