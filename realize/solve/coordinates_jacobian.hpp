#pragma once
/// \file
/// The Bernstein coefficients of the Jacobian determinant of a trilinear hexahedron in double
/// precision, with derivatives. Private to realize/solve: proposes, decides nothing.
///
/// Definition: realize/exact/jacobian.hpp, (l, m, n) at l + 3m + 9n. That all 27 are positive is
/// sufficient for the condition jacobian. Subdivision would be a weaker demand, but has not made
/// any more triangulations of the hexahedron realizable.

#include <array>
#include <cstddef>
#include <span>

#include "realize/exact/jacobian.hpp"

namespace hexatlas::solve {

class JacobianCoefficients {
 public:
  /// At the corners x y z of vertex 0 .. 7; valid until the next call.
  const std::array<double, exact::kJacobianCoefficients>& at(std::span<const double> points);
  /// Adds to `gradient` the derivative of sum weight * coefficient at the points last given.
  void add_derivative(std::span<const double> weights, std::span<double> gradient) const;

 private:
  std::array<std::array<std::array<double, 3>, 4>, 3> edges_{};  ///< by direction and offset
  std::array<double, exact::kJacobianCoefficients> values_{};
};

}  // namespace hexatlas::solve
