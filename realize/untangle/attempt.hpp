#pragma once
/// \file
/// From a start to the best placement that was met on the way. Private to realize/untangle.

#include <cstdint>
#include <vector>

#include "realize/untangle/placement.hpp"
#include "realize/untangle/work.hpp"

namespace hexatlas::untangle {

/// The cells with a free point, in coordinates in which a cell has about unit volume.
struct Task {
  std::vector<Cell> cells;
  std::vector<std::uint8_t> is_free;
};

/// Unfolds from these points; better than the start or the start itself.
[[nodiscard]] Placement unfolded(const Task& task, const Points& start, double lambda, Work& work);

/// Unfolds from several harmonic starts and takes the best placement.
[[nodiscard]] Placement unfolded_from_many(const Task& task, const Points& start, Work& work);

/// Raises the least scaled Jacobian; never worse than the start.
[[nodiscard]] Placement raised(const Task& task, const Placement& start, Work& work);

}  // namespace hexatlas::untangle
