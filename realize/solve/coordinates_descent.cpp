#include "realize/solve/coordinates_descent.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <numeric>
#include <utility>

namespace hexatlas::solve {
namespace {

using Numbers = std::vector<double>;

double dot(const Numbers& a, const Numbers& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void add(Numbers& to, double factor, const Numbers& v) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * v[i];
}

/// The last steps and changes of the gradient, as an estimate of the inverse second derivative.
class History {
 public:
  void record(Numbers step, Numbers change) {
    const double curvature = dot(step, change);
    if (curvature <= 1e-12 * dot(change, change)) return;
    if (pairs_.size() == kPairs) pairs_.pop_front();
    pairs_.push_back({std::move(step), std::move(change), 1 / curvature});
  }

  [[nodiscard]] Numbers direction(const Numbers& gradient) const {
    Numbers result = gradient;
    Numbers along(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      along[i] = pairs_[i].inverse_curvature * dot(pairs_[i].step, result);
      add(result, -along[i], pairs_[i].change);
    }
    const double scale = pairs_.empty() ? 0.1 / std::max(std::sqrt(dot(gradient, gradient)), 1e-100)
                                        : 1 / (pairs_.back().inverse_curvature *
                                               dot(pairs_.back().change, pairs_.back().change));
    for (double& x : result) x *= -scale;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      add(result, -along[i] - pairs_[i].inverse_curvature * dot(pairs_[i].change, result),
          pairs_[i].step);
    return result;
  }

  [[nodiscard]] bool empty() const noexcept { return pairs_.empty(); }
  void forget() { pairs_.clear(); }

 private:
  static constexpr std::size_t kPairs = 8;
  struct Pair {
    Numbers step, change;
    double inverse_curvature;
  };
  std::deque<Pair> pairs_;
};

/// `value(at, gradient)`; ends after `steps`, at a value of zero, or where no step helps.
template <class Value>
void minimize(const Value& value, Numbers& at, int steps) {
  Numbers gradient(at.size());
  double now = value(at, gradient);
  History history;
  for (int step = 0; step < steps && now > 0; ++step) {
    Numbers direction = history.direction(gradient);
    double slope = dot(direction, gradient);
    if (slope >= 0) {
      history.forget();
      direction = history.direction(gradient);
      slope = dot(direction, gradient);
    }
    Numbers next = at;
    Numbers next_gradient(at.size());
    double length = 1;
    double then = 0;
    for (int halving = 0;; ++halving, length /= 3) {
      next = at;
      add(next, length, direction);
      then = value(next, next_gradient);
      if (then <= now + 1e-4 * length * slope) break;
      if (halving < 12) continue;
      if (history.empty()) return;
      history.forget();
      then = now;
      next = at;
      next_gradient = gradient;
      break;
    }
    if (now - then < 1e-10 * std::abs(now) && !history.empty()) return;
    Numbers moved = next;
    add(moved, -1, at);
    Numbers change = next_gradient;
    add(change, -1, gradient);
    history.record(std::move(moved), std::move(change));
    at = std::move(next);
    gradient = std::move(next_gradient);
    now = then;
  }
}

}  // namespace

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

CoordinateDescent::CoordinateDescent(CoordinateSlacks& slacks, int vertices, int steps)
    : slacks_(slacks), angles_(3 * static_cast<std::size_t>(vertices)), steps_(steps) {}

Numbers CoordinateDescent::points() const {
  Numbers result(angles_.size());
  std::transform(angles_.begin(), angles_.end(), result.begin(),
                 [](double angle) { return std::sin(angle); });
  return result;
}

void CoordinateDescent::start_anywhere(std::mt19937_64& random) {
  for (double& angle : angles_) angle = (uniform(random) - 0.5) * std::numbers::pi;
}

/// `weigh(slacks, weights)` returns the value and sets its derivatives by the slacks.
template <class Weigh>
void CoordinateDescent::descend(const Weigh& weigh) {
  Numbers points(angles_.size());
  Numbers weights;
  const auto value = [&](const Numbers& angles, Numbers& gradient) {
    for (std::size_t i = 0; i < angles.size(); ++i) points[i] = std::sin(angles[i]);
    const auto slacks = slacks_.at(points);
    weights.resize(slacks.size());
    const double result = weigh(slacks, weights);
    std::fill(gradient.begin(), gradient.end(), 0.0);
    slacks_.add_derivative(weights, gradient);
    for (std::size_t i = 0; i < angles.size(); ++i) gradient[i] *= std::cos(angles[i]);
    return result;
  };
  minimize(value, angles_, steps_);
}

bool CoordinateDescent::satisfy() {
  for (const double margin : {0.25, 0.05, 0.01}) {
    descend([margin](std::span<const double> slacks, Numbers& weights) {
      double sum = 0;
      for (std::size_t i = 0; i < slacks.size(); ++i) {
        const double missing = std::max(margin - slacks[i], 0.0);
        sum += missing * missing;
        weights[i] = -2 * missing;
      }
      return sum;
    });
    if (least_slack() > 0) return true;
  }
  return false;
}

void CoordinateDescent::widen() {
  const double first = 4 / std::max(least_slack(), 1e-4);
  for (const double sharpness : {first, 3 * first, 9 * first, 27 * first})
    descend([sharpness](std::span<const double> slacks, Numbers& weights) {
      const double least = *std::min_element(slacks.begin(), slacks.end());
      double sum = 0;
      for (std::size_t i = 0; i < slacks.size(); ++i)
        sum += weights[i] = std::exp(sharpness * (least - slacks[i]));
      for (double& w : weights) w /= -sum;
      // A constant keeps the value positive, as `minimize` expects.
      return 1e3 - least + std::log(sum) / sharpness;
    });
}

double CoordinateDescent::least_slack() {
  const auto slacks = slacks_.at(points());
  return slacks.empty() ? 0 : *std::min_element(slacks.begin(), slacks.end());
}

}  // namespace hexatlas::solve
