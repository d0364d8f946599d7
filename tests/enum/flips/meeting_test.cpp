// Claim. The meshes of meetings fill their boundaries under the strict rule; small boundaries get
// their least meshes; the scars decide which unions are strict.
// Oracle. Meshes checked by sets; least numbers by plain search.
#include "enum/flips/meeting.hpp"

#include <gtest/gtest.h>

#include "enum/core/errors.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using flips::Beam;
using flips::BeamOptions;

BeamOptions limits(int max_quads, std::size_t per_class, std::size_t per_level) {
  BeamOptions options;
  options.max_quads = max_quads;
  options.fronts_per_class = per_class;
  options.fronts_per_level = per_level;
  return options;
}

Beam balls(const BeamOptions& options, int hexahedra) {
  Beam beam(flips::canonical_state(flips::single_hexahedron()).state, options);
  while (beam.level() + 1 < hexahedra && beam.expand_level() > 0) {
  }
  return beam;
}

TEST(Meeting, SmallBoundariesGetTheirLeastMeshes) {
  const Beam beam = balls(limits(18, 10, 2'000), 12);
  flips::MeetingOptions options{.collars = limits(18, 10, 500), .max_collar = 4};
  for (const auto& [text, least] :
       {std::pair("q1:08a5df", 1U), {"q1:022972977f", 2U}, {"q1:088a2a5ddf7f", 4U}}) {
    const auto code = canon::from_text(text).value();
    const auto filling = flips::best_meeting(flips::BeamBalls(beam), code, options);
    ASSERT_TRUE(filling.has_value()) << text;
    EXPECT_EQ(filling->mesh.hexahedra.size(), least) << text;
    EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "") << text;
  }
}

TEST(Meeting, CollarsReachWhatBallsDoNot) {
  // Balls of at most 6 hexahedra; targets are balls of 9 to 12 that random shellings made.
  const Beam beam = balls(limits(22, 200, 20'000), 6);
  flips::MeetingOptions options{.collars = limits(22, 20, 400), .max_collar = 7};
  support::Random random(61);
  int found = 0;
  for (int i = 0; i < 25; ++i) {
    const auto shelling = support::random_shelling(9 + random.below(4), 20, random);
    const auto code = canon::canonical_form(shelling.front().boundary).code;
    const auto filling = flips::best_meeting(flips::BeamBalls(beam), code, options);
    if (!filling) continue;
    ++found;
    EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "") << canon::to_text(code);
    options.below = static_cast<int>(filling->mesh.hexahedra.size());
    EXPECT_FALSE(flips::best_meeting(flips::BeamBalls(beam), code, options).has_value())
        << "a better one was missed";
    options.below = 1 << 14;
  }
  EXPECT_GT(found, 10);
}

TEST(Meeting, NeedsA3ConnectedBoundary) {
  const Beam beam = balls(limits(16, 10, 100), 4);
  const oracle::QuadList folded{{0, 1, 5, 4}, {4, 5, 7, 6}, {1, 3, 7, 5}, {3, 2, 6, 7},
                                {2, 0, 4, 6}, {0, 2, 3, 8}, {0, 8, 3, 9}, {0, 9, 3, 1}};
  const auto q = complex::Quadrangulation::from_quads(folded).value();
  EXPECT_THROW((void)flips::best_meeting(flips::BeamBalls(beam), canon::canonical_form(q).code,
                                         {.collars = limits(16, 10, 100)}),
               core::PreconditionViolated);
}

}  // namespace
