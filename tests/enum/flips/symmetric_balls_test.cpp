// Claim. What is grown outwards are balls that their involution takes to themselves, all that
// orbits reach; of a cavity and all these balls the least union under the strict rule is found.
// Oracle. Meshes checked by sets, shellings by links; the involution carried over from facet to
// facet; unions of all pairs.
#include "enum/flips/symmetric_balls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/flips/crown.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/extension.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using flips::SymmetricBeam;

flips::BeamOptions widths(int max_quads, std::size_t per_level, int threads) {
  return {.max_quads = max_quads,
          .fronts_per_class = 1'000,
          .fronts_per_level = per_level,
          .threads = threads};
}

TEST(SymmetricBalls, AreBallsWithTheirInvolution) {
  for (const bool are_mirrored : {false, true}) {
    SymmetricBeam beam(flips::small_symmetric_balls(4, are_mirrored), flips::Growth::outward,
                       widths(26, 30, 2));
    std::map<int, int> checked;
    for (int level = 0; level <= 11; ++level, (void)beam.expand_level())
      for (const SymmetricBeam::Node& node : beam.nodes()) {
        if (checked[level]++ % (3 * support::kStride) != 0) continue;
        const auto mesh = support::mesh_of(beam.layers_to(node));
        ASSERT_EQ(static_cast<int>(mesh.hexahedra.size()), node.level);
        ASSERT_EQ(support::fault_of_filling(mesh, node.state.code), "");
        ASSERT_TRUE(support::Extension(mesh, support::image_of(node.state)).is_there())
            << canon::to_text(node.state.code) << " of " << level;
        if (node.state.code.quads > flips::kMaxStateQuads) continue;
        EXPECT_EQ(flips::scars_of(mesh, canon::decode(node.state.code).value()),
                  node.state.scars.as<flips::kMaxStateQuads>());
      }
    EXPECT_GT(checked[11], 60);
    EXPECT_TRUE(beam.expanded().front().is_start());
  }
}

TEST(SymmetricBalls, AreAllThatOrbitsReachFromTheirStarts) {
  for (const bool are_mirrored : {false, true}) {
    auto starts = flips::small_symmetric_balls(3, are_mirrored);
    std::map<flips::SymmetricState, int> least;
    for (const auto& start : starts)
      least.emplace(flips::canonical_state(start.front).state,
                    static_cast<int>(start.layers.hexahedra.size()));
    for (int h = 0; h < 8; ++h)
      for (const auto& [state, level] : std::map(least)) {
        if (level != h) continue;
        const auto reach = [&](const flips::GluedOrbit& orbit) {
          int& known = least.emplace(flips::canonical_state(orbit.made).state, 99).first->second;
          known = std::min(known, h + orbit.orbit.size);
        };
        flips::for_each_glueable_orbit(flips::front_of(state), 22, reach);
        flips::for_each_glueable_crown(flips::front_of(state), 22, reach);
      }
    std::erase_if(least, [](const auto& entry) { return entry.second > 8; });
    SymmetricBeam beam(std::move(starts), flips::Growth::outward, widths(22, 100'000, 2));
    std::map<flips::SymmetricState, int> seen;
    for (int level = 0; level <= 8; ++level, (void)beam.expand_level())
      for (const auto& node : beam.nodes())
        EXPECT_TRUE(seen.emplace(node.state, node.level).second);
    EXPECT_TRUE(beam.is_exhaustive());
    EXPECT_EQ(seen, least);
    EXPECT_GT(seen.size(), 50U);
  }
}

// Of all shellable balls, made without a symmetry, and all involutions of these: all but one and
// two hexahedra, and four and six around an edge.
TEST(SymmetricBalls, AreReachedByOrbitsAndCrownsFromAFew) {
  for (const auto& [are_mirrored, most] : {std::pair(false, 8), std::pair(true, 7)}) {
    std::map<int, std::set<flips::SymmetricState>> all, reached;
    for (const auto& start : flips::small_symmetric_balls(most, are_mirrored))
      all[static_cast<int>(start.layers.hexahedra.size())].insert(
          flips::canonical_state(start.front).state);
    std::map<int, std::vector<int>> quads;  // of those that are not reached, by hexahedra
    std::size_t count = 0;
    for (int h = 1; h <= most; ++h)
      for (const flips::SymmetricState& state : all[h]) {
        ++count;
        if (!reached[h].contains(state)) quads[h].push_back(state.code.quads);
        if (h == most) continue;
        const auto reach = [&](const flips::GluedOrbit& orbit) {
          reached[h + orbit.orbit.size].insert(flips::canonical_state(orbit.made).state);
        };
        flips::for_each_glueable_orbit(flips::front_of(state), flips::kMaxSymmetricQuads, reach);
        flips::for_each_glueable_crown(flips::front_of(state), flips::kMaxSymmetricQuads, reach);
      }
    using ByHexahedra = std::map<int, std::vector<int>>;
    EXPECT_EQ(quads, are_mirrored
                         ? (ByHexahedra{{1, {6, 6, 6}}, {2, {10, 10}}, {4, {16}}, {6, {24}}})
                         : (ByHexahedra{{1, {6, 6}}, {2, {10, 10}}, {4, {16}}, {6, {24}}}));
    EXPECT_GT(count, 900U);
  }
}

/// The least number of hexahedra of a union under the strict rule, tried with all ways to turn a
/// ball.
int least_union(const SymmetricBeam& collars, const SymmetricBeam::Node& cavity,
                const SymmetricBeam& balls, const canon::Code& target) {
  int least = 1'000;
  const auto boundary = canon::decode(cavity.state.code).value();
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  for (const SymmetricBeam::Node& ball : balls.expanded()) {
    if (ball.state.code != cavity.state.code || ball.level + cavity.level >= least) continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(flags.count); ++i) {
      const auto turn = canon::labelling_from(boundary, flags.flags[i]);
      bool keeps = true;
      for (int v = 0; v < boundary.vertices(); ++v) {
        const auto at = static_cast<std::size_t>(v);
        keeps = keeps && cavity.state.image[turn[at]] == turn[ball.state.image[at]];
      }
      if (!keeps) continue;
      const auto mesh = flips::filled(collars.layers_to(cavity), balls.layers_to(ball), turn,
                                      flags.flags[i].mirrored, target.quads);
      if (support::fault_of_mesh(mesh, target).empty()) least = ball.level + cavity.level;
    }
  }
  return least;
}

TEST(SymmetricBalls, LeastFitIsThatOfAllPairs) {
  constexpr int kMost = 9;
  const auto options = widths(20, 60, 1);
  const flips::SymmetricBalls balls(options, kMost);
  std::vector<SymmetricBeam> oracle;
  for (const bool are_mirrored : {false, true}) {
    auto starts = flips::small_symmetric_balls(6, are_mirrored);
    std::erase_if(starts, [&](const auto& start) {
      return start.front.front.boundary.quads() > options.max_quads;
    });
    auto& beam = oracle.emplace_back(std::move(starts), flips::Growth::outward, options);
    for (int level = 0; level <= kMost; ++level) (void)beam.expand_level();
  }
  EXPECT_EQ(balls.size(), oracle[0].expanded().size() + oracle[1].expanded().size());
  int with = 0, without = 0, cases = 0;
  for (const char* text :
       {"q1:022972977f", "q1:088a2a5ddf7f", "q1:02228a5d777f", "q1:0888a55dff"}) {
    const auto code = canon::from_text(text).value();
    for (const auto& start : flips::symmetric_fronts(canon::decode(code).value(), {})) {
      SymmetricBeam collars({flips::start_of_collars(start)}, flips::Growth::inward,
                            widths(20, 20, 1));
      for (int level = 0; level <= 4; ++level, (void)collars.expand_level())
        for (const auto& cavity : collars.nodes()) {
          if (cases++ % (2 * support::kStride) != 0) continue;
          int expected = 1'000;
          for (const auto& beam : oracle)
            expected = std::min(expected, least_union(collars, cavity, beam, code));
          const auto fit = balls.least_fit({&cavity, 1}, 1'000, 1);
          ASSERT_EQ(fit ? fit->hexahedra : 1'000, expected) << text << " " << level;
          ++(fit ? with : without);
          if (!fit) continue;
          EXPECT_FALSE(balls.least_fit({&cavity, 1}, fit->hexahedra, 1).has_value());
          const auto mesh = flips::filled(collars.layers_to(cavity), balls.layers_of(*fit),
                                          fit->turn, fit->is_mirrored, code.quads);
          EXPECT_EQ(support::fault_of_filling(mesh, code), "");
        }
    }
  }
  EXPECT_GT(with, 20);
  EXPECT_GT(without, 20);
}

TEST(SymmetricBalls, FillWhereNoOtherBallIsKnown) {
  // Seven hexahedra in a row have 30 quads; collars of two leave five or six of them.
  flips::Beam cube(flips::canonical_state(flips::single_hexahedron()).state, widths(6, 1, 1));
  const auto code = support::code_of_bar(7);
  const flips::MeetingOptions options{.collars = widths(30, 100, 1), .max_collar = 2};
  EXPECT_FALSE(flips::best_symmetric_meeting(flips::BeamBalls(cube), code, options).has_value());
  const flips::SymmetricBalls balls(widths(26, 5'000, 2), 6);
  const auto filling = flips::best_symmetric_meeting(flips::BeamBalls(cube), code, options, &balls);
  ASSERT_TRUE(filling.has_value());
  EXPECT_EQ(filling->mesh.hexahedra.size(), 7U);
  EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "");
}

TEST(SymmetricBalls, AreTheSameForAnyNumberOfThreads) {
  const auto code = canon::from_text("q1:0208a5e4a5df7f").value();
  std::vector<flips::SymmetricFit> fits;
  for (const int threads : {1, 3}) {
    const flips::SymmetricBalls balls(widths(22, 50, threads), 10);
    const auto start = flips::symmetric_fronts(canon::decode(code).value(), {}).front();
    SymmetricBeam collars({flips::start_of_collars(start)}, flips::Growth::inward,
                          widths(22, 500, threads));
    for (int level = 0; level < 4; ++level) (void)collars.expand_level();
    const auto fit = balls.least_fit(collars.nodes(), 100, threads);
    ASSERT_TRUE(fit.has_value());
    fits.push_back(*fit);
  }
  EXPECT_EQ(fits[0].cavity, fits[1].cavity);
  EXPECT_EQ(fits[0].ball, fits[1].ball);
  EXPECT_EQ(fits[0].hexahedra, fits[1].hexahedra);
}

}  // namespace
