#pragma once
/// \file
/// Better shapes without loss of validity. Private to realize/untangle.

#include "realize/untangle/placement.hpp"
#include "realize/untangle/work.hpp"

namespace hexatlas::untangle {

/// Raises the least scaled Jacobian of the problem's cells, with ScaledPower and growing power,
/// from points at which all corners that move are positive; x is left where it is otherwise. Cells
/// that were valid are valid at the end.
void raise(Problem& problem, Variables& x, Work& work);

}  // namespace hexatlas::untangle
