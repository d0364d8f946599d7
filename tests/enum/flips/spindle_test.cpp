// Claim. Balls and collars of the default widths find a mesh of the octagonal spindle.
// Oracle. The mesh is checked by sets. Fewer than 40 hexahedra would be new (hextreme.eu, 2019).
#include <gtest/gtest.h>

#include "enum/flips/meeting.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;

TEST(Spindle, IsFilled) {
  flips::BeamOptions options;
  options.max_quads = 22;
  options.fronts_per_class = 20;
  options.fronts_per_level = 100'000;
  options.threads = parallel::available_threads();
  flips::Beam balls(flips::canonical_state(flips::single_hexahedron()).state, options);
  while (balls.level() + 1 < 38 && balls.expand_level() > 0) {
  }
  flips::MeetingOptions meeting{.collars = options, .max_collar = 10};
  meeting.collars.fronts_per_level = 3'000;
  const auto code = canon::from_text("q1:088a577f").value();
  const auto filling = flips::best_meeting(flips::BeamBalls(balls), code, meeting);
  ASSERT_TRUE(filling.has_value());
  EXPECT_EQ(support::fault_of_filling(filling->mesh, code), "");
  RecordProperty("hexahedra", static_cast<int>(filling->mesh.hexahedra.size()));
  EXPECT_GE(filling->mesh.hexahedra.size(), 21U);
  EXPECT_LE(filling->mesh.hexahedra.size(), 48U);
}

}  // namespace
