#include "realize/untangle/descent.hpp"

#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace hexatlas::untangle {
namespace {

constexpr std::size_t kPairs = 8;
constexpr double kSufficientDecrease = 1e-4;
constexpr double kCurvature = 0.9;
constexpr double kFirstStep = 1e-2;  ///< of a variable, in the mean
constexpr int kMaxTrials = 40;       ///< of a step length
constexpr std::size_t kStepsBack = 5;

/// The last steps and the changes of the gradient over them.
class Memory {
 public:
  void add(const Eigen::VectorXd& step, const Eigen::VectorXd& change) {
    const double curvature = step.dot(change);
    if (!(curvature > 1e-14 * step.norm() * change.norm())) return;
    if (pairs_.size() == kPairs) pairs_.pop_front();
    pairs_.push_back({step, change, 1 / curvature});
  }
  void clear() { pairs_.clear(); }
  [[nodiscard]] bool empty() const { return pairs_.empty(); }

  /// Minus the approximate inverse of the Hessian times the gradient.
  [[nodiscard]] Eigen::VectorXd direction(const Eigen::VectorXd& gradient) const {
    Eigen::VectorXd q = -gradient;
    std::vector<double> alpha(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      alpha[i] = pairs_[i].weight * pairs_[i].step.dot(q);
      q -= alpha[i] * pairs_[i].change;
    }
    if (!pairs_.empty()) q /= pairs_.back().weight * pairs_.back().change.squaredNorm();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const double beta = pairs_[i].weight * pairs_[i].change.dot(q);
      q += (alpha[i] - beta) * pairs_[i].step;
    }
    return q;
  }

 private:
  struct Pair {
    Eigen::VectorXd step, change;
    double weight;
  };
  std::deque<Pair> pairs_;
};

struct Place {
  Eigen::VectorXd x, gradient;
  double value = 0;
};

/// Moves `at` along the direction; false if no step was found that decreases the value.
bool step_along(const Objective& objective, const Eigen::VectorXd& direction, double length,
                Place& at, int max_evaluations, int& evaluations) {
  const double slope = at.gradient.dot(direction);
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  Place trial;
  Place best = at;
  for (int i = 0; i < kMaxTrials && evaluations < max_evaluations; ++i) {
    trial.x = at.x + length * direction;
    trial.value = objective(trial.x, trial.gradient);
    ++evaluations;
    const bool decreases = std::isfinite(trial.value) && trial.gradient.allFinite() &&
                           trial.value <= at.value + kSufficientDecrease * length * slope;
    if (!decreases) {
      high = length;
    } else {
      std::swap(best, trial);
      if (best.gradient.dot(direction) >= kCurvature * slope) break;
      low = length;
    }
    length = std::isinf(high) ? 2 * length : 0.5 * (low + high);
  }
  const bool found = best.value < at.value;
  if (found) std::swap(at, best);
  return found;
}

}  // namespace

Descent descend(const Objective& objective, Eigen::VectorXd& x, const DescentLimits& limits) {
  Place at;
  at.x = x;
  at.value = objective(at.x, at.gradient);
  Descent result{at.value, at.value, 1};
  if (!std::isfinite(at.value) || !at.gradient.allFinite()) return result;
  Memory memory;
  std::deque<double> values{at.value};
  while (result.evaluations < limits.evaluations) {
    const double steepness = at.gradient.norm();
    if (!(steepness > 0)) break;
    Eigen::VectorXd direction = memory.direction(at.gradient);
    const bool is_first = memory.empty();
    if (!(direction.dot(at.gradient) < 0) || !direction.allFinite()) {
      memory.clear();
      direction = -at.gradient;
    }
    const Place before = at;
    const double length =
        is_first ? kFirstStep * std::sqrt(static_cast<double>(x.size())) / steepness : 1;
    if (!step_along(objective, direction, length, at, limits.evaluations, result.evaluations)) {
      if (is_first) break;
      memory.clear();  // once more, along the gradient
      continue;
    }
    memory.add(at.x - before.x, at.gradient - before.gradient);
    values.push_back(at.value);
    if (values.size() > kStepsBack) values.pop_front();
    if (values.size() == kStepsBack &&
        values.front() - at.value <= limits.relative_decrease * std::abs(at.value))
      break;
  }
  x = at.x;
  result.value = at.value;
  return result;
}

}  // namespace hexatlas::untangle
