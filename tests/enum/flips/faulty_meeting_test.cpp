// Claim. Faulty meetings are meshes of their boundary with as many faults as they say, different
// ones, no more than asked for and none too large, the same for any number of threads; all kinds
// that there are may come.
// Oracle. Faults and the boundary by sets; the kinds for collars of one hexahedron by trying all
// flips of all balls. Those with symmetric collars by the search of all collars.
#include "enum/flips/faulty_meeting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/flips/symmetric_front.hpp"
#include "tests/enum/flips/faults.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using support::cells_of;

flips::FaultyMeetingOptions meeting_limits(int below, std::size_t count) {
  return {.collars = {.max_quads = 20, .fronts_per_class = 5, .fronts_per_level = 60},
          .max_collar = 4,
          .wanted = {.price = 2, .below = below, .count = count}};
}

TEST(FaultyMeeting, KnowsItsFaults) {
  support::expect_faults_are_known(meeting_limits, flips::faulty_meetings);
}

TEST(FaultyMeeting, KnowsItsFaultsWithWideCollars) {
  support::expect_faults_are_known(
      meeting_limits, [](const auto& balls, const auto& code, flips::FaultyMeetingOptions options) {
        options.collars.max_quads = 32;
        return flips::faulty_meetings(balls, code, options);
      });
}

TEST(FaultyMeeting, KnowsItsFaultsWithSymmetricCollars) {
  support::expect_faults_are_known(meeting_limits,
                                   [](const auto& balls, const auto& code, const auto& options) {
                                     return flips::faulty_symmetric_meetings(balls, code, options);
                                   });
}

TEST(FaultyMeeting, KnowsItsFaultsWithSymmetricBalls) {
  const flips::SymmetricBalls symmetric(
      {.max_quads = 24, .fronts_per_class = 20, .fronts_per_level = 500}, 18);
  // Without other balls: what is found is of these.
  const flips::Beam cube = support::grown(20, 1, 1, 0);
  support::expect_faults_are_known(
      meeting_limits,
      [&](const auto&, const auto& code, const auto& options) {
        return flips::faulty_symmetric_meetings(cube, code, options, &symmetric);
      },
      0);
}

/// The ball and one hexahedron more.
std::vector<oracle::Cell> glued_cells(const flips::Beam& beam, flips::FrontId ball,
                                      const flips::Prism& prism) {
  auto cells = cells_of(flips::filling_of(beam, ball).mesh);
  oracle::Cell cell{};
  for (std::size_t i = 0; i < 4; ++i) {
    cell[cells::kCornerOfPrism[i]] = prism.bottom[i];
    const bool is_new = prism.top[i] == flips::kNewVertex;
    cell[cells::kCornerOfPrism[4 + i]] =
        is_new ? 10'000 + static_cast<std::uint32_t>(i) : prism.top[i];
  }
  cells.push_back(cell);
  return cells;
}

/// The kinds of the meshes that one hexahedron makes of the beam's balls with a boundary.
void add_kinds(const flips::Beam& beam, const canon::Code& of_ball, const canon::Code& target,
               support::Kinds& kinds) {
  const auto boundary = canon::decode(of_ball).value();
  for (int i = 0; i < 16 * boundary.quads(); ++i) {
    const flips::Flip flip{static_cast<complex::Quad>(i / 16), static_cast<std::uint8_t>(i % 16)};
    if (boundary.quads() + 6 - 2 * flip.consumed() != target.quads) continue;
    const auto prism = flips::prism_of(boundary, flip);
    if (!prism) continue;
    const auto [outer, former, top, inverse] = flips::flipped(boundary, flip, *prism);
    if (canon::canonical_form(outer).code != target) continue;
    const flips::Front outside{outer, flips::relation_of_quads(outer)};
    const auto back = flips::prism_of(outer, inverse);
    if (!back || !flips::may_glue(outside, inverse, *back)) continue;
    for (const auto& ball : beam.fronts_of(of_ball)) {
      const auto cells = glued_cells(beam, ball.id, *prism);
      const int faults = support::faults_of(cells);
      if (faults > 0 && !support::has_facet_thrice(cells))
        kinds.emplace(faults, static_cast<int>(cells.size()));
    }
  }
}

TEST(FaultyMeeting, HasAllKindsThatOneHexahedronMakesOfTheBalls) {
  const auto beam = support::grown(18, 5, 300, 16);
  const auto codes = beam.codes();
  std::size_t compared = 0, with_faults = 0;
  for (const auto& code : codes) {
    if (code.quads != 16) continue;
    support::Kinds expected;
    for (const auto& of_ball : codes) add_kinds(beam, of_ball, code, expected);
    with_faults += expected.size();
    auto options = meeting_limits(1'000, 1'000'000);
    options.max_collar = 1;
    EXPECT_EQ(support::kinds_of(flips::faulty_meetings(beam, code, options)), expected)
        << canon::to_text(code);
    if (++compared == 3) break;
  }
  EXPECT_EQ(compared, 3U);
  EXPECT_GT(with_faults, 10U);
}

TEST(FaultyMeeting, WithSymmetricCollarsIsOneOfAllMeetings) {
  const auto beam = support::grown(18, 5, 300, 16);
  const int wanted = support::share_of(8, 2);
  int with_involution = 0;
  std::size_t kinds = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads < 14 || code.quads > 16) continue;
    auto options = meeting_limits(1'000, 1'000'000);
    options.collars = {.max_quads = 24,
                       .fronts_per_class = 1'000,
                       .fronts_per_level = 100'000,
                       .use_dominance = false};
    options.max_collar = 2;
    const auto symmetric = flips::faulty_symmetric_meetings(beam, code, options);
    if (flips::involutions_of(canon::decode(code).value()).empty()) {
      EXPECT_TRUE(symmetric.empty()) << canon::to_text(code);
      continue;
    }
    const auto some = support::kinds_of(symmetric);
    const auto all = support::kinds_of(flips::faulty_meetings(beam, code, options));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()))
        << canon::to_text(code);
    kinds += some.size();
    if (++with_involution == wanted) break;
  }
  EXPECT_EQ(with_involution, wanted);
  EXPECT_GT(kinds, static_cast<std::size_t>(2 * wanted));
}

TEST(FaultyMeeting, GivesDifferentOnesForAnotherSeed) {
  const auto beam = support::grown(18, 5, 300, 16);
  const auto code = canon::from_text("q1:00888a2a575dddff").value();
  std::set<std::vector<complex::Hexahedron>> meshes;
  std::size_t all = 0;
  for (const std::uint64_t seed : {1U, 2U}) {
    auto options = meeting_limits(40, 10);
    options.collars.seed = seed;
    for (const auto& [mesh, faults] : flips::faulty_meetings(beam, code, options)) {
      meshes.insert(mesh.hexahedra);
      ++all;
    }
  }
  EXPECT_EQ(all, 20U);
  EXPECT_GT(meshes.size(), 12U);
}

}  // namespace
