// Claim. The named cells are spheres, counter-clockwise from outside, with the groups and diagonals
// that they should have; damaged surfaces are refused with a reason. Oracle. Coordinates of the
// solids; all permutations of the vertices tried one by one.
#include "enum/complex/cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace hexatlas::complex;
using Point = std::array<double, 3>;

const std::map<std::string, std::vector<Point>>& solids() {
  static const std::map<std::string, std::vector<Point>> points{
      {"tetrahedron", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {"pyramid", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
      {"prism", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
      {"octahedron", {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}},
      {"hexahedron",
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}}};
  return points;
}

double determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    m[0][i] = b[i] - a[i];
    m[1][i] = c[i] - a[i];
    m[2][i] = d[i] - a[i];
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(Cell, FacetsAreCounterClockwiseFromOutside) {
  for (const auto name : cell_names()) {
    SCOPED_TRACE(std::string(name));
    const Cell cell = *cell_named(name);
    const auto& points = solids().at(std::string(name));
    ASSERT_EQ(points.size(), static_cast<std::size_t>(cell.vertices));
    Point inside{};
    for (const Point& p : points)
      for (std::size_t i = 0; i < 3; ++i) inside[i] += p[i] / static_cast<double>(points.size());
    for (const CellFacet& facet : cell.facets)
      EXPECT_LT(determinant(points[facet.vertex[0]], points[facet.vertex[1]],
                            points[facet.vertex[2]], inside),
                0);
  }
}

TEST(Cell, NamedCellsPassTheirOwnLaws) {
  for (const auto name : cell_names()) {
    const Cell cell = *cell_named(name);
    const auto again = cell_of(cell.facets, cell.vertices);
    ASSERT_TRUE(std::holds_alternative<Cell>(again)) << std::get<BrokenLaw>(again).reason;
    EXPECT_EQ(std::get<Cell>(again).facets, cell.facets);
  }
  EXPECT_FALSE(cell_named("dodecahedron"));
}

/// A facet as the set of its edges, so that order and orientation do not count.
std::set<VertexSet> edges(const CellFacet& facet, const VertexMap& map) {
  std::set<VertexSet> result;
  for (std::size_t i = 0; i < facet.size; ++i)
    result.insert(static_cast<VertexSet>(bit_of(map[facet.vertex[i]]) |
                                         bit_of(map[facet.vertex[(i + 1) % facet.size]])));
  return result;
}

TEST(Cell, SymmetriesAreAllPermutationsThatKeepTheFacets) {
  const std::map<std::string, std::size_t> orders{
      {"tetrahedron", 24}, {"pyramid", 8}, {"prism", 12}, {"octahedron", 48}, {"hexahedron", 48}};
  for (const auto& [name, order] : orders) {
    SCOPED_TRACE(name);
    const Cell cell = *cell_named(name);
    VertexMap map{};
    std::iota(map.begin(), map.end(), std::uint8_t{0});
    std::set<std::set<VertexSet>> facets;
    for (const CellFacet& facet : cell.facets) facets.insert(edges(facet, map));
    std::vector<VertexMap> all;
    do {
      std::set<std::set<VertexSet>> image;
      for (const CellFacet& facet : cell.facets) image.insert(edges(facet, map));
      if (image == facets) all.push_back(map);
    } while (std::next_permutation(map.begin(), map.begin() + cell.vertices));
    EXPECT_EQ(all.size(), order);
    EXPECT_EQ(symmetries(cell), all);
  }
}

TEST(Cell, CutSurfacesAreSimplicialSpheres) {
  const std::map<std::string, std::size_t> number{
      {"tetrahedron", 1}, {"pyramid", 2}, {"prism", 8}, {"octahedron", 1}, {"hexahedron", 64}};
  for (const auto& [name, expected] : number) {
    const Cell cell = *cell_named(name);
    const auto surfaces = cut_surfaces(cell);
    EXPECT_EQ(surfaces.size(), expected) << name;
    std::set<std::set<std::set<int>>> different;
    for (const CutSurface& surface : surfaces) {
      std::map<std::pair<int, int>, int> directed;
      std::set<std::set<int>> triangles;
      for (const OrientedTriangle& t : surface.triangles) {
        triangles.insert({t[0], t[1], t[2]});
        for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
      }
      different.insert(triangles);
      EXPECT_EQ(directed.size(), static_cast<std::size_t>(6 * cell.vertices - 12));
      for (const auto& [edge, count] : directed) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(directed.contains({edge.second, edge.first}));
      }
    }
    EXPECT_EQ(different.size(), expected) << "different choices give different surfaces";
  }
}

CellFacet facet(std::vector<int> vertices) {
  CellFacet result;
  result.size = static_cast<std::uint8_t>(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    result.vertex[i] = static_cast<std::uint8_t>(vertices[i]);
  return result;
}

std::string reason(const std::vector<CellFacet>& facets, int vertices) {
  const auto answer = cell_of(facets, vertices);
  return std::holds_alternative<Cell>(answer) ? "" : std::get<BrokenLaw>(answer).reason;
}

TEST(Cell, TurnedFacetsAreTurnedBack) {
  Cell cube = *cell_named("hexahedron");
  const Cell whole = cube;
  for (const std::size_t f : {1U, 3U, 4U})
    std::swap(cube.facets[f].vertex[1], cube.facets[f].vertex[3]);
  const auto answer = cell_of(cube.facets, 8);
  ASSERT_TRUE(std::holds_alternative<Cell>(answer));
  EXPECT_EQ(std::get<Cell>(answer).facets, whole.facets);
}

TEST(Cell, WhatIsNoSphereIsRefused) {
  const std::vector<CellFacet> cube = cell_named("hexahedron")->facets;
  std::vector<CellFacet> damaged = cube;
  damaged.pop_back();
  EXPECT_NE(reason(damaged, 8).find("lies on 1 facet"), std::string::npos) << reason(damaged, 8);
  damaged = cube;
  damaged.push_back(cube[0]);
  EXPECT_NE(reason(damaged, 8).find("vertices of an earlier"), std::string::npos);
  damaged = cube;
  damaged[0].vertex[1] = damaged[0].vertex[0];
  EXPECT_NE(reason(damaged, 8).find("vertex twice"), std::string::npos);
  EXPECT_NE(reason(cube, 9).find("lies on no facet"), std::string::npos);
  EXPECT_NE(reason(cube, 7).find("out of range"), std::string::npos);
  EXPECT_NE(reason(cube, 13).find("at most"), std::string::npos);
  // Two tetrahedra at a vertex.
  EXPECT_NE(reason({facet({0, 2, 1}), facet({0, 1, 3}), facet({1, 2, 3}), facet({0, 3, 2}),
                    facet({0, 5, 4}), facet({0, 4, 6}), facet({4, 5, 6}), facet({0, 6, 5})},
                   7),
            "");
  // A 3 x 3 torus of quads.
  std::vector<CellFacet> torus;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      torus.push_back(facet({3 * i + j, 3 * ((i + 1) % 3) + j, 3 * ((i + 1) % 3) + (j + 1) % 3,
                             3 * i + (j + 1) % 3}));
  EXPECT_NE(reason(torus, 9).find("Euler"), std::string::npos) << reason(torus, 9);
  // The projective plane of six vertices.
  EXPECT_NE(reason({facet({0, 1, 2}), facet({0, 2, 3}), facet({0, 3, 4}), facet({0, 4, 5}),
                    facet({0, 5, 1}), facet({1, 2, 4}), facet({2, 3, 5}), facet({3, 4, 1}),
                    facet({4, 5, 2}), facet({5, 1, 3})},
                   6)
                .find("orientable"),
            std::string::npos);
}

}  // namespace
