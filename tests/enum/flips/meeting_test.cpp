// Claim. The meshes of meetings fill their boundaries under the strict rule; small boundaries get
// their least meshes; the scars decide which unions are strict.
// Oracle. Meshes checked by sets; least numbers by plain search.
#include "enum/flips/meeting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/symmetric_front.hpp"
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

/// The boundary of a random ball of `least` hexahedra or up to `spread` - 1 more.
canon::Code random_code(std::size_t least, std::size_t spread, int max_quads,
                        support::Random& random) {
  const auto shelling = support::random_shelling(least + random.below(spread), max_quads, random);
  return canon::canonical_form(shelling.front().boundary).code;
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

/// Valid meshes; returns the least number of hexahedra of each parity.
std::array<std::size_t, 2> expect_varied(const std::vector<flips::Filling>& fillings,
                                         const canon::Code& code) {
  constexpr std::size_t kNone = 1000;
  std::array<std::size_t, 2> least{kNone, kNone};
  for (const auto& filling : fillings) {
    const std::size_t size = filling.mesh.hexahedra.size();
    EXPECT_EQ(support::fault_of_filling(filling.mesh, code), "") << canon::to_text(code);
    least[size % 2] = std::min(least[size % 2], size);
  }
  return least;
}

TEST(Meeting, VariedOnesHaveTheBestOneAmongThem) {
  const Beam beam = balls(limits(18, 10, 2'000), 12);
  const flips::MeetingOptions options{.collars = limits(20, 10, 300), .max_collar = 6};
  for (const auto& code : beam.codes()) {
    if (code.quads < 12 || code.quads > 14) continue;
    const auto least = expect_varied(flips::varied_meetings(beam, code, options), code);
    const auto best = flips::best_meeting(flips::BeamBalls(beam), code, options);
    ASSERT_TRUE(best);
    EXPECT_EQ(std::min(least[0], least[1]), best->mesh.hexahedra.size());
    const auto symmetric = flips::varied_symmetric_meetings(beam, code, options);
    const auto of_symmetric = expect_varied(symmetric, code);
    if (const auto also = flips::best_symmetric_meeting(flips::BeamBalls(beam), code, options))
      EXPECT_EQ(std::min(of_symmetric[0], of_symmetric[1]), also->mesh.hexahedra.size());
    else
      EXPECT_TRUE(symmetric.empty());
  }
}

TEST(Meeting, VariedOnesAreOfEitherParity) {
  const Beam beam = balls(limits(20, 10, 1'500), 48);
  const flips::MeetingOptions options{.collars = limits(20, 10, 100), .max_collar = 3};
  std::size_t tried = 0;
  for (const auto& code : beam.codes()) {
    std::array<std::size_t, 2> known{1000, 1000};
    for (const auto& front : beam.fronts_of(code)) {
      const auto size = static_cast<std::size_t>(front.level) + 1;
      known[size % 2] = std::min(known[size % 2], size);
    }
    if (known[0] == 1000 || known[1] == 1000) continue;
    const auto least = expect_varied(flips::varied_meetings(beam, code, options), code);
    EXPECT_LE(least[0], known[0]) << canon::to_text(code);
    EXPECT_LE(least[1], known[1]) << canon::to_text(code);
    if (++tried == 5) break;
  }
  EXPECT_EQ(tried, 5U);
}

TEST(Meeting, CollarsReachWhatBallsDoNot) {
  // Balls of at most 6 hexahedra; targets are balls of 9 to 12 that random shellings made.
  const Beam beam = balls(limits(22, 200, 20'000), 6);
  flips::MeetingOptions options{.collars = limits(22, 20, 400), .max_collar = 7};
  support::Random random(61);
  int found = 0;
  for (int i = 0; i < 25; ++i) {
    const auto code = random_code(9, 4, 20, random);
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

TEST(Meeting, WideCollarsAreThoseOfASearchWithoutSymmetry) {
  // Three hexahedra add at most twelve quads: nothing is too long for the other search, and nothing
  // is left out in either one, so both see the same collars.
  const Beam beam = balls(limits(22, 200, 20'000), 6);
  constexpr std::size_t kAll = 1'000'000;
  flips::MeetingOptions narrow{.collars = limits(30, kAll, kAll), .max_collar = 3};
  flips::MeetingOptions wide = narrow;
  wide.collars.max_quads = 40;
  support::Random random(63);
  int found = 0;
  for (int i = 0; i < 12; ++i) {
    const auto code = random_code(7, 3, 18, random);
    const auto other = flips::best_meeting(flips::BeamBalls(beam), code, narrow);
    const auto filling = flips::best_meeting(flips::BeamBalls(beam), code, wide);
    ASSERT_EQ(filling.has_value(), other.has_value()) << canon::to_text(code);
    if (!filling) continue;
    ++found;
    EXPECT_EQ(filling->mesh.hexahedra.size(), other->mesh.hexahedra.size());
    EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "") << canon::to_text(code);
  }
  EXPECT_GT(found, 4);
}

TEST(Meeting, GuidedCollarsMakeMeshes) {
  const Beam beam = balls(limits(22, 200, 20'000), 6);
  flips::MeetingOptions options{.collars = limits(32, 20, 100), .max_collar = 7, .guided = 2};
  support::Random random(65);
  int found = 0;
  for (int i = 0; i < 15; ++i) {
    const auto code = random_code(9, 4, 20, random);
    const auto filling = flips::best_meeting(flips::BeamBalls(beam), code, options);
    if (!filling) continue;
    ++found;
    EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "") << canon::to_text(code);
  }
  EXPECT_GT(found, 5);
}

TEST(Meeting, WideCollarsGoThroughLongBoundaries) {
  // A bar has 38 quads, and the single hexahedron is the only ball known.
  const Beam cube = balls(limits(6, 1, 1), 1);
  flips::MeetingOptions options{.collars = limits(38, 100, 100), .max_collar = 8};
  options.collars.scars_per_quad = 10;
  const auto code = support::code_of_bar(9);
  const auto filling = flips::best_meeting(flips::BeamBalls(cube), code, options);
  ASSERT_TRUE(filling.has_value());
  EXPECT_EQ(filling->mesh.hexahedra.size(), 9U);
  EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "");
  EXPECT_EQ(flips::varied_meetings(cube, code, options).size(), 1U);
}

TEST(Meeting, WideCollarsKeepApartWhatMustBe) {
  const Beam beam = balls(limits(20, 50, 20'000), 8);
  const auto code = canon::from_text("q1:088a2a5ddf7f").value();
  const auto boundary = canon::decode(code).value();
  flips::MeetingOptions options{.collars = limits(32, 50, 500), .max_collar = 6};
  const auto free = flips::best_meeting(flips::BeamBalls(beam), code, options);
  ASSERT_TRUE(free.has_value());
  const flips::Scars scars = flips::scars_of(free->mesh, boundary);
  int forbidden = 0;
  for (complex::Vertex a = 0; a < boundary.vertices(); ++a)
    for (complex::Vertex b = 0; b < a; ++b) {
      if (!scars.has(a, b)) continue;
      ++forbidden;
      options.apart = {};
      options.apart.add(a, b);
      const auto filling = flips::best_meeting(flips::BeamBalls(beam), code, options);
      if (!filling) continue;
      EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "");
      EXPECT_FALSE(flips::scars_of(filling->mesh, boundary).has(a, b));
    }
  EXPECT_GT(forbidden, 0);
}

TEST(Meeting, SymmetricCollarsFillWhatHasASymmetricMesh) {
  // The single hexahedron is the only ball known: all else is symmetric collar.
  const Beam cube = balls(limits(6, 1, 1), 1);
  flips::MeetingOptions options{.collars = limits(20, 1'000, 1'000), .max_collar = 8};
  std::vector<std::pair<canon::Code, std::size_t>> cases;
  for (const auto& [text, least] : {std::pair("q1:08a5df", 1U),
                                    {"q1:022972977f", 2U},
                                    {"q1:088a2a5ddf7f", 4U},
                                    {"q1:02228a5d777f", 3U}})
    cases.emplace_back(canon::from_text(text).value(), least);
  // 38 quads, more than states of a Beam may have.
  cases.emplace_back(support::code_of_bar(9), 9);
  for (const auto& [code, least] : cases) {
    options.collars.max_quads = std::max(20, int{code.quads});
    const auto filling = flips::best_symmetric_meeting(flips::BeamBalls(cube), code, options);
    ASSERT_TRUE(filling.has_value()) << canon::to_text(code);
    EXPECT_EQ(filling->mesh.hexahedra.size(), least) << canon::to_text(code);
    EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "") << canon::to_text(code);
  }
}

TEST(Meeting, SymmetricCollarsMeetBalls) {
  // Balls of at most 4 hexahedra: of 9 the collar takes off at least 5.
  const Beam beam = balls(limits(20, 50, 5'000), 4);
  flips::MeetingOptions options{.collars = limits(28, 100, 300), .max_collar = 10};
  support::Random random(62);
  int found = 0;
  int tried = 0;
  int without = 0;
  for (int i = 0; tried < 12 && i < 2'000; ++i) {
    const auto code = random_code(7, 3, 20, random);
    if (flips::involutions_of(canon::decode(code).value()).empty()) {
      if (++without <= 10) {
        EXPECT_FALSE(
            flips::best_symmetric_meeting(flips::BeamBalls(beam), code, options).has_value());
      }
      continue;
    }
    ++tried;
    const auto filling = flips::best_symmetric_meeting(flips::BeamBalls(beam), code, options);
    if (!filling) continue;
    ++found;
    EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "") << canon::to_text(code);
    options.below = static_cast<int>(filling->mesh.hexahedra.size());
    EXPECT_FALSE(flips::best_symmetric_meeting(flips::BeamBalls(beam), code, options).has_value());
    options.below = 1 << 14;
  }
  EXPECT_GT(found, 3);
  EXPECT_GT(without, 0);
}

TEST(Meeting, SymmetricCollarsKeepApartWhatMustBe) {
  const Beam beam = balls(limits(20, 50, 20'000), 12);
  const auto code = canon::from_text("q1:088a2a5ddf7f").value();
  const auto boundary = canon::decode(code).value();
  flips::MeetingOptions options{.collars = limits(24, 100, 1'000), .max_collar = 10};
  const auto free = flips::best_symmetric_meeting(flips::BeamBalls(beam), code, options);
  ASSERT_TRUE(free.has_value());
  const flips::Scars scars = flips::scars_of(free->mesh, boundary);
  int larger = 0;
  int kept_by_none = 0;
  for (complex::Vertex a = 0; a < boundary.vertices(); ++a)
    for (complex::Vertex b = 0; b < a; ++b) {
      if ((flips::relation_of_quads(boundary)[a] & flips::bit(b)) != 0) continue;
      options.apart = {};
      options.apart.add(a, b);
      const auto filling = flips::best_symmetric_meeting(flips::BeamBalls(beam), code, options);
      const auto turns = flips::automorphisms_of(code);
      if (std::none_of(turns.begin(), turns.end(), [&](const auto& each) {
            bool is_identity = true;
            bool is_own_inverse = true;
            for (complex::Vertex v = 0; v < boundary.vertices(); ++v) {
              is_identity = is_identity && each.label[v] == v;
              is_own_inverse = is_own_inverse && each.label[each.label[v]] == v;
            }
            return is_own_inverse && !is_identity &&
                   options.apart.renamed(each.label) == options.apart;
          })) {
        ++kept_by_none;
        EXPECT_FALSE(filling.has_value());
      }
      if (!filling) continue;
      EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "");
      EXPECT_TRUE(flips::scars_of(filling->mesh, boundary).is_disjoint_from(options.apart));
      if (!scars.is_disjoint_from(options.apart)) ++larger;
    }
  EXPECT_GT(larger + kept_by_none, 0) << larger << ' ' << kept_by_none;
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
