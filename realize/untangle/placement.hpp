#pragma once
/// \file
/// How good places are. Private to realize/untangle.

#include <array>
#include <cstdint>
#include <vector>

#include "realize/untangle/problem.hpp"

namespace hexatlas::untangle {

/// bent: not valid though all corners are positive.
enum class Standing : std::uint8_t { valid, undecided, bent, inverted };

/// By the exact test of realize/exact/jacobian.hpp.
[[nodiscard]] Standing standing_of(const Points& points, const Cell& cell);
/// One per cell.
[[nodiscard]] std::vector<Standing> standings_of(const Points& points,
                                                 const std::vector<Cell>& cells, int threads);

/// The least scaled Jacobian of a cell at its corners.
[[nodiscard]] double scaled_jacobian_of(const Points& points, const Cell& cell);

/// Points and their value: fewer cells that are not valid, then fewer inverted ones, then a greater
/// least scaled Jacobian.
struct Placement {
  Points points;
  std::size_t not_valid = 0;
  std::size_t inverted = 0;
  double least = 0;
  [[nodiscard]] bool is_better_than(const Placement& other) const;
};
[[nodiscard]] Placement judged(Points points, const std::vector<Cell>& cells, int threads);

}  // namespace hexatlas::untangle
