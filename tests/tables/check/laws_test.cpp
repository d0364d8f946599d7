// Claim. Exactly the complexes of which each two hexahedra meet in a face of both, or not at all,
// obey the strict rule.
// Oracle. A look at each two hexahedra, by sets. Complexes are piles of cubes, and hexahedra on few
// vertices, with vertices identified or exchanged at random.
#include "tables/check/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/oracles/hexahedra.hpp"
#include "tests/share.hpp"
#include "tests/tables/check/example_meshes.hpp"

namespace hexatlas::check {
namespace {

using Cells = std::vector<Hexahedron>;

bool each_two_meet_in_a_face(const Cells& cells) {
  std::vector<oracle::Cell> in_bits_order;
  for (const Hexahedron& h : cells)
    in_bits_order.push_back({h[0], h[1], h[3], h[2], h[4], h[5], h[7], h[6]});
  return oracle::obeys_strict_rule(in_bits_order);
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
