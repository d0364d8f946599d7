#pragma once
/// \file
/// Small integer coordinates for a triangulation under a condition.
///
/// Method. Descent from random points on the determinants and Jacobian coefficients that the
/// condition speaks of (coordinates_descent.hpp, coordinates_slack.hpp), in the manner of M.
/// Firsching, "Realizability and inscribability for simplicial polytopes via nonlinear
/// optimization", Math. Programming 166 (2017), but with the signs of the tetrahedra and the
/// clauses of the condition instead of a complete chirotope; rounding at growing resolution; then
/// ever smaller cubes, in which rounded points are repaired by moves of one point to a neighbour.
/// Every result has passed conditions::PointsJudge; floating point only proposes.
///
/// Deterministic for one build: same arguments, same points. Not promised: that points are found
/// where they exist, or that no smaller ones exist.
/// Cost. For the 174 triangulations of the hexahedron about 0.01 s each to find points, and 0.1 to
/// 0.5 s to make them small.

#include <cstdint>
#include <optional>
#include <span>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"
#include "realize/chirotope/chirotope.hpp"

namespace hexatlas::solve {

struct SearchEffort {
  std::uint64_t seed = 1;
  int starts = 200;         ///< random starts until the first points, and for smaller ones
  int descent_steps = 150;  ///< per descent
  int shrink_starts = 12;   ///< other solutions to be made smaller; 0: points as they come
  int repair_steps = 300;   ///< moves of a point per repair
};

/// Requires what conditions::PointsJudge does. nullopt: none found.
[[nodiscard]] std::optional<certificate::Realization> find_realization(
    const complex::Triangulation& triangulation, std::span<const int> signs,
    certificate::Condition condition, const SearchEffort& effort);

/// Likewise, but the descent goes to points whose signs are the given ones where these are not 0,
/// one per variable: for condition and triangulation a chirotope that a solver has found, say.
/// Rounded and made small, the points need not have these signs any more.
[[nodiscard]] std::optional<certificate::Realization> find_realization_of(
    const chirotope::Signs& chirotope, const complex::Triangulation& triangulation,
    std::span<const int> signs, certificate::Condition condition, const SearchEffort& effort);

/// The greatest absolute value of a coordinate.
[[nodiscard]] std::int64_t extent_of(const certificate::Realization& points);

}  // namespace hexatlas::solve
