#include "realize/solve/coordinates.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <vector>

#include "realize/conditions/points.hpp"
#include "realize/solve/coordinates_clauses.hpp"
#include "realize/solve/coordinates_descent.hpp"
#include "realize/solve/coordinates_repair.hpp"
#include "realize/solve/coordinates_slack.hpp"

namespace hexatlas::solve {
namespace {

using certificate::Condition;
using certificate::Realization;

/// Enough to leave a degenerate optimum, few enough to go on to a finer rounding.
constexpr int kFirstRepairSteps = 20;

class CoordinateSearch {
 public:
  CoordinateSearch(const complex::Triangulation& triangulation, std::span<const int> signs,
                   Condition condition, const SearchEffort& effort)
      : triangulation_(triangulation),
        signs_(signs),
        condition_(condition),
        effort_(effort),
        judge_(triangulation, signs, condition),
        repair_(judge_, condition),
        random_(effort.seed) {}

  std::optional<Realization> run(const chirotope::Signs& known) {
    std::optional<Realization> best = first(known);
    if (best) shrink(*best);
    return best;
  }

 private:
  std::optional<Realization> first(const chirotope::Signs& known) {
    const SignConditions conditions = sign_conditions(triangulation_, signs_, condition_, known);
    if (conditions.contradictory) return std::nullopt;
    CoordinateSlacks slacks(conditions, condition_);
    CoordinateDescent descent(slacks, triangulation_.vertices, effort_.descent_steps);
    for (int start = 0; start < effort_.starts; ++start) {
      descent.start_anywhere(random_);
      if (!descent.satisfy()) continue;
      // Optimal points may be degenerate, so that the points before are rounded too.
      const std::vector<double> satisfying = descent.points();
      descent.widen();
      for (const std::vector<double>& points : {descent.points(), satisfying})
        for (std::int64_t extent = 4; extent < certificate::kCoordinateBound; extent *= 4)
          if (auto result = repair_.repaired(points, extent, kFirstRepairSteps, random_))
            return result;
    }
    return std::nullopt;
  }

  /// Each start is tried in cubes smaller than the best so far, until one is too small.
  void shrink(Realization& best) {
    const SignConditions conditions = sign_conditions(triangulation_, signs_, condition_, {});
    CoordinateSlacks slacks(conditions, condition_);
    CoordinateDescent descent(slacks, triangulation_.vertices, effort_.descent_steps);
    int shrunk = 0;
    for (int start = 0; start < effort_.starts && shrunk < effort_.shrink_starts; ++start) {
      if (extent_of(best) == 1) return;
      descent.start_anywhere(random_);
      if (!descent.satisfy()) continue;
      ++shrunk;
      descent.widen();
      const std::vector<double> points = descent.points();
      for (bool smaller = true; smaller && extent_of(best) > 1;) {
        const std::int64_t extent = extent_of(best);
        smaller = false;
        for (const std::int64_t target : {extent * 3 / 4, extent - 1}) {
          auto result = repair_.repaired(points, target, effort_.repair_steps, random_);
          if (!result) continue;
          best = *result;
          smaller = true;
          break;
        }
      }
    }
  }

  const complex::Triangulation& triangulation_;
  std::span<const int> signs_;
  Condition condition_;
  SearchEffort effort_;
  conditions::PointsJudge judge_;
  CoordinateRepair repair_;
  std::mt19937_64 random_;
};

}  // namespace

std::optional<Realization> find_realization(const complex::Triangulation& triangulation,
                                            std::span<const int> signs, Condition condition,
                                            const SearchEffort& effort) {
  return CoordinateSearch(triangulation, signs, condition, effort).run({});
}

std::optional<Realization> find_realization_of(const chirotope::Signs& chirotope,
                                               const complex::Triangulation& triangulation,
                                               std::span<const int> signs, Condition condition,
                                               const SearchEffort& effort) {
  return CoordinateSearch(triangulation, signs, condition, effort).run(chirotope);
}

std::int64_t extent_of(const Realization& points) {
  std::int64_t extent = 0;
  for (const certificate::IntegerPoint& point : points)
    for (const std::int64_t x : point) extent = std::max(extent, std::abs(x));
  return extent;
}

}  // namespace hexatlas::solve
