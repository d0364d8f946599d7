#pragma once
/// \file
/// The least scaled Jacobian of a whole hexahedron or prism, not only of its corners.
///
/// Definition. For a hexahedron S = J / (|dx/dr| |dx/ds| |dx/dt|), for the trilinear map of
/// realize/exact/jacobian.hpp; its value at a corner is that of hexahedron.hpp. For a prism S is
/// the measure of cells.hpp with u = dx/dr, v = dx/ds, t = v - u and w = dx/dt at any point, for
/// the map of realize/exact/prism.hpp. Where a derivative is zero, S counts 0. S is in [-1, 1].
///
/// Method. Values at points bound the least S from above; bounds over parts of the cell, the most
/// promising of which is cut in two next, bound it from below.
///
/// Hexahedron. On a part let J have the Bernstein coefficients j_i. With the lengths f, g, h of the
/// derivatives at its centre, M = (|dx/dr|^2 / f^2 + |dx/ds|^2 / g^2 + |dx/dt|^2 / h^2) / 3 has
/// Bernstein coefficients M_i, and the product of the three lengths is at most f g h M^(3/2), by
/// the inequality of the means. The convex function M^(3/2) is below its chord p + q M between
/// the least and the greatest M_i. So S >= min j_i / (f g h (p + q M_i)) if no j_i is negative.
/// Else, where J < 0, the product is at least that of the projections on the derivatives at the
/// centre, a polynomial with coefficients w_i, and S >= min j_i / w_i if all projections of
/// coefficients are positive. Both bounds are right to first order, so the gap is quadratic in
/// the size of a part.
///
/// Prism. J is linear in the triangle and |dx/dt| convex there, while u, v depend on the height
/// only: if J >= 0, the part of the triangle where S >= c is convex for each c, so the least S is
/// on a lateral edge. There S is J (|u| + |v| + |t|) over the product of lengths, up to a constant:
/// the sum is at least that of the projections on u, v, t at half the height, and the product is
/// bounded as above. If J <= 0 anywhere, the bounds are -1 and at most 0.
///
/// The subdivision of hexahedra: A. Johnen, J.-C. Weill, J.-F. Remacle, arXiv 1706.01613.
///
/// In double precision, with relative errors of some 1e-12: a measure that proves nothing.
/// Requires. Finite coordinates, else PreconditionViolated. No scale of them makes it overflow.
/// Cost. Some microseconds for cells of good shape; at most kMostParts parts.
/// Not promised. A gap of at most kShapeGap for prisms with J <= 0 somewhere, nor for cells with a
/// derivative of zero somewhere, where S is not continuous.

#include "meshing/quality/cells.hpp"
#include "meshing/quality/hexahedron.hpp"

namespace hexatlas::quality {

inline constexpr double kShapeGap = 1e-3;
inline constexpr int kMostParts = 4000;

/// low <= least S <= high, up to rounding.
struct ShapeBounds {
  double low = -1;
  double high = 1;
};

[[nodiscard]] ShapeBounds least_scaled_jacobian(const Corners& corners);
[[nodiscard]] ShapeBounds least_scaled_jacobian(const PrismCorners& corners);

}  // namespace hexatlas::quality
