// Claim. topology_of() tells balls and spheres from other complexes, shellings are shellings, and
// orientations are coherent.
// Oracle. Complexes whose topology is known from their construction; the definition of a shelling,
// word by word, on sets of faces.
#include "enum/complex/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace hexatlas::complex;

VertexSet set_of(const std::vector<int>& vertices) {
  unsigned set = 0;
  for (const int v : vertices) set |= 1U << static_cast<unsigned>(v);
  return static_cast<VertexSet>(set);
}

Triangulation from(int vertices, const std::vector<std::vector<int>>& tetrahedra) {
  Triangulation result{vertices, {}};
  for (const auto& t : tetrahedra) result.tetrahedra.push_back(set_of(t));
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  return result;
}

/// The cyclic polytope boundary: neighbourly, so with as many tetrahedra as possible.
Triangulation cyclic_sphere(int n) {
  Triangulation result{n, {}};
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1)) result.tetrahedra.push_back(set_of({i, i + 1, j, (j + 1) % n}));
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  return result;
}

std::set<unsigned> faces_of(unsigned simplex) {
  std::set<unsigned> faces;
  for (unsigned face = simplex; face != 0; face = (face - 1U) & simplex) faces.insert(face);
  return faces;
}

bool is_shelling(const Triangulation& triangulation, const std::vector<std::size_t>& order) {
  std::set<unsigned> before = faces_of(triangulation.tetrahedra[order[0]]);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::set<unsigned> own = faces_of(triangulation.tetrahedra[order[i]]);
    std::set<unsigned> common, covered;
    std::set_intersection(own.begin(), own.end(), before.begin(), before.end(),
                          std::inserter(common, common.end()));
    for (const unsigned face : common)
      if (std::popcount(face) == 3) covered.merge(faces_of(face));
    if (covered.empty() || covered != common) return false;
    before.insert(own.begin(), own.end());
  }
  return std::set<std::size_t>(order.begin(), order.end()).size() ==
         triangulation.tetrahedra.size();
}

TEST(Triangulation, CyclicSpheresAreShellableSpheresAndTheirPartsBalls) {
  for (int n = 5; n <= 12; ++n) {
    SCOPED_TRACE("n = " + std::to_string(n));
    Triangulation sphere = cyclic_sphere(n);
    ASSERT_EQ(sphere.tetrahedra.size(), static_cast<std::size_t>(n * (n - 3) / 2));
    EXPECT_EQ(topology_of(sphere), Topology::sphere);
    EXPECT_TRUE(boundary_triangles(sphere).empty());
    const ShellingAnswer answer = search_shelling(sphere);
    ASSERT_EQ(answer.outcome, ShellingSearch::found);
    EXPECT_TRUE(is_shelling(sphere, answer.order));
    std::erase_if(sphere.tetrahedra, [](VertexSet t) { return (t & 1U) != 0; });
    EXPECT_EQ(topology_of(sphere), Topology::ball);
    const ShellingAnswer part = search_shelling(sphere);
    ASSERT_EQ(part.outcome, ShellingSearch::found);
    EXPECT_TRUE(is_shelling(sphere, part.order));
    ASSERT_TRUE(orientation_of(sphere));
  }
}

TEST(Triangulation, OrientationsCancelAtInnerTriangles) {
  const Triangulation sphere = cyclic_sphere(9);
  const auto signs = orientation_of(sphere);
  ASSERT_TRUE(signs);
  std::map<unsigned, int> chain;  // the boundary of the sum of the oriented tetrahedra
  for (std::size_t t = 0; t < signs->size(); ++t) {
    const auto v = vertices_of(sphere.tetrahedra[t]);
    for (int i = 0; i < 4; ++i)
      chain[sphere.tetrahedra[t] & ~(1U << v[static_cast<std::size_t>(i)])] +=
          (i % 2 == 0 ? 1 : -1) * (*signs)[t];
  }
  for (const auto& [triangle, coefficient] : chain) EXPECT_EQ(coefficient, 0);
}

TEST(Triangulation, OtherComplexesAreNoBalls) {
  // Two tetrahedra at a vertex, at an edge, apart.
  EXPECT_EQ(topology_of(from(7, {{0, 1, 2, 3}, {3, 4, 5, 6}})), Topology::other);
  EXPECT_EQ(topology_of(from(6, {{0, 1, 2, 3}, {2, 3, 4, 5}})), Topology::other);
  EXPECT_EQ(topology_of(from(8, {{0, 1, 2, 3}, {4, 5, 6, 7}})), Topology::other);
  EXPECT_EQ(topology_of(from(6, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}})), Topology::other);
  // A solid torus: a cycle of prisms with triangle sections 012, 345, 678.
  std::vector<std::vector<int>> torus;
  for (int i = 0; i < 3; ++i) {
    const int a = 3 * i, b = 3 * ((i + 1) % 3);
    torus.push_back({a, a + 1, a + 2, b});
    torus.push_back({a + 1, a + 2, b, b + 1});
    torus.push_back({a + 2, b, b + 1, b + 2});
  }
  EXPECT_EQ(topology_of(from(9, torus)), Topology::other);
  // A thick sphere: octahedron 0..5 inside, octahedron 6..11 outside, prisms between them.
  std::vector<std::vector<int>> shell;
  for (const int x : {0, 1})
    for (const int y : {2, 3})
      for (const int z : {4, 5}) {
        shell.push_back({x, y, z, z + 6});
        shell.push_back({x, y, y + 6, z + 6});
        shell.push_back({x, x + 6, y + 6, z + 6});
      }
  EXPECT_EQ(topology_of(from(12, shell)), Topology::other);
}

TEST(Triangulation, TheNonOrientableSphereBundleIsNoSphere) {
  // Altshuler and Steinberg's 3-manifold with nine vertices: the Walkup family, facets i .. i+4
  // without one inner vertex, modulo 9 (the twisted product of the sphere and the circle).
  Triangulation bundle{9, {}};
  for (int i = 0; i < 9; ++i)
    for (const int left_out : {1, 2, 3}) {
      std::vector<int> t;
      for (int j = 0; j < 5; ++j)
        if (j != left_out) t.push_back((i + j) % 9);
      bundle.tetrahedra.push_back(set_of(t));
    }
  std::sort(bundle.tetrahedra.begin(), bundle.tetrahedra.end());
  ASSERT_EQ(bundle.tetrahedra.size(), 27U);
  EXPECT_TRUE(boundary_triangles(bundle).empty());
  EXPECT_FALSE(orientation_of(bundle));
  EXPECT_EQ(topology_of(bundle), Topology::other);
}

}  // namespace
