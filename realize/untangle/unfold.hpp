#pragma once
/// \file
/// Turning inverted hexahedra over. Private to realize/untangle.

#include "realize/untangle/work.hpp"

namespace hexatlas::untangle {

/// The least determinant, and the least scaled one, over the samples looked at.
struct Least {
  double determinant = 0;
  double scaled = 1;
};
[[nodiscard]] Least least_of(const Problem& problem, const Variables& x);

/// Minimizes Foldover with this lambda while epsilon decreases by the rule of its source, until all
/// determinants at the samples looked at are positive and stay so for some steps, or work is done.
/// Whether they are.
bool unfold(const Problem& problem, double lambda, Variables& x, Work& work);

/// Raises the least scaled determinant, with ScaledExponential, until it is positive. Whether it
/// is.
bool raise_above_zero(const Problem& problem, Variables& x, Work& work);

}  // namespace hexatlas::untangle
