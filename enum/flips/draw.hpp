#pragma once
/// \file
/// One of the balls that fit in place of a sub-ball, drawn at random: the step of a walk.

#include <cstddef>
#include <optional>
#include <vector>

#include "enum/core/random.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/exchange.hpp"
#include "enum/flips/sub_ball.hpp"
#include "enum/flips/walk.hpp"

namespace hexatlas::flips {

inline constexpr int kMostClimb = 10;  ///< hexahedra that one exchange may add

/// Hexahedra of the ball that a step exchanges.
[[nodiscard]] std::size_t size_of_exchange(core::Random& random);

/// A place of `sums`, each with the probability of its weight, by which the sum there is greater
/// than the one before; nullopt with that of the weight `to_stay`, with which the sums begin.
[[nodiscard]] std::optional<std::size_t> drawn_by_weight(const std::vector<double>& sums,
                                                         double to_stay, core::Random& random);

/// An exchange, and what it does to the number of faults.
struct Draw {
  Fit fit;
  int faults = 0;
};

/// One of the balls that fit in place of the sub-ball, in all positions, drawn by their weights;
/// nullopt for the sub-ball itself, which has weight 1. Mostly nullopt, too, for a ball with as
/// many hexahedra and the same scars: nearly always it is the sub-ball again, and most draws are
/// such. In a leap, only balls of its kind are drawn. `sums` is made use of.
[[nodiscard]] std::optional<Draw> draw(const SubBall& ball, const Beam& balls,
                                       const Climate& climate, std::optional<Walk::Leap> leap,
                                       core::Random& random, std::vector<double>& sums);

}  // namespace hexatlas::flips
