// Claim. quad_candidates() finds every pair of triangles that form a quad of a given quality;
// quad_selection() chooses disjoint ones, nearly as many as possible; with_quads() loses nothing.
// Oracles. Brute force over all cycles of four vertices; the greatest matching by trying all;
// lattices of squares cut at random.
#include "meshing/hybrid/quads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace hexatlas {
namespace {

using hybrid::QuadCandidate;
using Random = std::mt19937_64;

double unit(Random& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

mesh::Facet triangle(mesh::Index a, mesh::Index b, mesh::Index c) { return {{a, b, c, 0}, 3, 0}; }

/// n x n squares, each cut along one of its diagonals by chance; inner points moved by `noise`.
mesh::FacetMesh cut_lattice(unsigned n, double noise, Random& random) {
  mesh::FacetMesh mesh;
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j) {
      const bool is_inner = i > 0 && j > 0 && i < n && j < n;
      const double size = is_inner ? noise : 0;
      const double x = i + size * (unit(random) - 0.5);
      const double y = j + size * (unit(random) - 0.5);
      mesh.points.push_back({x, y, size * (unit(random) - 0.5)});
    }
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      const mesh::Index a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      if (random() % 2 == 0) {
        mesh.facets.push_back(triangle(a, b, c));
        mesh.facets.push_back(triangle(a, c, d));
      } else {
        mesh.facets.push_back(triangle(b, c, d));
        mesh.facets.push_back(triangle(b, d, a));
      }
    }
  std::shuffle(mesh.facets.begin(), mesh.facets.end(), random);
  return mesh;
}

using V = std::array<double, 3>;

V difference(const mesh::FacetMesh& mesh, mesh::Index a, mesh::Index b) {
  const auto& p = mesh.points[a];
  const auto& q = mesh.points[b];
  return V{p.x - q.x, p.y - q.y, p.z - q.z};
}

V cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Between the planes of a b c and a c d, by how far b and d turn around a c.
double fold_by_definition(const mesh::FacetMesh& mesh, const std::array<mesh::Index, 4>& v) {
  const V axis = difference(mesh, v[2], v[0]);
  const V from = cross(axis, difference(mesh, v[0], v[1]));
  const V to = cross(axis, difference(mesh, v[3], v[0]));
  const V both = cross(from, to);
  return std::atan2(std::sqrt(dot(both, both)), dot(from, to)) * 180 / 3.14159265358979323846;
}

/// By the definition, in other words: sines from cosines for plane quads would not see signs.
double quality_by_definition(const mesh::FacetMesh& mesh, const std::array<mesh::Index, 4>& v) {
  const auto minus = [&](mesh::Index a, mesh::Index b) { return difference(mesh, a, b); };
  const V n = cross(minus(v[2], v[0]), minus(v[3], v[1]));
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const V e = minus(v[(i + 1) % 4], v[i]);
    const V f = minus(v[(i + 3) % 4], v[i]);
    least = std::min(least, dot(cross(e, f), n) / std::sqrt(dot(e, e) * dot(f, f) * dot(n, n)));
  }
  return least;
}

std::set<std::set<mesh::Index>> sets_of(const std::vector<QuadCandidate>& candidates) {
  std::set<std::set<mesh::Index>> sets;
  for (const QuadCandidate& c : candidates)
    EXPECT_TRUE(sets.insert({c.vertices.begin(), c.vertices.end()}).second);
  return sets;
}

std::set<std::set<mesh::Index>> by_brute_force(const mesh::FacetMesh& mesh, double quality,
                                               double fold) {
  std::set<std::array<mesh::Index, 3>> triangles;
  for (const mesh::Facet& f : mesh.facets)
    for (std::size_t i = 0; i < 3; ++i)
      triangles.insert({f.vertices[i], f.vertices[(i + 1) % 3], f.vertices[(i + 2) % 3]});
  std::set<std::set<mesh::Index>> sets;
  const auto n = static_cast<mesh::Index>(mesh.points.size());
  for (mesh::Index a = 0; a < n; ++a)
    for (mesh::Index b = 0; b < n; ++b)
      for (mesh::Index c = 0; c < n; ++c) {
        if (!triangles.contains({a, b, c})) continue;
        for (mesh::Index d = 0; d < n; ++d)
          if (triangles.contains({a, c, d}) &&
              quality_by_definition(mesh, {a, b, c, d}) > quality &&
              fold_by_definition(mesh, {a, b, c, d}) <= fold)
            sets.insert({a, b, c, d});
      }
  return sets;
}

TEST(Quads, CandidatesAreThoseOfBruteForce) {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    const mesh::FacetMesh mesh = cut_lattice(1 + round % 4, 1.2, random);
    for (const double quality : {0.0, 0.3, 0.8})
      for (const double fold : {20.0, 45.0, 180.0})
        EXPECT_EQ(sets_of(hybrid::quad_candidates(mesh, {quality, fold})),
                  by_brute_force(mesh, quality, fold));
  }
}

TEST(Quads, SquaresOfALatticeAreFound) {
  Random random(2);
  const mesh::FacetMesh mesh = cut_lattice(30, 0, random);
  const auto candidates = hybrid::quad_candidates(mesh, {0.1, 180});
  const auto chosen = hybrid::quad_selection(mesh, candidates);
  EXPECT_EQ(chosen.size(), 900U);
  for (const std::size_t i : chosen) EXPECT_NEAR(candidates[i].quality, 1, 1e-12);
  const mesh::FacetMesh result = hybrid::with_quads(mesh, candidates, chosen);
  EXPECT_EQ(result.facets.size(), 900U);
  EXPECT_EQ(result.points, mesh.points);
}

/// Facets at each vertex, unless it is on the rim, which an edge of one facet tells.
std::map<mesh::Index, int> facets_inside(const mesh::FacetMesh& mesh) {
  std::map<mesh::Index, int> facets;
  std::map<std::set<mesh::Index>, int> edges;
  for (const mesh::Facet& f : mesh.facets)
    for (std::size_t i = 0; i < f.size; ++i) {
      ++facets[f.vertices[i]];
      ++edges[{f.vertices[i], f.vertices[(i + 1) % f.size]}];
    }
  for (const auto& [edge, count] : edges)
    if (count == 1)
      for (const mesh::Index v : edge) facets.erase(v);
  return facets;
}

bool has_doublet(const mesh::FacetMesh& mesh) {
  const auto facets = facets_inside(mesh);
  return std::any_of(facets.begin(), facets.end(), [](const auto& at) { return at.second == 2; });
}

/// The most quads without a doublet, by trying for the first free triangle all its candidates, or
/// none.
std::size_t most_quads(const std::vector<QuadCandidate>& candidates, std::uint32_t used,
                       std::uint32_t triangles, std::map<mesh::Index, int>& facets) {
  if (used == (1U << triangles) - 1U) return 0;
  std::uint32_t t = 0;
  while ((used >> t & 1U) != 0) ++t;
  std::size_t best = most_quads(candidates, used | 1U << t, triangles, facets);
  for (const QuadCandidate& c : candidates) {
    const std::uint32_t both = 1U << c.triangles[0] | 1U << c.triangles[1];
    if ((both >> t & 1U) == 0 || (used & both) != 0) continue;
    const auto lose = [&](int edges) {
      for (const mesh::Index v : c.diagonal)
        if (facets.contains(v)) facets[v] -= edges;
    };
    lose(1);
    if (std::all_of(facets.begin(), facets.end(), [](const auto& at) { return at.second > 2; }))
      best = std::max(best, 1 + most_quads(candidates, used | both, triangles, facets));
    lose(-1);
  }
  return best;
}

TEST(Quads, SelectionIsAFullMatchingNearTheGreatest) {
  Random random(3);
  std::size_t found = 0;
  std::size_t greatest = 0;
  for (int round = 0; round < 60; ++round) {
    const mesh::FacetMesh mesh = cut_lattice(3, 1.5, random);
    const auto candidates = hybrid::quad_candidates(mesh, {0.5, 180});
    const auto chosen = hybrid::quad_selection(mesh, candidates);
    std::vector<int> uses(mesh.facets.size(), 0);
    for (const std::size_t i : chosen)
      for (const std::uint32_t t : candidates[i].triangles) ++uses[t];
    EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 1);
    EXPECT_FALSE(has_doublet(hybrid::with_quads(mesh, candidates, chosen)));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (uses[candidates[i].triangles[0]] + uses[candidates[i].triangles[1]] > 0) continue;
      std::vector<std::size_t> more = chosen;
      more.push_back(i);
      EXPECT_TRUE(has_doublet(hybrid::with_quads(mesh, candidates, more))) << "a quad can be added";
    }
    std::map<mesh::Index, int> facets = facets_inside(mesh);
    const std::size_t best = most_quads(candidates, 0, 18, facets);
    EXPECT_LE(chosen.size(), best);
    found += chosen.size();
    greatest += best;
    const mesh::FacetMesh result = hybrid::with_quads(mesh, candidates, chosen);
    EXPECT_EQ(result.facets.size() + chosen.size(), mesh.facets.size());
  }
  EXPECT_GT(greatest, 200U);
  EXPECT_GE(static_cast<double>(found), 0.995 * static_cast<double>(greatest));
}

TEST(Quads, ClosedSurfacesGetNoDoublets) {
  const mesh::FacetMesh tetrahedron{
      {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
      {triangle(0, 1, 2), triangle(0, 2, 3), triangle(0, 3, 1), triangle(1, 3, 2)}};
  const auto six = hybrid::quad_candidates(tetrahedron, {0, 180});
  EXPECT_EQ(six.size(), 6U);
  EXPECT_TRUE(hybrid::quad_selection(tetrahedron, six).empty());
  mesh::FacetMesh octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                             {}};
  for (const mesh::Index x : {0U, 1U})
    for (const mesh::Index y : {2U, 3U})
      for (const mesh::Index z : {4U, 5U})
        octahedron.facets.push_back((x + y + z) % 2 == 0 ? triangle(x, y, z) : triangle(x, z, y));
  const auto twelve = hybrid::quad_candidates(octahedron, {0, 180});
  EXPECT_EQ(twelve.size(), 12U);
  EXPECT_EQ(hybrid::quad_selection(octahedron, twelve).size(), 3U);
  EXPECT_TRUE(hybrid::quad_candidates(octahedron, {0, 70}).empty());
}

/// Two octahedra with a vertex in common: four facets in each fan there.
TEST(Quads, PinchedVerticesGetNoDoublets) {
  mesh::FacetMesh both{{{0, 0, 0}}, {}};
  for (const double sign : {1.0, -1.0}) {
    const auto top = static_cast<mesh::Index>(both.points.size());
    for (const mesh::Point& p :
         std::vector<mesh::Point>{{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}, {0, 0, 2}})
      both.points.push_back({p.x, p.y, sign * p.z});
    for (mesh::Index i = 0; i < 4; ++i)
      for (const mesh::Index apex : {mesh::Index{0}, top + 4})
        both.facets.push_back((sign > 0) == (apex == 0)
                                  ? triangle(apex, top + (i + 1) % 4, top + i)
                                  : triangle(apex, top + i, top + (i + 1) % 4));
  }
  const auto candidates = hybrid::quad_candidates(both, {0, 180});
  const auto chosen = hybrid::quad_selection(both, candidates);
  EXPECT_EQ(chosen.size(), 6U);
  std::map<std::pair<bool, mesh::Index>, int> lost;  // of each octahedron
  for (const std::size_t i : chosen)
    for (const mesh::Index v : candidates[i].diagonal) {
      const bool is_first = candidates[i].triangles[0] < 8;
      EXPECT_EQ((++lost[{is_first, v}]), 1) << v;
    }
}

TEST(Quads, NoneCrossesFromOneColourToAnother) {
  Random random(77);
  mesh::FacetMesh mesh = cut_lattice(6, 0, random);
  for (mesh::Facet& facet : mesh.facets) facet.colour = static_cast<std::int64_t>(random() % 2) * 9;
  const auto candidates = hybrid::quad_candidates(mesh, {0.1, 45});
  std::size_t both = 0;
  for (const QuadCandidate& c : candidates) {
    EXPECT_EQ(mesh.facets[c.triangles[0]].colour, mesh.facets[c.triangles[1]].colour);
    both += mesh.facets[c.triangles[0]].colour == 9 ? 1U : 0U;
  }
  EXPECT_GT(both, 0U);
  EXPECT_GT(candidates.size(), both);
  const auto triangles_of_nine = [](const mesh::FacetMesh& some) {
    std::size_t triangles = 0;
    for (const mesh::Facet& facet : some.facets)
      if (facet.colour == 9) triangles += facet.size - 2U;
    return triangles;
  };
  const auto chosen = hybrid::quad_selection(mesh, candidates);
  EXPECT_EQ(triangles_of_nine(hybrid::with_quads(mesh, candidates, chosen)),
            triangles_of_nine(mesh));
  // Without colours there are more.
  for (mesh::Facet& facet : mesh.facets) facet.colour = 0;
  EXPECT_GT(hybrid::quad_candidates(mesh, {0.1, 45}).size(), candidates.size());
}

TEST(Quads, TrianglesInOnePlaneFoldNowhere) {
  Random random(4);
  mesh::FacetMesh mesh = cut_lattice(8, 0, random);
  for (mesh::Point& p : mesh.points) p.z = p.x + 2 * p.y;
  EXPECT_EQ(sets_of(hybrid::quad_candidates(mesh, {0, 0})),
            sets_of(hybrid::quad_candidates(mesh, {0, 180})));
}

TEST(Quads, TrianglesTurnedAgainstEachOtherAreNoQuad) {
  mesh::FacetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                       {triangle(0, 1, 2), triangle(0, 3, 2)}};
  EXPECT_TRUE(hybrid::quad_candidates(mesh, {0, 180}).empty());
  mesh.facets[1] = triangle(0, 2, 3);
  EXPECT_EQ(hybrid::quad_candidates(mesh, {0, 180}).size(), 1U);
  mesh.facets.push_back(triangle(0, 2, 3));  // a second sheet there
  EXPECT_EQ(hybrid::quad_candidates(mesh, {0, 180}).size(), 2U);
}

}  // namespace
}  // namespace hexatlas
