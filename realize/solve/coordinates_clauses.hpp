#pragma once
/// \file
/// The conditions on the signs of points that coordinates must satisfy, simplified. Private to
/// realize/solve.
///
/// Shapes. Clauses of realize/conditions/clauses.hpp, without those that all points satisfy
/// (Grassmann-Pluecker, acyclic), and simplified by the signs that are known: those of the
/// tetrahedra, those given, those of the corners for the condition jacobian, and those that
/// follow by unit propagation.

#include <span>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"
#include "realize/chirotope/chirotope.hpp"

namespace hexatlas::solve {

struct SignConditions {
  std::vector<certificate::Literal> units;
  std::vector<certificate::Clause> clauses;  ///< of two literals or more, none of a unit; ascending
  bool contradictory = false;                ///< no points satisfy them
};

/// `known` has a sign or 0 for each variable, or is empty. Requires what conditions::premises does.
[[nodiscard]] SignConditions sign_conditions(const complex::Triangulation& triangulation,
                                             std::span<const int> signs,
                                             certificate::Condition condition,
                                             const chirotope::Signs& known);

}  // namespace hexatlas::solve
