// Claim. Two balls glued along a disc obey the strict rule exactly where no pair of vertices of the
// disc that lies in no quad of it is related in both; best_cut() finds the least of these unions
// within its limits, and nothing else.
// Oracle. The unions made here, dart by dart, and the strict rule, the boundary and Euler's count
// by sets; all unions of a few balls along all small discs.
#include "enum/flips/cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "tests/enum/flips/ball_unions.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;
using flips::Beam;
using support::all_balls;
using support::Ball;
using support::grown;
using support::is_strict_union;
using support::Match;
using support::random_match;

TEST(Cut, TwoBallsAreGluedExactlyWhereNoOpenPairIsRelatedInBoth) {
  const auto balls = all_balls(grown(18, 10, 300, 6));
  support::Random random(11);
  std::array<int, 7> allowed{}, refused{};  // by quads of the patch
  for (int trial = 0; trial < support::share_of(1500); ++trial) {
    const Ball& a = balls[random.below(balls.size())];
    const Ball& b = balls[random.below(balls.size())];
    const Match match = random_match(a, b, std::min<std::size_t>(6, 1 + random.below(8)), random);
    if (!match.disc()) continue;
    const bool expected = match.may_be_glued();
    ASSERT_EQ(is_strict_union(match), expected) << trial;
    ++(expected ? allowed : refused)[match.patch().size()];
    if (!expected) continue;
    const auto boundary = match.boundary();
    ASSERT_TRUE(boundary && boundary->is_three_connected()) << trial;
  }
  // A single quad has no open pair.
  EXPECT_EQ(refused[1], 0);
  for (std::size_t quads = 2; quads <= 6; ++quads) {
    EXPECT_GT(allowed[quads], support::share_of(quads < 5 ? 10 : 3)) << quads;
    EXPECT_GT(refused[quads], support::share_of(50)) << quads;
  }
}

/// What best_cut() owes a boundary whose least union has this many hexahedra.
void expect_least(const flips::BallSource& balls, const canon::Code& code,
                  flips::CutOptions options, std::size_t least) {
  SCOPED_TRACE(canon::to_text(code));
  const auto found = flips::best_cut(balls, code, options);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->hexahedra.size(), least);
  EXPECT_EQ(support::fault_of_mesh(*found, code), "");
  options.below = static_cast<int>(least);
  EXPECT_FALSE(flips::best_cut(balls, code, options));
  ++options.below;
  const auto again = flips::best_cut(balls, code, options);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->vertices, found->vertices);
  EXPECT_EQ(again->hexahedra, found->hexahedra);
}

/// The least numbers of hexahedra of all unions of two balls along a disc within the limits.
std::map<canon::Code, std::size_t> least_unions(const std::vector<Ball>& balls, int max_circle,
                                                int max_interior) {
  std::map<canon::Code, std::size_t> least;
  support::for_each_match(balls, max_circle, max_interior, [&](const Match& match) {
    if (!match.may_be_glued()) return;
    const auto code = canon::canonical_form(match.boundary().value()).code;
    const std::size_t hexahedra = match.cells().size();
    const auto place = least.try_emplace(code, hexahedra).first;
    place->second = std::min(place->second, hexahedra);
  });
  return least;
}

TEST(Cut, TheLeastOfAllUnionsIsFound) {
  const Beam beam = grown(14, 10, 100, 2);
  const flips::BeamBalls source(beam);
  const flips::CutOptions options{.max_circle = 8, .max_interior = 1, .max_quads = 14};
  const auto least = least_unions(all_balls(beam), options.max_circle, options.max_interior);
  EXPECT_GT(least.size(), 300U);
  std::size_t i = 0;
  for (const auto& [code, hexahedra] : least)
    if (code.quads < 16 || ++i % (16 * support::kStride) == 0)
      expect_least(source, code, options, hexahedra);
  // Of the other boundaries none is a union.
  auto classes = support::four_cycle_class();
  std::size_t others = 0;
  for (int quads = 3; quads <= 10; ++quads) {
    classes = support::grown(classes);
    for (const auto& [code, map] : classes) {
      if (quads % 2 != 0 || !oracle::is_three_connected(map) || least.contains(code)) continue;
      EXPECT_FALSE(flips::best_cut(source, code, options)) << canon::to_text(code);
      ++others;
    }
  }
  EXPECT_GT(others, 3U);
}

/// The balls of a beam with one of two boundaries. All balls together would mostly give a union of
/// small ones, whose boundaries are their own mirror images.
class BallsWithTwoBoundaries final : public flips::BallSource {
 public:
  BallsWithTwoBoundaries(const Beam& beam, const canon::Code& a, const canon::Code& b)
      : balls_(beam), codes_{a, b} {}
  [[nodiscard]] std::optional<int> least_with(const canon::Code& code) const override {
    return codes_.contains(code) ? balls_.least_with(code) : std::nullopt;
  }
  [[nodiscard]] std::vector<flips::KnownBall> balls_with(const canon::Code& code) const override {
    return balls_.balls_with(code);
  }
  [[nodiscard]] flips::Layers layers_of(const canon::Code& code, std::size_t ball) const override {
    return balls_.layers_of(code, ball);
  }

 private:
  flips::BeamBalls balls_;
  std::set<canon::Code> codes_;
};

TEST(Cut, WhatAWideDiscJoinsIsFound) {
  const Beam beam = grown(20, 5, 100, 8);
  const flips::BeamBalls all(beam);
  const auto balls = all_balls(beam);
  support::Random random(12);
  std::map<std::pair<int, int>, int> found;  // by edges of the circle and vertices inside
  int unknown = 0;
  for (int trial = 0; trial < 15000; ++trial) {
    const Ball& a = balls[random.below(balls.size())];
    const Ball& b = balls[random.below(balls.size())];
    const Match match = random_match(a, b, 3 + random.below(5), random);
    const auto disc = match.disc();
    if (!disc || disc->first > 8 || disc->second > 4 || disc->second == 0) continue;
    if (!match.may_be_glued() || match.boundary_quads() > flips::kMaxSearchQuads) continue;
    if (++found[*disc] > 10) continue;
    const auto code = canon::canonical_form(match.boundary().value()).code;
    const std::size_t at_most = a.cells.size() + b.cells.size();
    if (found[*disc] == 1) {
      const auto mesh = flips::best_cut(all, code, {});
      ASSERT_TRUE(mesh) << canon::to_text(code);
      EXPECT_LE(mesh->hexahedra.size(), at_most) << canon::to_text(code);
      expect_least(all, code, {}, mesh->hexahedra.size());
    }
    const BallsWithTwoBoundaries two(beam, a.code, b.code);
    const flips::CutOptions options{
        .max_circle = disc->first, .max_interior = disc->second, .max_quads = 20};
    const auto mesh = flips::best_cut(two, code, options);
    ASSERT_TRUE(mesh) << canon::to_text(code);
    EXPECT_LE(mesh->hexahedra.size(), at_most) << canon::to_text(code);
    expect_least(two, code, options, mesh->hexahedra.size());
    unknown += beam.first_level(code) ? 0 : 1;
  }
  EXPECT_GT(found.size(), 6U);
  EXPECT_GT(unknown, 10) << "boundaries that the beam does not reach";
}

TEST(Cut, SeveralComeInOrderAndTheLeastFirst) {
  const Beam beam = grown(14, 10, 500, 12);
  const flips::BeamBalls balls(beam);
  std::size_t several = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads < 12) continue;
    flips::CutOptions options;
    const auto least = flips::best_cut(balls, code, options);
    options.count = 5;
    const auto meshes = flips::best_cuts(balls, code, options);
    ASSERT_EQ(meshes.empty(), !least.has_value());
    ASSERT_LE(meshes.size(), 5U);
    if (meshes.empty()) continue;
    EXPECT_EQ(meshes.front().hexahedra.size(), least->hexahedra.size());
    EXPECT_TRUE(std::is_sorted(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) {
      return a.hexahedra.size() < b.hexahedra.size();
    }));
    for (const auto& mesh : meshes) EXPECT_EQ(support::fault_of_mesh(mesh, code), "");
    several += meshes.size() == 5 ? 1 : 0;
    // A greater count gives the same meshes first, as far as their sizes tell.
    options.count = 8;
    const auto more = flips::best_cuts(balls, code, options);
    for (std::size_t i = 0; i < meshes.size(); ++i)
      EXPECT_EQ(more[i].hexahedra.size(), meshes[i].hexahedra.size());
    // All with fewer hexahedra than the last one, when only these are asked for.
    options.below = static_cast<int>(meshes.back().hexahedra.size());
    for (const auto& mesh : flips::best_cuts(balls, code, options))
      EXPECT_LT(mesh.hexahedra.size(), meshes.back().hexahedra.size());
  }
  EXPECT_GT(several, 3U);
}

TEST(Cut, NeedsSmallLimits) {
  const Beam beam = grown(10, 1, 1, 0);
  const flips::BeamBalls source(beam);
  const auto code = canon::canonical_form(Quadrangulation::cube()).code;
  for (const flips::CutOptions& options :
       {flips::CutOptions{.max_circle = 12}, flips::CutOptions{.max_interior = 9},
        flips::CutOptions{.max_quads = flips::kMaxStateQuads + 1}})
    EXPECT_THROW((void)flips::best_cut(source, code, options), core::PreconditionViolated);
}

}  // namespace
