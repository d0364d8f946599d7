#include "realize/solve/coordinates_repair.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace hexatlas::solve {
namespace {

using certificate::IntegerPoint;
using certificate::Realization;

/// One of 0 .. count-1, the same on all machines; the bias is below 2^-60.
std::size_t one_of(std::size_t count, std::mt19937_64& random) {
  return static_cast<std::size_t>(random() % count);
}

Realization rounded(std::span<const double> points, std::int64_t extent) {
  Realization result(points.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    result[i / 3][i % 3] = std::llround(points[i] * static_cast<double>(extent));
  return result;
}

}  // namespace

int CoordinateRepair::violations(const Realization& points) {
  int count = judge_.violations(points);
  if (!jacobian_) return count;
  std::array<double, 24> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = static_cast<double>(points[i / 3][i % 3]);
  for (const double coefficient : coefficients_.at(corners)) count += coefficient <= 0 ? 1 : 0;
  return count;
}

void CoordinateRepair::improve(Realization& points, std::size_t vertex, std::int64_t extent,
                               std::mt19937_64& random) {
  const IntegerPoint from = points[vertex];
  IntegerPoint best = from;
  int fewest = violations(points);
  std::size_t ties = 1;
  for (std::int64_t move = 0; move < 27; ++move) {
    const IntegerPoint to{from[0] + move % 3 - 1, from[1] + move / 3 % 3 - 1,
                          from[2] + move / 9 - 1};
    if (to == from || std::any_of(to.begin(), to.end(),
                                  [extent](std::int64_t x) { return std::abs(x) > extent; }))
      continue;
    points[vertex] = to;
    const int count = violations(points);
    if (count > fewest) continue;
    ties = count < fewest ? 1 : ties + 1;
    fewest = count;
    if (one_of(ties, random) == 0) best = to;
  }
  points[vertex] = best;
}

std::optional<Realization> CoordinateRepair::repaired(std::span<const double> points,
                                                      std::int64_t extent, int steps,
                                                      std::mt19937_64& random) {
  Realization result = rounded(points, extent);
  for (int step = 0; step < steps && violations(result) > 0; ++step)
    improve(result, one_of(result.size(), random), extent, random);
  if (judge_.verdict(result) == conditions::PointsVerdict::satisfied) return result;
  return std::nullopt;
}

}  // namespace hexatlas::solve
