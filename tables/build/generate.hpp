#pragma once
/// \file
/// Making a table: which boundaries, and the smallest mesh found for each.
///
/// Method. Stage by stage: a beam of balls grown from the single hexahedron, then for each
/// boundary collars inwards until they meet a ball (enum/flips/meeting.hpp). Deep, narrow balls
/// give every boundary some mesh; shallow, wide ones with wide collars give small meshes.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/beam.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::build {

/// All 3-connected quadrangulations with an even number of quads up to `max_quads` that flips
/// reach from the cube through 3-connected ones with at most max_quads + 6, and at least 20, quads,
/// ascending. Requires max_quads <= 18.
/// Complete: their numbers are those of OEIS A007022 (1, 1, 3, 11, 58, 451, 4461 for 6, 8, ..., 18
/// quads), else InternalError.
[[nodiscard]] std::vector<canon::Code> three_connected_codes(int max_quads);

struct Stage {
  flips::BeamOptions balls;
  int max_ball = 0;  ///< hexahedra of a ball
  flips::BeamOptions collars;
  int max_collar = 0;         ///< hexahedra of a collar
  bool only_missing = false;  ///< only for boundaries without a mesh so far
};

/// The settings of `hexatlas table build`, with this seed and number of threads.
[[nodiscard]] std::vector<Stage> default_stages(std::uint64_t seed, int threads);

struct Progress {
  std::string phase;
  std::size_t done = 0, total = 0;
};

struct Generated {
  std::vector<format::TableRow> rows;     ///< ascending by code
  std::vector<canon::Code> without_mesh;  ///< nothing found for these
};

/// The smallest mesh found for each boundary; each one validated under the strict rule and
/// against its boundary before it is returned (InternalError otherwise).
/// Deterministic for given stages, for any number of threads.
/// Throws ResourceFailure if a beam outgrows its memory limit.
[[nodiscard]] Generated generate(const std::vector<canon::Code>& boundaries,
                                 const std::vector<Stage>& stages,
                                 const std::function<void(const Progress&)>& report);

}  // namespace hexatlas::build
