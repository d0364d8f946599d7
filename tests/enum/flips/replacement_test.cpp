// Claim. A ball of hexahedra inside a mesh may be exchanged for another ball with the same boundary
// exactly where no scar of that ball is a scar of the rest; what exchange finds has fewer
// hexahedra and the same boundary; a ball added to a beam is known there with all its parts.
// Oracle. The strict rule and the boundary by sets, on the whole mesh.
#include "enum/flips/replacement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using complex::Vertex;
using flips::Beam;
using flips::SubBall;
using support::cells_of;
using support::grown;

/// The boundary without its orientation: exchanged() does not turn left-handed hexahedra.
std::set<std::set<std::uint32_t>> boundary_sets(const std::vector<oracle::Cell>& cells) {
  std::set<std::set<std::uint32_t>> result;
  for (const auto& quad : oracle::boundary(cells)) result.emplace(quad.begin(), quad.end());
  return result;
}

/// The mesh with a ball of a beam in place of the sub-ball, as sets need it.
std::vector<oracle::Cell> exchanged(const complex::HexComplex& mesh, const SubBall& ball,
                                    const Beam& balls, flips::FrontId id,
                                    const canon::Labelling& label) {
  const auto layers = flips::layers_along(balls, id, flips::Growth::outward);
  std::vector<std::uint32_t> number(layers.vertices);
  for (std::uint32_t v = 0; v < layers.vertices; ++v) number[v] = mesh.vertices + v;
  for (int v = 0; v < ball.front().boundary.vertices(); ++v)
    number[layers.rim[label[static_cast<std::size_t>(v)]]] = ball.rim(static_cast<Vertex>(v));
  std::vector<oracle::Cell> cells;
  for (std::uint32_t c = 0; c < mesh.hexahedra.size(); ++c)
    if (!ball.contains(c)) cells.push_back(mesh.hexahedra[c]);
  for (oracle::Cell cell : layers.hexahedra) {
    for (auto& v : cell) v = number[v];
    cells.push_back(cell);
  }
  return cells;
}

flips::Scars scars_outside(const SubBall& ball, const canon::Labelling& label) {
  const auto outside = ball.related_outside();
  const auto quads = flips::relation_of_quads(ball.front().boundary);
  flips::Scars scars;
  for (int a = 0; a < ball.front().boundary.vertices(); ++a)
    for (int b = 0; b < a; ++b)
      if ((outside[static_cast<std::size_t>(a)] & ~quads[static_cast<std::size_t>(a)] &
           flips::bit(static_cast<Vertex>(b))) != 0)
        scars.add(label[static_cast<std::size_t>(a)], label[static_cast<std::size_t>(b)]);
  return scars;
}

TEST(Exchange, IsAllowedExactlyWhereScarsAreDisjoint) {
  const Beam beam = grown(18, 30, 3'000, 26);
  std::mt19937_64 random(1);
  int allowed = 0, refused = 0;
  const auto codes = beam.codes();
  for (int trial = 0; trial < support::share_of(150); ++trial) {
    const auto records = beam.fronts_of(codes[random() % codes.size()]);
    const auto mesh = flips::filling_of(beam, records[random() % records.size()].id).mesh;
    const auto neighbours = SubBall::neighbours_of(mesh);
    const auto size = static_cast<std::uint32_t>(mesh.hexahedra.size());
    SubBall ball(mesh, neighbours, static_cast<std::uint32_t>(random() % size));
    for (int attempt = 0; attempt < 60; ++attempt) {
      if (!ball.grow(static_cast<std::uint32_t>(random() % size))) continue;
      canon::CanonicalFlags flags;
      canon::canonical_flags(ball.front().boundary, flags);
      const auto known = beam.fronts_of(flags.code);
      if (known.empty()) continue;
      const auto flag = flags.flags[random() % static_cast<std::size_t>(flags.count)];
      const auto label = canon::labelling_from(ball.front().boundary, flag);
      const auto& candidate = known[random() % known.size()];
      const bool expected = candidate.scars.is_disjoint_from(scars_outside(ball, label));
      const auto cells = exchanged(mesh, ball, beam, candidate.id, label);
      // Sets take two edges with the same ends for one; then Euler's count is wrong.
      const bool is_strict_ball =
          oracle::obeys_strict_rule(cells) && oracle::euler_characteristic(cells) == 1;
      ASSERT_EQ(is_strict_ball, expected);
      if (expected) {
        ASSERT_EQ(boundary_sets(cells), boundary_sets(cells_of(mesh)));
      }
      ++(expected ? allowed : refused);
    }
  }
  EXPECT_GT(allowed, support::share_of(100));
  EXPECT_GT(refused, support::share_of(100));
}

/// The boundary and the related pairs of its vertices, by sets.
void expect_front(const SubBall& ball, const std::vector<oracle::Cell>& cells) {
  const flips::Front& front = ball.front();
  const auto quads = oracle::boundary(cells);
  ASSERT_EQ(ball.quads(), static_cast<int>(quads.size()));
  ASSERT_EQ(front.boundary.quads(), ball.quads());
  ASSERT_FALSE(front.boundary.validate());
  std::set<std::set<std::uint32_t>> expected, own;
  for (const auto& quad : quads) expected.emplace(quad.begin(), quad.end());
  for (const auto& quad : front.boundary.list_of_quads())
    own.insert({ball.rim(quad[0]), ball.rim(quad[1]), ball.rim(quad[2]), ball.rim(quad[3])});
  EXPECT_EQ(own, expected);
  for (int v = 0; v < front.boundary.vertices(); ++v)
    for (int w = 0; w < front.boundary.vertices(); ++w) {
      const auto a = ball.rim(static_cast<complex::Vertex>(v));
      const auto b = ball.rim(static_cast<complex::Vertex>(w));
      const bool is_related = std::any_of(cells.begin(), cells.end(), [&](const auto& cell) {
        return std::count(cell.begin(), cell.end(), a) + std::count(cell.begin(), cell.end(), b) >=
               2;
      });
      const bool knows = (front.related[static_cast<std::size_t>(v)] >> w & 1U) != 0;
      EXPECT_EQ(knows, is_related);
    }
}

TEST(SubBall, GrowsExactlyWhereTheUnionIsAStrictBall) {
  // In a strict mesh a union that is a ball obeys the rule; it is one if it has a shelling.
  const Beam beam = grown(16, 10, 500, 14);
  std::mt19937_64 random(2);
  std::size_t grew = 0, refused = 0;
  for (const auto& code : beam.codes()) {
    const auto mesh = flips::filling_of(beam, beam.fronts_of(code).back().id).mesh;
    const auto neighbours = SubBall::neighbours_of(mesh);
    const auto size = static_cast<std::uint32_t>(mesh.hexahedra.size());
    SubBall ball(mesh, neighbours, static_cast<std::uint32_t>(random() % size));
    for (int attempt = 0; attempt < 40; ++attempt) {
      const auto cell = static_cast<std::uint32_t>(random() % size);
      if (ball.contains(cell)) {
        EXPECT_FALSE(ball.grow(cell));
        continue;
      }
      std::vector<oracle::Cell> cells;
      for (const auto inside : ball.cells()) cells.push_back(mesh.hexahedra[inside]);
      cells.push_back(mesh.hexahedra[cell]);
      const bool expected = oracle::is_shelling(cells);
      ASSERT_EQ(ball.grow(cell), expected);
      ++(expected ? grew : refused);
      if (!expected) cells.pop_back();
      if (random() % 4 == 0) expect_front(ball, cells);
    }
  }
  EXPECT_GT(grew, 50U);
  EXPECT_GT(refused, 50U);
}

TEST(SubBall, HasABoundaryAsWideAsItMay) {
  const Beam beam = grown(flips::kMaxStateQuads, 1, 30, 14);
  core::Random random(3);
  std::map<int, int> widest;  // for each limit
  for (const auto& code : beam.codes()) {
    if (code.quads < flips::kMaxStateQuads) continue;
    const auto mesh = flips::filling_of(beam, beam.fronts_of(code).back().id).mesh;
    const auto neighbours = SubBall::neighbours_of(mesh);
    for (const int limit : {20, flips::kMaxStateQuads}) {
      SubBall ball(mesh, neighbours, 0, limit);
      while (ball.grow_somewhere(random)) widest[limit] = std::max(widest[limit], ball.quads());
      std::vector<oracle::Cell> cells;
      for (const auto inside : ball.cells()) cells.push_back(mesh.hexahedra[inside]);
      expect_front(ball, cells);
    }
  }
  EXPECT_EQ(widest, (std::map<int, int>{{20, 20}, {flips::kMaxStateQuads, flips::kMaxStateQuads}}));
}

TEST(SubBall, HasABoundaryWithFewQuads) {
  const auto mesh = flips::filling_of(grown(6, 1, 1, 0), {}).mesh;
  const auto neighbours = SubBall::neighbours_of(mesh);
  EXPECT_THROW((void)SubBall(mesh, neighbours, 0, flips::kMaxStateQuads + 1),
               core::PreconditionViolated);
}

TEST(Replacement, MakesMeshesSmallerAndKeepsTheirBoundary) {
  const Beam beam = grown(20, 30, 2'000, 34);
  std::size_t reduced = 0;
  for (const auto& code : beam.codes()) {
    const auto records = beam.fronts_of(code);
    if (records.back().level == records.front().level || code.quads > 16) continue;
    // The whole mesh is a ball as well, so a smaller one is always at hand.
    const auto mesh = flips::filling_of(beam, records.back().id).mesh;
    const flips::ReplacementOptions options{.growths = 20, .seed = 7};
    const auto smaller = flips::smaller_by_replacement(mesh, code.quads, beam, options);
    ASSERT_TRUE(smaller) << canon::to_text(code);
    EXPECT_LT(smaller->hexahedra.size(), mesh.hexahedra.size());
    EXPECT_EQ(support::fault_of_filling(*smaller, code), "") << canon::to_text(code);
    const auto again = flips::smaller_by_replacement(mesh, code.quads, beam, options);
    EXPECT_EQ(again->hexahedra, smaller->hexahedra);
    flips::ReplacementOptions climbing = options;
    climbing.uphill = 4;
    climbing.keep_shellable = false;
    const auto other = flips::smaller_by_replacement(mesh, code.quads, beam, climbing);
    ASSERT_TRUE(other) << canon::to_text(code);
    EXPECT_LT(other->hexahedra.size(), mesh.hexahedra.size());
    EXPECT_EQ(support::fault_of_mesh(*other, code), "") << canon::to_text(code);
    ++reduced;
  }
  EXPECT_GT(reduced, 3U);
}

TEST(AddBall, IsKnownWithAllItsParts) {
  const Beam source = grown(20, 20, 2'000, 34);
  Beam target = grown(20, 1, 50, 2);
  std::size_t added = 0;
  for (const auto& code : source.codes()) {
    if (code.quads > 14) continue;
    const auto mesh = flips::filling_of(source, source.fronts_of(code).back().id).mesh;
    const auto before = target.first_level(code);
    const auto id = flips::add_ball(target, mesh, flips::FrontOrigin::exchanged);
    EXPECT_EQ(target.state(id).code, code);
    EXPECT_LT(static_cast<std::size_t>(target.level_of(id)), mesh.hexahedra.size());
    if (!before) {
      EXPECT_EQ(target.origin_of(id), flips::FrontOrigin::exchanged);
      ++added;
    }
    const auto made = flips::filling_of(target, id).mesh;
    EXPECT_EQ(made.hexahedra.size(), static_cast<std::size_t>(target.level_of(id)) + 1);
    EXPECT_EQ(support::fault_of_filling(made, code), "") << canon::to_text(code);
  }
  EXPECT_GT(added, 3U);
}

TEST(AddBall, IsExpandedInTheNextSweep) {
  const Beam source = grown(20, 2, 100, 12);
  Beam target = grown(20, 1, 3, 4);
  for (const auto& code : source.codes())
    (void)flips::add_ball(target, flips::filling_of(source, source.fronts_of(code)[0].id).mesh,
                          flips::FrontOrigin::met);
  const std::size_t fronts = target.fronts();
  const std::uint64_t candidates = target.candidates();
  target.rewind();
  while (target.level() < target.last_level()) (void)target.expand_level();
  EXPECT_GT(target.candidates(), candidates);
  EXPECT_GT(target.fronts(), fronts);
  for (const auto& code : target.codes()) {
    const auto id = target.fronts_of(code)[0].id;
    EXPECT_EQ(support::fault_of_filling(flips::filling_of(target, id).mesh, code), "");
  }
}

TEST(WidestBoundary, IsThatOfTheSetsThatAreLeft) {
  support::Random random(29);
  for (int i = 0; i < 20; ++i) {
    const auto shelling = support::random_shelling(4 + random.below(20), 40, random);
    auto cells = support::cells_of(shelling);
    std::reverse(cells.begin(), cells.end());
    std::size_t widest = 0;
    for (auto left = cells; !left.empty(); left.erase(left.begin()))
      widest = std::max(widest, oracle::boundary(left).size());
    EXPECT_EQ(flips::widest_boundary(support::mesh_of(cells)), static_cast<int>(widest));
  }
}

}  // namespace
