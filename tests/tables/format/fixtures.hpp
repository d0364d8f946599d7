#pragma once
/// \file
/// Tables to test with: the meshes of an exhaustive beam over boundaries of at most 16 quads.

#include <string>
#include <vector>

#include "enum/flips/meeting.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::fixtures {

inline std::vector<format::TableRow> rows(int max_quads = 16, int levels = 12) {
  flips::BeamOptions options;
  options.max_quads = max_quads;
  options.fronts_per_class = 10;
  options.fronts_per_level = 5'000;
  flips::Beam beam(flips::canonical_state(flips::single_hexahedron()).state, options);
  while (beam.level() < levels && beam.expand_level() > 0) {
  }
  std::vector<format::TableRow> result;
  for (const auto& code : beam.codes())
    result.push_back({code, flips::filling_of(beam, beam.fronts_of(code).front().id).mesh, 1});
  return result;
}

inline std::vector<format::TableRowName> names() {
  return {{"two-cubes", canon::from_text("q1:022972977f").value()},
          {"cube", canon::from_text("q1:08a5df").value()}};
}

}  // namespace hexatlas::fixtures
