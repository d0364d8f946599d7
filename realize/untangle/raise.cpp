#include "realize/untangle/raise.hpp"

#include <cmath>
#include <cstddef>

#include "realize/untangle/energies.hpp"
#include "realize/untangle/unfold.hpp"

namespace hexatlas::untangle {
namespace {

constexpr int kPowers = 8;  ///< 2, 4, ..., 256
constexpr int kDescentsPerPower = 3;
constexpr int kMaxRetries = 3;
constexpr double kSizeWeight = 1e-3;
constexpr DescentLimits kPerDescent{200, 1e-9};

/// Cells with a determinant that is not positive inside are looked at only at the corners.
void look_where_positive(Problem& problem, const Variables& x) {
  std::vector<std::size_t> not_positive;
  problem.for_each_sample(x, [&](std::size_t c, std::size_t, const Eigen::Matrix3d& j) {
    if (!(scaled_determinant(j) > 0)) not_positive.push_back(c);
  });
  for (const std::size_t c : not_positive) problem.look_at_corners(c);
}

/// Looks closely at the cells that are valid in one place and not in the other; their number.
std::size_t look_at_losses(Problem& problem, const std::vector<Standing>& before,
                           const std::vector<Standing>& after) {
  std::size_t losses = 0;
  for (std::size_t c = 0; c < problem.cells(); ++c) {
    if (before[c] != Standing::valid || after[c] == Standing::valid) continue;
    problem.look_closely(c);
    ++losses;
  }
  return losses;
}

}  // namespace

void raise(Problem& problem, Variables& x, Work& work) {
  look_where_positive(problem, x);
  const auto standings = [&](const Variables& at) {
    return standings_of(problem.points_at(at), problem.all_cells(), work.threads());
  };
  std::vector<Standing> standing = standings(x);
  for (int exponent = 1; exponent <= kPowers; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    int retries = 0;
    for (int i = 0; i < kDescentsPerPower && !work.is_done(problem); ++i) {
      const double least = least_of(problem, x).scaled;
      if (!(least > 0)) return;
      Variables next = x;
      static_cast<void>(
          work.minimize(problem, ScaledPower{least, power, kSizeWeight}, next, kPerDescent));
      std::vector<Standing> after = standings(next);
      if (look_at_losses(problem, standing, after) == 0) {
        x = std::move(next);
        standing = std::move(after);
      } else if (++retries > kMaxRetries) {
        return;
      } else {
        --i;  // once more from the same place, now with the samples inside
      }
    }
  }
}

}  // namespace hexatlas::untangle
