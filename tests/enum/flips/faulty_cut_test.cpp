// Claim. Faulty cuts are meshes of their boundary with as many faults as they say, no more than
// asked for and none too large, the same for any number of threads; without collars, all kinds that
// there are come if enough are asked for.
// Oracle. Faults and the boundary by sets; all unions of a few balls along all small discs, dart by
// dart.
#include "enum/flips/faulty_cut.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "enum/canon/code.hpp"
#include "tests/enum/flips/ball_unions.hpp"
#include "tests/enum/flips/faults.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;

flips::FaultyCutOptions cut_limits(int below, std::size_t count) {
  return {.collars = {.max_quads = 20, .fronts_per_class = 3, .fronts_per_level = 60},
          .max_collar = 3,
          .max_circle = 8,
          .max_interior = 2,
          .cavities = 10,
          .wanted = {.price = 2, .below = below, .count = count}};
}

TEST(FaultyCut, KnowsItsFaults) {
  support::expect_faults_are_known(cut_limits, flips::faulty_cuts);
}

TEST(FaultyCut, HasAllKindsThatTwoBallsMake) {
  const auto beam = support::grown(14, 2, 9, 5);
  const auto wanted = static_cast<std::size_t>(support::share_of(8, 2));
  std::map<canon::Code, support::Kinds> expected;
  support::for_each_match(support::all_balls(beam), 8, 1, [&](const support::Match& match) {
    if (match.boundary_quads() != 16 || match.may_be_glued()) return;
    const auto boundary = match.boundary();
    if (!boundary || !boundary->is_three_connected()) return;
    const auto code = canon::canonical_form(*boundary).code;
    if (expected.size() == wanted && !expected.contains(code)) return;
    const auto cells = match.cells();
    if (support::has_facet_thrice(cells)) return;
    expected[code].emplace(support::faults_of(cells), static_cast<int>(cells.size()));
  });
  std::size_t all = 0;
  for (const auto& [code, kinds] : expected) {
    auto options = cut_limits(1'000, 500);
    options.max_collar = 0;
    options.cavities = 1;
    options.max_interior = 1;
    EXPECT_EQ(support::kinds_of(flips::faulty_cuts(beam, code, options)), kinds)
        << canon::to_text(code);
    all += kinds.size();
  }
  EXPECT_EQ(expected.size(), wanted);
  EXPECT_GE(all, 2 * wanted);
}

TEST(FaultyCut, GivesDifferentOnesForAnotherSeed) {
  const auto beam = support::grown(20, 10, 1'000, 24);
  std::set<std::vector<complex::Hexahedron>> meshes;
  std::size_t all = 0;
  for (const auto& code : beam.codes()) {
    if (code.quads < 16) continue;
    for (const std::uint64_t seed : {1U, 2U}) {
      auto options = cut_limits(60, 10);
      options.collars.seed = seed;
      for (const auto& [mesh, faults] : flips::faulty_cuts(beam, code, options)) {
        meshes.insert(mesh.hexahedra);
        ++all;
      }
    }
    if (all >= 60) break;
  }
  EXPECT_GE(all, 60U);
  EXPECT_GT(meshes.size(), 3 * all / 4);
}

}  // namespace
