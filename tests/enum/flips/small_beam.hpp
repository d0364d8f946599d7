#pragma once
/// \file
/// Small beams for tests.

#include "enum/flips/beam.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::support {

/// From the single hexahedron, so many levels far.
inline flips::Beam grown(int max_quads, std::size_t per_class, std::size_t per_level, int levels) {
  flips::BeamOptions options;
  options.max_quads = max_quads;
  options.fronts_per_class = per_class;
  options.fronts_per_level = per_level;
  flips::Beam beam(flips::canonical_state(flips::single_hexahedron()).state, options);
  while (beam.level() < levels && beam.expand_level() > 0) {
  }
  return beam;
}

/// What the boundary adds to the scars of its fronts by these options.
inline int price_in_scars(const canon::Code& code, const flips::BeamOptions& options) {
  const auto boundary = canon::decode(code).value();
  return static_cast<int>(options.scars_per_quad) * code.quads -
         static_cast<int>(options.scars_per_irregularity) * irregularity_of(boundary) +
         static_cast<int>(options.scars_per_simple_zone) * simple_zones_of(boundary);
}

}  // namespace hexatlas::support
