#include "realize/untangle/attempt.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "realize/untangle/harmonic.hpp"
#include "realize/untangle/raise.hpp"
#include "realize/untangle/unfold.hpp"

namespace hexatlas::untangle {
namespace {

constexpr int kRounds = 4;  ///< of looking closely at more cells

struct Start {
  std::uint64_t seed;
  double lambda;
};
/// Other harmonic weights, and size against shape.
constexpr std::array<Start, 8> kStarts{
    {{1, 100}, {2, 10}, {3, 1}, {4, 100}, {5, 10}, {6, 100}, {7, 1000}, {8, 0.1}}};

void keep_better(Placement& best, Placement other) {
  if (other.is_better_than(best)) best = std::move(other);
}

/// Looks closely at the cells that are not valid though their corners are positive. Whether there
/// are new ones.
bool look_at_bent(Problem& problem, const Variables& x, int threads) {
  const auto standing = standings_of(problem.points_at(x), problem.all_cells(), threads);
  bool is_new = false;
  for (std::size_t c = 0; c < problem.cells(); ++c) {
    if (standing[c] != Standing::bent && standing[c] != Standing::undecided) continue;
    if (problem.is_looked_at_closely(c)) continue;
    problem.look_closely(c);
    is_new = true;
  }
  return is_new;
}

}  // namespace

Placement unfolded(const Task& task, const Points& start, double lambda, Work& work) {
  Problem problem(start, task.cells, task.is_free);
  Variables x = problem.variables_of(start);
  Placement best = judged(start, task.cells, work.threads());
  if (problem.variables() == 0) return best;
  for (int round = 0; round < kRounds; ++round) {
    const bool is_unfolded = unfold(problem, lambda, x, work) || raise_above_zero(problem, x, work);
    keep_better(best, judged(problem.points_at(x), task.cells, work.threads()));
    if (best.not_valid == 0 || !is_unfolded || work.is_done(problem)) break;
    if (!look_at_bent(problem, x, work.threads())) break;
  }
  return best;
}

Placement unfolded_from_many(const Task& task, const Points& start, Work& work) {
  std::vector<Placement> placements(kStarts.size());
  const double share = work.left() / static_cast<double>(kStarts.size() + 1);
  std::vector<double> left(kStarts.size(), share);
  parallel::parallel_for(work.threads(), kStarts.size(), [&](std::size_t i) {
    Work own(share, 1);
    Points points = start;
    place_harmonically(points, task.cells, task.is_free, kStarts[i].seed);
    placements[i] = unfolded(task, points, kStarts[i].lambda, own);
    left[i] = own.left();
  });
  Placement best = std::move(placements[0]);
  for (std::size_t i = 1; i < placements.size(); ++i) keep_better(best, std::move(placements[i]));
  for (const double l : left) work.spend(share - l);
  return best;
}

Placement raised(const Task& task, const Placement& start, Work& work) {
  Problem problem(start.points, task.cells, task.is_free);
  Variables x = problem.variables_of(start.points);
  if (problem.variables() == 0) return start;
  raise(problem, x, work);
  Placement best = start;
  keep_better(best, judged(problem.points_at(x), task.cells, work.threads()));
  return best;
}

}  // namespace hexatlas::untangle
