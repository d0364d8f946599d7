// Claim. The named boundaries are the surfaces that their descriptions say, and where the
// literature needs so few hexahedra that a mesh can be written down here, it has that many. Oracle.
// Surfaces and meshes made here from coordinates; the strict rule by sets.
#include "tables/build/named.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using Cells = std::vector<oracle::Cell>;
/// Quads of a planar mesh, counter-clockwise.
using Planar = std::vector<std::array<std::uint32_t, 4>>;

canon::Code code_of(const oracle::QuadList& quads) {
  return canon::canonical_form(complex::Quadrangulation::from_quads(quads).value()).code;
}
std::uint8_t id(std::size_t v) { return static_cast<std::uint8_t>(v); }

/// The boundary, its vertices numbered anew; the mesh must obey the strict rule.
canon::Code code_of_mesh(const Cells& cells) {
  for (std::size_t a = 0; a < cells.size(); ++a) {
    EXPECT_TRUE(oracle::is_simple(cells[a]));
    for (std::size_t b = 0; b < a; ++b) EXPECT_TRUE(oracle::meet_strictly(cells[a], cells[b]));
  }
  std::map<std::uint32_t, std::size_t> number;
  oracle::QuadList quads;
  for (const auto& quad : oracle::boundary(cells)) {
    oracle::QuadList::value_type renamed{};
    for (std::size_t i = 0; i < 4; ++i)
      renamed[i] = id(number.emplace(quad[i], number.size()).first->second);
    quads.push_back(renamed);
  }
  return code_of(quads);
}

/// k quads around each of two poles.
oracle::QuadList trapezohedron(unsigned k) {
  oracle::QuadList quads;
  const auto belt = [&](unsigned i) { return id(2 + i % (2 * k)); };
  for (unsigned i = 0; i < k; ++i) {
    quads.push_back({0, belt(2 * i), belt(2 * i + 1), belt(2 * i + 2)});
    quads.push_back({1, belt(2 * i + 3), belt(2 * i + 2), belt(2 * i + 1)});
  }
  return quads;
}

/// A square pyramid: base corners, base mid-edges, base centre, mid-edges to the apex, centres of
/// sides.
oracle::QuadList pyramid() {
  oracle::QuadList quads;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = (i + 1) % 4, h = (i + 3) % 4;
    const auto corner = [](unsigned k) { return id(k); };
    const auto base = [](unsigned k) { return id(4 + k); };     // between corners k and k + 1
    const auto lateral = [](unsigned k) { return id(8 + k); };  // between corner k and the apex
    const auto side = [](unsigned k) { return id(12 + k); };
    const auto centre = id(16), apex = id(17);
    quads.push_back({corner(i), base(h), centre, base(i)});
    quads.push_back({corner(i), base(i), side(i), lateral(i)});
    quads.push_back({base(i), corner(j), lateral(j), side(i)});
    quads.push_back({side(i), lateral(j), apex, lateral(i)});
  }
  return quads;
}

/// Edges of the cube as rhombi: cube vertices 0 .. 7, the points above its facets 8 .. 13.
oracle::QuadList rhombic_dodecahedron() {
  oracle::QuadList quads;
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned v = 0; v < 8; ++v) {
      if ((v >> axis & 1U) != 0) continue;
      const unsigned y = (axis + 1) % 3, z = (axis + 2) % 3;
      const unsigned a = 8 + 2 * y + (v >> y & 1U), b = 8 + 2 * z + (v >> z & 1U);
      const bool turned = ((v >> y ^ v >> z) & 1U) != 0;
      oracle::QuadList::value_type quad{id(v), id(a), id(v | 1U << axis), id(b)};
      if (turned) std::swap(quad[1], quad[3]);
      quads.push_back(quad);
    }
  return quads;
}

/// `layers` layers above a planar mesh with fewer than 100 vertices.
Cells extruded(const Planar& planar, unsigned layers) {
  Cells cells;
  for (unsigned layer = 0; layer < layers; ++layer)
    for (const auto& [a, b, c, d] : planar) {
      const std::uint32_t low = 100 * layer, high = low + 100;
      cells.push_back({low + a, low + b, low + d, low + c, high + a, high + b, high + d, high + c});
    }
  return cells;
}

/// A triangle 0 1 2 cut into three quads by mid-edges 3 4 5 and its centre 6.
const Planar kDicedTriangle{{0, 3, 6, 5}, {1, 4, 6, 3}, {2, 5, 6, 4}};
/// A square 0 1 2 3 of which corner 0 is cut off: points 4 and 5 beside it on its edges, 6 inside.
const Planar kCornerOfSquare{{0, 4, 6, 5}, {4, 1, 2, 6}, {6, 2, 3, 5}};
/// A square 0 1 2 3 whose edge 0 1 has the points 4 and 5, above which are 6 and 7.
const Planar kEdgeOfSquare{{0, 4, 6, 3}, {4, 5, 7, 6}, {5, 1, 2, 7}, {6, 7, 2, 3}};

/// One hexahedron around each corner of a tetrahedron: vertices, edges, triangles and itself by the
/// sets of corners.
Cells diced_tetrahedron() {
  Cells cells;
  for (unsigned v = 0; v < 4; ++v) {
    std::vector<std::uint32_t> others;
    for (unsigned w = 0; w < 4; ++w)
      if (w != v) others.push_back(w);
    if (v % 2 == 1) std::swap(others[0], others[1]);  // right-handed
    oracle::Cell cell{};
    for (unsigned bits = 0; bits < 8; ++bits) {
      cell[bits] = 1U << v;
      for (unsigned axis = 0; axis < 3; ++axis)
        if ((bits >> axis & 1U) != 0) cell[bits] |= 1U << others[axis];
    }
    cells.push_back(cell);
  }
  return cells;
}

TEST(Named, BoundariesAreTheSurfacesDescribed) {
  const std::map<std::string, canon::Code> expected{
      {"cube", code_of(trapezohedron(3))},
      {"diced-prism", code_of_mesh(extruded(kDicedTriangle, 2))},
      {"octagonal-spindle", code_of(trapezohedron(4))},
      {"rhombic-dodecahedron", code_of(rhombic_dodecahedron())},
      {"schneiders-pyramid", code_of(pyramid())},
      {"subdivided-cube", code_of_mesh(oracle::grid(2, 2, 2))},
      {"three-around-an-edge", code_of_mesh(extruded(kDicedTriangle, 1))},
      {"three-to-one", code_of_mesh(extruded(kEdgeOfSquare, 1))},
      {"two-cubes", code_of_mesh(oracle::grid(2, 1, 1))}};
  std::map<std::string, canon::Code> named;
  for (const auto& boundary : build::kNamedBoundaries)
    named[std::string(boundary.name)] = canon::from_text(boundary.code).value();
  EXPECT_EQ(named, expected);
}

TEST(Named, OthersHaveTheSameBoundary) {
  const auto code = [](const std::string& name) {
    return canon::from_text(build::named_boundary(name)->code).value();
  };
  EXPECT_EQ(code_of_mesh(diced_tetrahedron()), code("rhombic-dodecahedron"));
  EXPECT_EQ(code_of_mesh(extruded(kCornerOfSquare, 1)), code("three-around-an-edge"));
}

TEST(Named, MeshesWrittenDownHaveTheNumbersOfTheLiterature) {
  const std::map<std::string, std::size_t> written{
      {"cube", 1},
      {"diced-prism", extruded(kDicedTriangle, 2).size()},
      {"rhombic-dodecahedron", diced_tetrahedron().size()},
      {"subdivided-cube", oracle::grid(2, 2, 2).size()},
      {"three-around-an-edge", extruded(kCornerOfSquare, 1).size()},
      {"three-to-one", extruded(kEdgeOfSquare, 1).size()},
      {"two-cubes", oracle::grid(2, 1, 1).size()}};
  for (const auto& [name, hexahedra] : written)
    EXPECT_EQ(static_cast<std::size_t>(build::named_boundary(name)->literature), hexahedra) << name;
}

TEST(Named, AreInOrderAndFit) {
  const auto& named = build::kNamedBoundaries;
  EXPECT_TRUE(std::is_sorted(named.begin(), named.end(),
                             [](const auto& a, const auto& b) { return a.name < b.name; }));
  for (const auto& boundary : named) {
    EXPECT_LE(canon::from_text(boundary.code).value().quads, 24);
    EXPECT_FALSE(boundary.description.empty());
    EXPECT_FALSE(boundary.source.empty());
    EXPECT_GT(boundary.literature, 0);
    EXPECT_EQ(build::named_boundary(boundary.name), &boundary);
  }
  EXPECT_EQ(build::named_boundary("nobody"), nullptr);
}

}  // namespace
