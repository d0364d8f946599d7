// Claim. triangulations_from() finds all triangulations of small cells, each class once, with its
// group. Oracle. All sets of tetrahedra on six vertices, judged by the definition; the numbers of
// the literature and of other programs; the definition for each class.
#include "enum/balls/spheres_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "enum/core/errors.hpp"
#include "tests/enum/balls/support.hpp"

namespace {

using namespace hexatlas;
using complex::Cell;
using Triangle = std::array<int, 3>;

const balls::Spheres& spheres(int vertices) {
  static std::map<int, balls::Spheres> lists;
  const auto place = lists.find(vertices);
  return place != lists.end() ? place->second
                              : lists.emplace(vertices, balls::spheres(vertices)).first->second;
}

balls::CellClasses classes(const std::string& name, int interior, balls::CellRules rules = {}) {
  const Cell cell = *complex::cell_named(name);
  return balls::triangulations_from(spheres(cell.vertices + interior + 1), cell, rules);
}

/// The triangulated boundaries of a cell: sets of triangles in which no edge comes twice.
std::set<std::set<Triangle>> boundaries(const Cell& cell) {
  std::vector<std::set<Triangle>> all{{}};
  const auto sorted = [](int a, int b, int c) {
    Triangle t{a, b, c};
    std::sort(t.begin(), t.end());
    return t;
  };
  for (const auto& facet : cell.facets) {
    const auto& v = facet.vertex;
    std::vector<std::set<Triangle>> next;
    for (const auto& chosen : all)
      for (std::size_t turn = 0; turn < (facet.size == 4 ? 2U : 1U); ++turn) {
        next.push_back(chosen);
        const auto at = [&](std::size_t i) { return v[(turn + i) % facet.size]; };
        next.back().insert(sorted(at(0), at(1), at(2)));
        if (facet.size == 4) next.back().insert(sorted(at(2), at(3), at(0)));
      }
    all = std::move(next);
  }
  std::set<std::set<Triangle>> result;
  for (const auto& triangles : all)
    if (oracle::is_sphere({triangles.begin(), triangles.end()})) result.insert(triangles);
  return result;
}

/// Whether these tetrahedra, with or without those on one facet, triangulate the cell: the cone
/// over a boundary is a closed manifold then, and with at most eight vertices a sphere.
bool is_triangulation(const oracle::Tetrahedra& tetrahedra, const Cell& cell, int vertices,
                      const std::set<std::set<Triangle>>& allowed) {
  std::map<Triangle, int> degree;
  for (const auto& [a, b, c, d] : tetrahedra)
    for (const auto& t :
         {Triangle{a, b, c}, Triangle{a, b, d}, Triangle{a, c, d}, Triangle{b, c, d}})
      ++degree[t];
  std::set<Triangle> boundary;
  for (const auto& [triangle, count] : degree)
    if (count == 1) boundary.insert(triangle);
  if (!allowed.contains(boundary)) return false;
  oracle::Tetrahedra cone = tetrahedra;
  for (const auto& [a, b, c] : boundary) cone.push_back({a, b, c, vertices});
  // No interior vertex is on the boundary, by `allowed`.
  return static_cast<int>(oracle::vertex_set(tetrahedra).size()) == vertices &&
         cell.vertices <= vertices && oracle::is_closed_manifold(cone);
}

bool has_boundary_tetrahedron(const oracle::Tetrahedra& tetrahedra, const Cell& cell) {
  return std::any_of(cell.facets.begin(), cell.facets.end(), [&](const auto& facet) {
    std::set<int> quad(facet.vertex.begin(), facet.vertex.begin() + facet.size);
    return facet.size == 4 && std::any_of(tetrahedra.begin(), tetrahedra.end(), [&](const auto& t) {
             return std::set<int>(t.begin(), t.end()) == quad;
           });
  });
}

TEST(SpheresCells, AllSetsOfTetrahedraOnSixVertices) {
  oracle::Tetrahedra candidates;
  for (int a = 0; a < 6; ++a)
    for (int b = a + 1; b < 6; ++b)
      for (int c = b + 1; c < 6; ++c)
        for (int d = c + 1; d < 6; ++d) candidates.push_back({a, b, c, d});
  for (const std::string name : {"tetrahedron", "pyramid", "prism", "octahedron"}) {
    const Cell cell = *complex::cell_named(name);
    const auto allowed = boundaries(cell);
    std::uint64_t strict = 0;
    std::uint64_t all = 0;
    for (unsigned set = 1; set < 1U << candidates.size(); ++set) {
      oracle::Tetrahedra chosen;
      for (std::size_t i = 0; i < candidates.size(); ++i)
        if ((set >> i & 1U) != 0) chosen.push_back(candidates[i]);
      if (!is_triangulation(chosen, cell, 6, allowed)) continue;
      ++all;
      if (!has_boundary_tetrahedron(chosen, cell)) ++strict;
    }
    // Interior vertices have names here: an automorphism that keeps the boundary is the identity.
    const int interior = 6 - cell.vertices;
    const std::uint64_t names = interior == 2 ? 2 : 1;
    EXPECT_EQ(classes(name, interior).labelled * names, strict) << name;
    EXPECT_EQ(classes(name, interior, {true}).labelled * names, all) << name;
  }
}

TEST(SpheresCells, HexahedronOfTheLiterature) {
  const auto found = classes("hexahedron", 0);
  EXPECT_EQ(found.classes.size(), 174U);
  EXPECT_EQ(found.labelled, 6966U);
  std::map<std::size_t, std::size_t> histogram;
  for (const auto& entry : found.classes) ++histogram[entry.triangulation.tetrahedra.size()];
  EXPECT_EQ(histogram, (std::map<std::size_t, std::size_t>{{5, 1},
                                                           {6, 5},
                                                           {7, 5},
                                                           {8, 7},
                                                           {9, 13},
                                                           {10, 20},
                                                           {11, 35},
                                                           {12, 30},
                                                           {13, 28},
                                                           {14, 19},
                                                           {15, 11}}));
}

TEST(SpheresCells, NumbersOfOtherPrograms) {
  struct Known {
    const char* name;
    int interior;
    std::size_t classes;
  };
  for (const auto& [name, interior, count] : {Known{"tetrahedron", 0, 1},
                                              {"tetrahedron", 1, 1},
                                              {"tetrahedron", 2, 2},
                                              {"tetrahedron", 3, 12},
                                              {"pyramid", 0, 1},
                                              {"pyramid", 1, 4},
                                              {"prism", 0, 2},
                                              {"prism", 1, 32},
                                              {"octahedron", 0, 2},
                                              {"octahedron", 1, 10}})
    EXPECT_EQ(classes(name, interior).classes.size(), count) << name << " " << interior;
}

TEST(SpheresCells, EachClassIsATriangulationInLeastFormWithItsGroup) {
  support::Random random(9);
  for (const auto& [name, interior] :
       {std::pair{"hexahedron", 0}, {"prism", 1}, {"pyramid", 2}, {"octahedron", 1}}) {
    const Cell cell = *complex::cell_named(name);
    const auto allowed = boundaries(cell);
    const auto symmetries = complex::symmetries(cell);
    for (const auto& [triangulation, automorphisms] : classes(name, interior).classes) {
      const auto tetrahedra = support::tetrahedra_of(triangulation);
      EXPECT_TRUE(is_triangulation(tetrahedra, cell, cell.vertices + interior, allowed));
      EXPECT_FALSE(has_boundary_tetrahedron(tetrahedra, cell));
      std::uint64_t fixed = 0;
      for (auto map : symmetries)
        for (const bool exchange : {false, true}) {
          if (exchange && interior < 2) continue;
          const auto k = static_cast<std::size_t>(cell.vertices);
          if (exchange) std::swap(map[k], map[k + 1]);
          const auto image = complex::image_of(triangulation, map);
          EXPECT_GE(image, triangulation);
          if (image == triangulation) ++fixed;
        }
      EXPECT_EQ(fixed, automorphisms);
    }
  }
}

TEST(SpheresCells, TooFewVerticesAreRefused) {
  EXPECT_THROW((void)balls::triangulations_from(spheres(5), *complex::cell_named("pyramid")),
               core::PreconditionViolated);
}

}  // namespace
