// Claim. validate() names each law that a hexahedral complex may break, decides the strict rule as
// the definition does, and boundary_of() gives the quads in exactly one hexahedron. Oracle.
// Complexes with one fault each; tests/oracles/hexahedra.hpp, which intersects all pairs of
// hexahedra as sets.
#include "enum/complex/hex_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "enum/complex/facets.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using complex::HexComplex;
using oracle::Cell;

std::string fault_of(const std::vector<Cell>& cells) {
  const auto law = complex::validate(support::mesh_of(cells));
  return law ? law->reason : "none";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Vertices renumbered as they appear.
std::vector<Cell> compact(std::vector<Cell> cells) {
  std::map<std::uint32_t, std::uint32_t> number;
  for (auto& cell : cells)
    for (auto& v : cell)
      v = number.try_emplace(v, static_cast<std::uint32_t>(number.size())).first->second;
  return cells;
}

/// The unit cubes of a box for which keep(x, y, z).
template <class Keep>
std::vector<Cell> part_of_grid(unsigned nx, unsigned ny, unsigned nz, const Keep& keep) {
  const auto box = oracle::grid(nx, ny, nz);
  std::vector<Cell> cells;
  for (unsigned z = 0; z < nz; ++z)
    for (unsigned y = 0; y < ny; ++y)
      for (unsigned x = 0; x < nx; ++x)
        if (keep(x, y, z)) cells.push_back(box[x + nx * (y + ny * z)]);
  return compact(cells);
}

const std::string kRule = "but no common edge or quad that does";
const Cell kFirst{0, 1, 2, 3, 4, 5, 6, 7};

TEST(HexComplex, BoxesAreValid) {
  for (const auto& cells : {oracle::grid(1, 1, 1), oracle::grid(2, 1, 1), oracle::grid(3, 2, 4)}) {
    EXPECT_EQ(fault_of(cells), "none");
    std::set<oracle::Cycle> quads;
    for (const auto& quad : complex::boundary_of(support::mesh_of(cells)))
      EXPECT_TRUE(quads.insert(oracle::rotated(quad)).second);
    EXPECT_EQ(quads, oracle::boundary(cells));
  }
}

TEST(HexComplex, NamesFaultsOfSingleCells) {
  EXPECT_EQ(fault_of({}), "there is no hexahedron");
  EXPECT_EQ(fault_of({{0, 1, 2, 3, 4, 5, 6, 0}}), "vertex 0 is repeated in a hexahedron");
  HexComplex mesh = support::mesh_of({kFirst});
  mesh.vertices = 9;
  EXPECT_EQ(complex::validate(mesh)->reason, "vertex 8 is in no hexahedron");
  mesh.vertices = 7;
  EXPECT_EQ(complex::validate(mesh)->reason, "vertex 7 does not exist");
  EXPECT_EQ(complex::validate(mesh)->cell, 0U);
}

TEST(HexComplex, NamesPairsThatBreakTheStrictRule) {
  // The second cube contains, besides new vertices:
  const std::map<std::string, Cell> second{
      {"two quads of the first", {0, 1, 2, 3, 4, 5, 8, 9}},
      {"a facet diagonal only", {0, 8, 9, 3, 10, 11, 12, 13}},
      {"a facet diagonal as an edge", {0, 3, 8, 9, 10, 11, 12, 13}},
      {"an edge as a facet diagonal", {0, 8, 9, 1, 10, 11, 12, 13}},
      {"a body diagonal only", {0, 8, 9, 10, 11, 12, 13, 7}},
      {"an edge as a body diagonal", {0, 8, 9, 10, 11, 12, 13, 1}},
      {"a quad in another cyclic order", {0, 1, 3, 2, 8, 9, 10, 11}},
      {"two opposite quads", {0, 1, 2, 3, 4, 5, 6, 7}},
      {"three vertices of a quad", {0, 1, 2, 8, 9, 10, 11, 12}},
      {"an edge and another vertex", {0, 1, 8, 9, 10, 11, 12, 6}}};
  for (const auto& [what, cell] : second) {
    EXPECT_FALSE(oracle::meet_strictly(kFirst, cell)) << what;
    const std::string fault = fault_of(compact({kFirst, cell}));
    EXPECT_TRUE(has(fault, kRule)) << what << ": " << fault;
    EXPECT_TRUE(fault.starts_with("hexahedra 0 and 1 both") ||
                fault.starts_with("hexahedra 1 and 0 both"));
  }
}

TEST(HexComplex, NamesQuadsInThreeHexahedra) {
  // Two cubes on one side of the quad 4-5-7-6, meeting in that quad alone.
  const Cell above{4, 5, 6, 7, 8, 9, 10, 11};
  const Cell again{4, 5, 6, 7, 12, 13, 14, 15};
  const std::string fault = fault_of({kFirst, above, again});
  EXPECT_EQ(fault, "quad 4-5-6-7 is in 3 hexahedra");
}

TEST(HexComplex, NamesOrientations) {
  Cell above{4, 5, 6, 7, 8, 9, 10, 11};
  std::swap(above[1], above[2]);
  std::swap(above[5], above[6]);
  EXPECT_EQ(fault_of({kFirst, above}), "hexahedra 0 and 1 are oriented differently");
}

TEST(HexComplex, NamesPinchesAndComponents) {
  EXPECT_TRUE(has(fault_of(compact({kFirst, {7, 8, 9, 10, 11, 12, 13, 14}})), "is not connected"));
  EXPECT_TRUE(
      has(fault_of(compact({kFirst, {5, 8, 9, 10, 7, 11, 12, 13}})), "is pinched at vertex"));
  EXPECT_EQ(fault_of(compact({kFirst, {8, 9, 10, 11, 12, 13, 14, 15}})),
            "the complex has 2 components");
}

TEST(HexComplex, NamesShellsAndTori) {
  const auto hollow =
      part_of_grid(3, 3, 3, [](auto x, auto y, auto z) { return x != 1 || y != 1 || z != 1; });
  EXPECT_EQ(fault_of(hollow), "the boundary has 2 components");
  const auto torus = part_of_grid(3, 3, 1, [](auto x, auto y, auto) { return x != 1 || y != 1; });
  EXPECT_EQ(fault_of(torus), "the Euler characteristic of the boundary is 0, a sphere has 2");
  EXPECT_FALSE(complex::shelling_of(support::mesh_of(torus)).has_value());
  EXPECT_FALSE(complex::shelling_of(support::mesh_of(hollow)).has_value());
}

TEST(HexComplex, AClosedOneHasNoBoundary) {
  // The boundary of the 4-cube: 8 hexahedra, a 3-sphere.
  std::vector<Cell> cells;
  for (unsigned axis = 0; axis < 4; ++axis)
    for (unsigned side = 0; side < 2; ++side) {
      Cell cell{};
      std::array<unsigned, 3> other{};
      for (unsigned k = 0, i = 0; k < 4; ++k)
        if (k != axis) other[i++] = 1U << k;
      if ((axis + side) % 2 == 1) std::swap(other[0], other[1]);  // orients them alike
      for (unsigned v = 0; v < 8; ++v) {
        cell[v] = side << axis;
        for (unsigned k = 0; k < 3; ++k)
          if ((v >> k & 1U) != 0) cell[v] += other[k];
      }
      cells.push_back(cell);
    }
  EXPECT_TRUE(oracle::obeys_strict_rule(cells));
  EXPECT_EQ(fault_of(cells), "there is no boundary");
}

TEST(HexComplex, StrictRuleAsByIntersections) {
  // Random hexahedra on few vertices, most of them glued on a quad of a former one.
  support::Random random(17);
  int strict = 0;
  int broken = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::vector<Cell> cells{kFirst};
    std::uint32_t vertices = 8;
    const std::size_t wanted = 2 + random.below(4);
    while (cells.size() < wanted) {
      const auto quads = oracle::outer_quads(cells[random.below(cells.size())]);
      const auto quad = quads[random.below(6)];
      Cell cell{quad[0], quad[1], quad[3], quad[2], 0, 0, 0, 0};
      for (std::size_t v = 4; v < 8; ++v)
        cell[v] =
            random.below(3) == 0 ? static_cast<std::uint32_t>(random.below(vertices)) : vertices++;
      if (oracle::is_simple(cell)) cells.push_back(cell);
    }
    const bool expected = oracle::obeys_strict_rule(cells);
    const std::string fault = fault_of(compact(cells));
    const bool said = !has(fault, kRule) && !(fault.starts_with("quad ") && has(fault, " is in "));
    EXPECT_EQ(said, expected) << fault;
    ++(expected ? strict : broken);
  }
  EXPECT_GT(strict, 2'000);
  EXPECT_GT(broken, 2'000);
}

TEST(HexComplex, VerdictDoesNotDependOnLabels) {
  support::Random random(19);
  for (int i = 0; i < 50; ++i) {
    const auto cells = support::cells_of(support::random_shelling(15, 40, random));
    for (const bool mirrored : {false, true})
      EXPECT_FALSE(
          complex::validate(support::scrambled(support::mesh_of(cells), random, mirrored)));
    auto damaged = cells;
    damaged[random.below(cells.size())][random.below(8)] = cells[0][random.below(8)];
    if (oracle::obeys_strict_rule(damaged)) continue;
    EXPECT_TRUE(complex::validate(support::scrambled(support::mesh_of(damaged), random, false)));
  }
}

TEST(HexComplex, FacetsAreSortedAndOppositeCyclesRecognized) {
  const auto facets = complex::sorted_facets(support::mesh_of(oracle::grid(2, 1, 1)));
  ASSERT_EQ(facets.size(), 12U);
  EXPECT_TRUE(std::is_sorted(facets.begin(), facets.end(), [](const auto& a, const auto& b) {
    return std::pair(a.key, a.cell) < std::pair(b.key, b.cell);
  }));
  EXPECT_TRUE(complex::are_opposite({0, 1, 2, 3}, {1, 0, 3, 2}));
  EXPECT_TRUE(complex::are_opposite({0, 1, 2, 3}, {3, 2, 1, 0}));
  EXPECT_FALSE(complex::are_opposite({0, 1, 2, 3}, {1, 2, 3, 0}));
  EXPECT_FALSE(complex::are_opposite({0, 1, 2, 3}, {4, 2, 1, 0}));
  EXPECT_FALSE(complex::are_opposite({0, 1, 2, 3}, {2, 0, 3, 1}));
}

std::vector<Cell> replayed(const std::vector<Cell>& cells, std::vector<std::uint32_t> order) {
  std::reverse(order.begin(), order.end());  // taken off first, put on last
  std::vector<Cell> result;
  for (const std::uint32_t c : order) result.push_back(cells[c]);
  return result;
}

TEST(Shelling, IsFoundForBoxesAndForRandomShellings) {
  support::Random random(23);
  std::vector<std::vector<Cell>> meshes{oracle::grid(1, 1, 1), oracle::grid(2, 2, 2),
                                        oracle::grid(4, 3, 2)};
  for (int i = 0; i < 40; ++i) {
    const auto shelling = random_shelling(2 + random.below(25), 40, random);
    const auto mesh =
        support::scrambled(support::mesh_of(support::cells_of(shelling)), random, false);
    meshes.emplace_back(mesh.hexahedra.begin(), mesh.hexahedra.end());
  }
  for (const auto& cells : meshes) {
    const auto order = complex::shelling_of(support::mesh_of(cells));
    ASSERT_TRUE(order.has_value());
    std::set<std::uint32_t> all(order->begin(), order->end());
    ASSERT_EQ(all.size(), cells.size());
    EXPECT_TRUE(oracle::is_shelling(replayed(cells, *order)));
  }
  EXPECT_FALSE(complex::shelling_of(HexComplex{}).has_value());
}

}  // namespace
