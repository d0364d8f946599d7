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

/// By the definition, in other words: sines from cosines for plane quads would not see signs.
double quality_by_definition(const mesh::FacetMesh& mesh, const std::array<mesh::Index, 4>& v) {
  using V = std::array<double, 3>;
  const auto minus = [&](mesh::Index a, mesh::Index b) {
    const auto& p = mesh.points[a];
    const auto& q = mesh.points[b];
    return V{p.x - q.x, p.y - q.y, p.z - q.z};
  };
  const auto cross = [](const V& a, const V& b) {
    return V{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto dot = [](const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
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

std::set<std::set<mesh::Index>> by_brute_force(const mesh::FacetMesh& mesh, double quality) {
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
          if (triangles.contains({a, c, d}) && quality_by_definition(mesh, {a, b, c, d}) > quality)
            sets.insert({a, b, c, d});
      }
  return sets;
}

TEST(Quads, CandidatesAreThoseOfBruteForce) {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    const mesh::FacetMesh mesh = cut_lattice(1 + round % 4, 1.2, random);
    for (const double quality : {0.0, 0.3, 0.8})
      EXPECT_EQ(sets_of(hybrid::quad_candidates(mesh, quality)), by_brute_force(mesh, quality));
  }
}

TEST(Quads, SquaresOfALatticeAreFound) {
  Random random(2);
  const mesh::FacetMesh mesh = cut_lattice(30, 0, random);
  const auto candidates = hybrid::quad_candidates(mesh, 0.1);
  const auto chosen = hybrid::quad_selection(candidates, mesh.facets.size());
  EXPECT_EQ(chosen.size(), 900U);
  for (const std::size_t i : chosen) EXPECT_NEAR(candidates[i].quality, 1, 1e-12);
  const mesh::FacetMesh result = hybrid::with_quads(mesh, candidates, chosen);
  EXPECT_EQ(result.facets.size(), 900U);
  EXPECT_EQ(result.points, mesh.points);
}

/// The most quads, by trying for the first free triangle all its candidates, or none.
std::size_t most_quads(const std::vector<QuadCandidate>& candidates, std::uint32_t used,
                       std::uint32_t triangles, std::map<std::uint32_t, std::size_t>& known) {
  if (used == (1U << triangles) - 1U) return 0;
  if (const auto it = known.find(used); it != known.end()) return it->second;
  std::uint32_t t = 0;
  while ((used >> t & 1U) != 0) ++t;
  std::size_t best = most_quads(candidates, used | 1U << t, triangles, known);
  for (const QuadCandidate& c : candidates) {
    const std::uint32_t both = 1U << c.triangles[0] | 1U << c.triangles[1];
    if ((both >> t & 1U) == 0 || (used & both) != 0) continue;
    best = std::max(best, 1 + most_quads(candidates, used | both, triangles, known));
  }
  return known[used] = best;
}

TEST(Quads, SelectionIsAFullMatchingNearTheGreatest) {
  Random random(3);
  std::size_t found = 0;
  std::size_t greatest = 0;
  for (int round = 0; round < 60; ++round) {
    const mesh::FacetMesh mesh = cut_lattice(3, 1.5, random);
    const auto candidates = hybrid::quad_candidates(mesh, 0.5);
    const auto chosen = hybrid::quad_selection(candidates, mesh.facets.size());
    std::vector<int> uses(mesh.facets.size(), 0);
    for (const std::size_t i : chosen)
      for (const std::uint32_t t : candidates[i].triangles) ++uses[t];
    EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 1);
    for (const QuadCandidate& c : candidates)
      EXPECT_GT(uses[c.triangles[0]] + uses[c.triangles[1]], 0) << "a quad can be added";
    std::map<std::uint32_t, std::size_t> known;
    const std::size_t best = most_quads(candidates, 0, 18, known);
    EXPECT_LE(chosen.size(), best);
    found += chosen.size();
    greatest += best;
    const mesh::FacetMesh result = hybrid::with_quads(mesh, candidates, chosen);
    EXPECT_EQ(result.facets.size() + chosen.size(), mesh.facets.size());
  }
  EXPECT_GT(greatest, 200U);
  EXPECT_GE(static_cast<double>(found), 0.995 * static_cast<double>(greatest));
}

TEST(Quads, TrianglesTurnedAgainstEachOtherAreNoQuad) {
  mesh::FacetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                       {triangle(0, 1, 2), triangle(0, 3, 2)}};
  EXPECT_TRUE(hybrid::quad_candidates(mesh, 0).empty());
  mesh.facets[1] = triangle(0, 2, 3);
  EXPECT_EQ(hybrid::quad_candidates(mesh, 0).size(), 1U);
  mesh.facets.push_back(triangle(0, 2, 3));  // a second sheet there
  EXPECT_EQ(hybrid::quad_candidates(mesh, 0).size(), 2U);
}

}  // namespace
}  // namespace hexatlas
