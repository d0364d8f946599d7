// Claim. Exactly the complexes of which each two hexahedra meet in a face of both, or not at all,
// obey the strict rule.
// Oracle. A look at each two hexahedra: the edges among their common vertices. Complexes are piles
// of cubes, and hexahedra on few vertices, with vertices identified or exchanged at random.
#include "tables/check/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "tests/share.hpp"
#include "tests/tables/check/example_meshes.hpp"

namespace hexatlas::check {
namespace {

using Cells = std::vector<Hexahedron>;

/// Whether two vertices are one step of the lattice apart in the unit cube that the hexahedron is.
bool is_edge(const Hexahedron& cell, std::uint32_t u, std::uint32_t v) {
  const auto corners = examples::corners_of({0, 0, 0});
  const auto at = [&](std::uint32_t w) {
    return corners[static_cast<std::size_t>(std::find(cell.begin(), cell.end(), w) - cell.begin())];
  };
  const auto [a, b, c] = at(u);
  const auto [x, y, z] = at(v);
  return std::abs(a - x) + std::abs(b - y) + std::abs(c - z) == 1;
}

/// Whether the common vertices are none, one, or an edge or a quad of both.
bool meet_in_a_face(const Hexahedron& a, const Hexahedron& b) {
  std::vector<std::uint32_t> common;
  std::copy_if(a.begin(), a.end(), std::back_inserter(common),
               [&](std::uint32_t v) { return std::find(b.begin(), b.end(), v) != b.end(); });
  std::size_t edges = 0;
  for (std::size_t i = 0; i < common.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (is_edge(a, common[i], common[j]) != is_edge(b, common[i], common[j])) return false;
      if (is_edge(a, common[i], common[j])) ++edges;
    }
  }
  return common.size() < 2 || (common.size() == 2 && edges == 1) ||
         (common.size() == 4 && edges == 4);
}

bool each_two_meet_in_a_face(const Cells& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!meet_in_a_face(cells[i], cells[j])) return false;
    }
  }
  return true;
}

/// Identifies two vertices, or exchanges two corners of a hexahedron.
void disturb(Cells& cells, std::uint32_t vertices, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  if (below(3) == 0) {
    Hexahedron& cell = cells[below(cells.size())];
    std::swap(cell[below(8)], cell[below(8)]);
    return;
  }
  const std::uint32_t goes = below(vertices), stays = below(vertices);
  for (Hexahedron& cell : cells) std::replace(cell.begin(), cell.end(), goes, stays);
}

/// Two to four hexahedra on few vertices.
Cells on_few_vertices(std::uint32_t vertices, std::mt19937_64& random) {
  Cells cells(2 + random() % 3);
  std::vector<std::uint32_t> all(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) all[v] = v;
  for (Hexahedron& cell : cells) {
    std::shuffle(all.begin(), all.end(), random);
    std::copy_n(all.begin(), cell.size(), cell.begin());
  }
  return cells;
}

TEST(StrictRule, IsThatEachTwoHexahedraMeetInAFace) {
  std::mt19937_64 random(20261125);
  const std::vector<Mesh> piles{examples::cubes(examples::box(2, 2, 2)).mesh,
                                examples::cubes(examples::box(3, 2, 1)).mesh,
                                examples::cube_in_cube().mesh};
  int yes = 0, no = 0;
  for (int round = 0; round < support::share_of(40'000); ++round) {
    const Mesh& pile = piles[random() % piles.size()];
    auto vertices = static_cast<std::uint32_t>(pile.points.size());
    Cells cells = pile.hexahedra;
    if (round % 4 == 0) {
      vertices = 16 + static_cast<std::uint32_t>(random() % 16);
      cells = on_few_vertices(vertices, random);
    }
    for (std::uint64_t times = random() % 3; times > 0; --times) disturb(cells, vertices, random);
    if (check_corners(cells, vertices)) continue;
    const Incidence incidence = incidence_of(cells, vertices);
    if (check_two_hexahedra(incidence)) continue;
    const bool expected = each_two_meet_in_a_face(cells);
    ++(expected ? yes : no);
    ASSERT_EQ(!check_strict_rule(incidence), expected) << round;
  }
  EXPECT_GT(yes, support::share_of(3'000));
  EXPECT_GT(no, support::share_of(3'000));
}

}  // namespace
}  // namespace hexatlas::check
