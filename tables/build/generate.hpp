#pragma once
/// \file
/// Making a table: which boundaries, and the smallest mesh found for each.
///
/// Method. One beam of balls grown from the single hexahedron; then for each boundary collars
/// inwards until they meet a ball (enum/flips/meeting.hpp). Boundaries without a mesh after the
/// first round are tried again with wider collars, round by round.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/flips/beam.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::build {

/// All 3-connected quadrangulations with an even number of quads up to `max_quads` that flips
/// reach from the cube through 3-connected ones with at most max_quads + 6 quads, ascending.
/// Requires max_quads <= 18.
/// Not promised: completeness; for up to 14 quads the numbers are those of OEIS A007022 (1, 1,
/// 3, 11, 58), which a test checks.
[[nodiscard]] std::vector<canon::Code> three_connected_codes(int max_quads);

/// One round of collars.
struct CollarRound {
  int max_collar = 10;
  int max_quads = 22;
  std::size_t fronts_per_class = 20;
  std::size_t fronts_per_level = 3'000;
};

struct GenerateOptions {
  flips::BeamOptions balls;
  int max_ball = 60;  ///< hexahedra of a ball
  std::vector<CollarRound> rounds;
  /// Rounds from this one on are only for boundaries without a mesh.
  std::size_t rounds_for_all = 1;
};
/// The settings of `hexatlas table build`.
[[nodiscard]] GenerateOptions default_generate_options();

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
/// Deterministic for given options, for any number of threads.
/// Throws ResourceFailure if a beam outgrows its memory limit.
[[nodiscard]] Generated generate(const std::vector<canon::Code>& boundaries,
                                 const GenerateOptions& options,
                                 const std::function<void(const Progress&)>& report);

}  // namespace hexatlas::build
