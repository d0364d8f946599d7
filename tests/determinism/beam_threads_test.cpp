// Claim. A beam gives the same fronts, in the same order, and the same signature for any number of
// threads; so do the meetings and the meshes made from it.
// Oracle. The run on one thread.
#include <gtest/gtest.h>

#include <vector>

#include "enum/flips/meeting.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using flips::Beam;
using flips::BeamOptions;

struct Trace {
  std::vector<std::vector<flips::FrontId>> frontiers;
  std::vector<std::tuple<canon::Code, int, flips::FrontId, flips::Scars>> records;
  std::uint64_t candidates = 0;
  std::vector<complex::Hexahedron> mesh;
  friend bool operator==(const Trace&, const Trace&) = default;
};

Trace trace(BeamOptions options, int threads, int levels) {
  options.threads = threads;
  Beam beam(flips::canonical_state(flips::single_hexahedron()).state, options);
  Trace result;
  while (beam.level() < levels && beam.expand_level() > 0)
    result.frontiers.emplace_back(beam.frontier().begin(), beam.frontier().end());
  for (const auto& code : beam.codes())
    for (const auto& record : beam.fronts_of(code))
      result.records.emplace_back(code, record.level, record.id, record.scars);
  result.candidates = beam.candidates();
  const auto filling =
      flips::best_meeting(flips::BeamBalls(beam), canon::from_text("q1:088a2a5ddf7f").value(),
                          {.collars = options, .max_collar = 3});
  if (filling) result.mesh = filling->mesh.hexahedra;
  return result;
}

TEST(BeamThreads, DoNotChangeTheResult) {
  BeamOptions wide;
  wide.max_quads = 18;
  wide.fronts_per_class = 1'000'000;
  wide.fronts_per_level = 1'000'000;
  BeamOptions narrow;
  narrow.max_quads = 20;
  narrow.fronts_per_class = 3;
  narrow.fronts_per_level = 1'500;
  BeamOptions plain = narrow;
  plain.use_dominance = false;
  for (const auto& [options, levels] :
       {std::pair(wide, 20), std::pair(narrow, 20), std::pair(plain, 18)}) {
    const Trace one = trace(options, 1, levels);
    ASSERT_GT(one.records.size(), 100U);
    EXPECT_FALSE(one.mesh.empty());
    for (const int threads : {1, 2, 3, 5})
      EXPECT_TRUE(trace(options, threads, levels) == one) << threads;
  }
}

}  // namespace
