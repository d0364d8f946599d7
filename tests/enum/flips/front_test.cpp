// Claim. may_glue() says yes exactly if the complex with the hexahedron glued on is a ball under
// the strict rule; push() and pop() undo each other exactly; the front holds the relation of the
// mesh. Oracle. The whole mesh: tests/oracles/hexahedra.hpp intersects all pairs of hexahedra;
// validate(); the relation computed from the hexahedra.
#include "enum/flips/front.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/core/errors.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using flips::Flip;
using flips::Front;
using flips::Shelling;
using oracle::Cell;

/// The hexahedron that stands on the patch: its quads that are consumed face the mesh.
Cell cell_of(const Shelling& shelling, const flips::Prism& prism) {
  Cell cell{};
  std::uint32_t fresh = static_cast<std::uint32_t>(shelling.vertices());
  for (std::size_t i = 0; i < 4; ++i) {
    // Corner (x, y, 0) or (x, y, 1): round the bottom, whose outside looks up here.
    constexpr std::array<unsigned, 4> kRound{0, 1, 3, 2};
    cell[kRound[i]] = shelling.vertex_of(prism.bottom[i]);
    cell[4 + kRound[i]] =
        prism.top[i] == flips::kNewVertex ? fresh++ : shelling.vertex_of(prism.top[i]);
  }
  return cell;
}

/// Whether the mesh with this hexahedron is a strict ball whose boundary has `quads` quads: with
/// more shared quads than the patch has it would be another gluing.
bool is_ball_with(std::vector<Cell> cells, const Cell& cell, std::size_t quads) {
  for (const Cell& other : cells)
    if (!oracle::meet_strictly(cell, other)) return false;
  cells.push_back(cell);
  return oracle::boundary(cells).size() == quads && !complex::validate(support::mesh_of(cells));
}

TEST(Front, GluesExactlyWhatGivesAStrictBall) {
  support::Random random(41);
  int yes = 0;
  int no = 0;
  for (int walk = 0; walk < support::share_of(24); ++walk) {
    Shelling shelling;
    // Small boundaries make crowded fronts, where much is forbidden.
    const int max_quads = walk % 3 == 0 ? 14 : walk % 3 == 1 ? 20 : 30;
    while (shelling.cells().size() < 25) {
      const auto cells = support::cells_of(shelling);
      const Front& front = shelling.front();
      auto candidates = support::candidate_flips(front.boundary, flips::kMaxFrontQuads);
      for (const Flip flip : candidates) {
        const auto prism = flips::prism_of(front.boundary, flip).value();
        const auto after =
            static_cast<std::size_t>(front.boundary.quads() + 6 - 2 * flip.consumed());
        const bool expected = is_ball_with(cells, cell_of(shelling, prism), after);
        ASSERT_EQ(flips::may_glue(front, flip, prism), expected);
        if (expected) {
          ASSERT_NE(flips::possible_sides(front, flip.bottom) >> flip.sides & 1U, 0U);
        }
        ++(expected ? yes : no);
      }
      candidates = support::candidate_flips(front.boundary, max_quads);
      random.shuffle(candidates);
      bool pushed = false;
      for (std::size_t i = 0; i < candidates.size() && !pushed; ++i)
        pushed = shelling.push(candidates[i]).has_value();
      if (!pushed) break;
    }
  }
  EXPECT_GT(yes, support::share_of(3'000));
  EXPECT_GT(no, support::share_of(3'000));
}

void expect_true_front(const Shelling& shelling) {
  const auto cells = support::cells_of(shelling);
  const Front& front = shelling.front();
  const int vertices = front.boundary.vertices();
  std::set<oracle::Cycle> quads;
  for (const auto& quad : front.boundary.list_of_quads())
    quads.insert(oracle::rotated({shelling.vertex_of(quad[0]), shelling.vertex_of(quad[1]),
                                  shelling.vertex_of(quad[2]), shelling.vertex_of(quad[3])}));
  EXPECT_EQ(quads, oracle::boundary(cells));
  for (int a = 0; a < vertices; ++a)
    for (int b = 0; b < vertices; ++b) {
      const auto u = shelling.vertex_of(static_cast<complex::Vertex>(a));
      const auto v = shelling.vertex_of(static_cast<complex::Vertex>(b));
      const bool related = std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
        return std::count(cell.begin(), cell.end(), u) + std::count(cell.begin(), cell.end(), v) ==
               2;
      });
      EXPECT_EQ((front.related[static_cast<std::size_t>(a)] &
                 flips::bit(static_cast<complex::Vertex>(b))) != 0,
                related);
    }
  EXPECT_TRUE(front.boundary.is_three_connected());
}

TEST(Front, HoldsBoundaryAndRelationOfTheMesh) {
  support::Random random(43);
  for (int i = 0; i < 40; ++i) {
    const auto shelling = random_shelling(1 + random.below(30), 40, random);
    expect_true_front(shelling);
    EXPECT_TRUE(oracle::is_shelling(support::cells_of(shelling)));
    EXPECT_FALSE(complex::validate(support::mesh_of(support::cells_of(shelling))));
  }
}

bool same_bytes(const Front& a, const Front& b) {
  return a.boundary == b.boundary && a.related == b.related;
}

TEST(Front, PushAndPopUndoEachOther) {
  support::Random random(47);
  Shelling shelling;
  std::vector<Front> fronts{shelling.front()};
  std::vector<std::vector<Shelling::Cell>> cells{shelling.cells()};
  for (int step = 0; step < 3'000; ++step) {
    if (random.below(5) < 2 && shelling.cells().size() > 1) {
      shelling.pop();
      fronts.pop_back();
      cells.pop_back();
    } else {
      const auto flips = support::candidate_flips(shelling.front().boundary, 40);
      if (!shelling.push(flips[random.below(flips.size())])) {
        ASSERT_TRUE(same_bytes(shelling.front(), fronts.back())) << "a refusal changed the front";
        continue;
      }
      fronts.push_back(shelling.front());
      cells.push_back(shelling.cells());
    }
    ASSERT_TRUE(same_bytes(shelling.front(), fronts.back()));
    ASSERT_EQ(shelling.cells(), cells.back());
  }
  while (shelling.cells().size() > 1) shelling.pop();
  EXPECT_TRUE(same_bytes(shelling.front(), flips::single_hexahedron()));
  EXPECT_THROW(shelling.pop(), core::PreconditionViolated);
}

TEST(Front, RefusesWhatIsNoFlip) {
  Shelling shelling;
  EXPECT_FALSE(shelling.push({6, 0}).has_value()) << "there is no seventh quad";
  EXPECT_FALSE(shelling.push({0, 15}).has_value()) << "five quads of six";
  EXPECT_FALSE(shelling.push({0, 1}).has_value()) << "two quads of one hexahedron";
  EXPECT_TRUE(shelling.push({0, 0}).has_value());
  EXPECT_EQ(shelling.vertices(), 12);
}

TEST(Front, EachGlueableHexahedronIsVisitedOnce) {
  support::Random random(53);
  for (int i = 0; i < 30; ++i) {
    const auto shelling = random_shelling(1 + random.below(20), 30, random);
    const Front& front = shelling.front();
    std::multiset<std::set<std::uint32_t>> visited;
    std::set<std::set<std::uint32_t>> expected;
    const auto vertex_set = [&](Flip flip, const flips::Prism& prism) {
      // The vertices that exist and the number of new ones identify the hexahedron with its patch.
      const Cell cell = cell_of(shelling, prism);
      std::set<std::uint32_t> result(cell.begin(), cell.end());
      result.insert(10'000 + static_cast<std::uint32_t>(flip.consumed()));
      if (flip.consumed() == 1)
        for (const auto v : prism.bottom) result.insert(20'000 + v);
      return result;
    };
    flips::for_each_glueable(front, 26, [&](Flip flip, const flips::Prism& prism) {
      visited.insert(vertex_set(flip, prism));
      EXPECT_TRUE(flips::may_glue(front, flip, prism));
    });
    for (const Flip flip : support::candidate_flips(front.boundary, 26)) {
      const auto prism = flips::prism_of(front.boundary, flip).value();
      if (flips::may_glue(front, flip, prism)) expected.insert(vertex_set(flip, prism));
    }
    EXPECT_EQ(std::set(visited.begin(), visited.end()), expected);
    EXPECT_EQ(visited.size(), expected.size());
  }
}

}  // namespace
