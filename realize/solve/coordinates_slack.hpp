#pragma once
/// \file
/// The conditions on the points of a triangulation as inequalities slack > 0 between doubles, with
/// derivatives. Private to realize/solve: proposes, decides nothing.
///
/// Shapes. A bracket is det(b - a, c - a, d - a) of the points of a variable. The slacks are, in
/// this order: sign * bracket of each unit; the greatest sign * bracket in each clause
/// (coordinates_clauses.hpp); and, for the condition jacobian, the coefficients of
/// coordinates_jacobian.hpp.
///
/// Cost of an evaluation: proportional to brackets, literals and coefficients; microseconds for n
/// = 8.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "realize/solve/coordinates_clauses.hpp"
#include "realize/solve/coordinates_jacobian.hpp"

namespace hexatlas::solve {

class CoordinateSlacks {
 public:
  CoordinateSlacks(const SignConditions& conditions, certificate::Condition condition);

  /// All slacks at the points x y z of vertex 0, 1, ...; valid until the next call.
  [[nodiscard]] std::span<const double> at(std::span<const double> points);
  /// Adds to `gradient` the derivative of sum weight * slack at the points last given.
  void add_derivative(std::span<const double> weights, std::span<double> gradient);

 private:
  struct Signed {
    std::size_t bracket;
    double sign;
  };

  std::vector<std::array<std::uint8_t, 4>> brackets_;  ///< those that occur; ascending points
  std::vector<Signed> units_;
  std::vector<Signed> literals_;          ///< of all clauses
  std::vector<std::size_t> clause_ends_;  ///< in literals_
  std::optional<JacobianCoefficients> jacobian_;

  std::vector<double> points_, values_, slacks_, bracket_weights_;
  std::vector<Signed> greatest_;  ///< of each clause
};

}  // namespace hexatlas::solve
