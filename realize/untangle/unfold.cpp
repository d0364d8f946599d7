#include "realize/untangle/unfold.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "realize/untangle/energies.hpp"

namespace hexatlas::untangle {
namespace {

constexpr int kMaxSteps = 60;
constexpr double kStepsAtLeast = 20;   ///< there should be work for so many
constexpr int kStepsWhenUnfolded = 4;  ///< taken with all determinants positive, for the shape
constexpr DescentLimits kPerStep{300, 1e-7};

/// The next epsilon: Foldover-free maps (energies.hpp), section 3.
double next_epsilon(double epsilon, double least, const Descent& descent) {
  const double progress = 1 - descent.value / descent.first;
  const double sigma = std::max(0.1, std::isfinite(progress) ? progress : 0);
  if (least > 0) return (1 - sigma) * epsilon;
  const double root = std::hypot(least, epsilon);
  return (1 - sigma * root / (root - least)) * epsilon;
}

}  // namespace

Least least_of(const Problem& problem, const Variables& x) {
  Least result{std::numeric_limits<double>::infinity(), 1};
  problem.for_each_sample(x, [&result](std::size_t, std::size_t, const Eigen::Matrix3d& j) {
    result.determinant = std::min(result.determinant, j.determinant());
    result.scaled = std::min(result.scaled, scaled_determinant(j));
  });
  return result;
}

bool unfold(const Problem& problem, double lambda, Variables& x, Work& work) {
  DescentLimits per_step = kPerStep;
  const double evaluations = work.left() / static_cast<double>(problem.cells());
  per_step.evaluations =
      static_cast<int>(std::clamp(evaluations / kStepsAtLeast, 10.0, 1.0 * per_step.evaluations));
  double epsilon = 1;
  double least = least_of(problem, x).determinant;
  int unfolded_steps = 0;
  for (int step = 0; step < kMaxSteps && !work.is_done(problem); ++step) {
    const Descent descent = work.minimize(problem, Foldover{epsilon, lambda}, x, per_step);
    least = least_of(problem, x).determinant;
    epsilon = next_epsilon(epsilon, least, descent);
    unfolded_steps = least > 0 ? unfolded_steps + 1 : 0;
    if (unfolded_steps == kStepsWhenUnfolded || !(epsilon > 1e-14)) break;
  }
  return least > 0;
}

bool raise_above_zero(const Problem& problem, Variables& x, Work& work) {
  Least least = least_of(problem, x);
  for (double rate = 4; rate < 512 && !(least.determinant > 0) && !work.is_done(problem);
       rate *= 1.3) {
    const double epsilon = std::max(std::abs(least.determinant), 1e-9);
    const ScaledExponential energy{least.scaled, rate, 1e-4, {epsilon, 1}};
    static_cast<void>(work.minimize(problem, energy, x, kPerStep));
    least = least_of(problem, x);
  }
  return least.determinant > 0;
}

}  // namespace hexatlas::untangle
