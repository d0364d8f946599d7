#pragma once
/// \file
/// Descents within a limit of work. Private to realize/untangle.

#include <algorithm>

#include "realize/untangle/descent.hpp"
#include "realize/untangle/problem.hpp"

namespace hexatlas::untangle {

/// Counts evaluations of one cell.
class Work {
 public:
  Work(double limit, int threads) : left_(limit), threads_(threads) {}

  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] int threads() const { return threads_; }
  void spend(double evaluations) { left_ -= evaluations; }
  /// Fewer than ten evaluations of the problem are left.
  [[nodiscard]] bool is_done(const Problem& problem) const {
    return left_ < 10 * static_cast<double>(problem.cells());
  }

  /// Minimizes the sum of `energy` over the samples of the problem from x on.
  template <class F>
  Descent minimize(const Problem& problem, const F& energy, Variables& x, DescentLimits limits) {
    const auto cells = static_cast<double>(std::max<std::size_t>(problem.cells(), 1));
    limits.evaluations = static_cast<int>(
        std::min(static_cast<double>(limits.evaluations), std::max(left_ / cells, 1.0)));
    const Objective objective = [&](const Variables& at, Variables& gradient) {
      return problem.sum(at, energy, threads_, gradient);
    };
    const Descent descent = descend(objective, x, limits);
    spend(descent.evaluations * cells);
    return descent;
  }

 private:
  double left_;
  int threads_;
};

}  // namespace hexatlas::untangle
