#pragma once
/// \file
/// Minimization of a smooth function of many variables. Private to realize/untangle.
///
/// Method. L-BFGS with 8 pairs (Liu and Nocedal, "On the limited memory BFGS method for large scale
/// optimization", Mathematical Programming 45, 1989); the step is found by bisection for the weak
/// Wolfe conditions (Lewis and Overton, "Nonsmooth optimization via quasi-Newton methods",
/// Mathematical Programming 141, 2013), which also backs off from where the function is infinite.
///
/// Deterministic; ends after a number of evaluations, never by the clock.

#include <Eigen/Core>
#include <functional>

namespace hexatlas::untangle {

/// The value at x, with the gradient there; not finite outside of the domain.
using Objective = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct DescentLimits {
  int evaluations = 100;
  double relative_decrease = 1e-9;  ///< ends when five steps together bring less than this
};

struct Descent {
  double first = 0;  ///< value at the start
  double value = 0;
  int evaluations = 0;
};

/// Moves x to a point with a value not above the first. If the first is not finite, x stays.
[[nodiscard]] Descent descend(const Objective& objective, Eigen::VectorXd& x,
                              const DescentLimits& limits);

}  // namespace hexatlas::untangle
