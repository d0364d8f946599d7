#pragma once
/// \file
/// Integer points near given ones that satisfy a condition. Private to realize/solve.
///
/// Method. Least conflicts: the points are rounded; then a random point goes to the neighbour in
/// the cube, of 26 or its own place, with the fewest violations, ties broken at random, until there
/// are none. Violations: those of conditions::PointsJudge, and Jacobian coefficients <= 0.

#include <cstdint>
#include <optional>
#include <random>
#include <span>

#include "realize/certificate/certificate.hpp"
#include "realize/conditions/points.hpp"
#include "realize/solve/coordinates_jacobian.hpp"

namespace hexatlas::solve {

class CoordinateRepair {
 public:
  CoordinateRepair(const conditions::PointsJudge& judge, certificate::Condition condition)
      : judge_(judge), jacobian_(condition == certificate::Condition::jacobian) {}

  /// The points of [-1,1]^3, scaled to [-extent, extent]^3, rounded and repaired in at most
  /// `steps` moves. A result has passed the judge. Requires an extent below kCoordinateBound.
  [[nodiscard]] std::optional<certificate::Realization> repaired(std::span<const double> points,
                                                                 std::int64_t extent, int steps,
                                                                 std::mt19937_64& random);

 private:
  [[nodiscard]] int violations(const certificate::Realization& points);
  void improve(certificate::Realization& points, std::size_t vertex, std::int64_t extent,
               std::mt19937_64& random);

  const conditions::PointsJudge& judge_;
  bool jacobian_;
  JacobianCoefficients coefficients_;
};

}  // namespace hexatlas::solve
