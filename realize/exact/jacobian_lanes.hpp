#pragma once
/// \file
/// Four hexahedra at once: the verdict on their Jacobians by double precision with a proven bound.
/// Private to realize/exact.
///
/// Derivation. In the words of jacobian.hpp, let S(l, m, n) be the sum of the determinants of the
/// coefficient b(l, m, n): S = N b, with N = 1, 2, 4, 8 at a corner, on an edge, in a facet,
/// inside. For the map E + r E_r + s E_s + t E_t + rs E_rs + rt E_rt + st E_st + rst D,
///   dx/dr = E_r + s E_rs + t E_rt + st D,  dx/ds = E_s + r E_rs + t E_st + rt D,
///   dx/dt = E_t + r E_rt + s E_st + rs D.
/// A monomial of J with r^2 s^2 takes s E_rs or st D, r E_rs or rt D, and rs D: two of the three
/// vectors are equal. So J has no monomial with two squares; it lies in the space of the quadratic
/// serendipity element, of dimension 20, and its values at the corners and the coefficients of its
/// edges determine it. That there is no r^2 s^2 t^k means that a second difference in r of second
/// differences in s is zero: for each n
///   4 b(1,1,n) = 2 (b(1,0,n) + b(0,1,n) + b(2,1,n) + b(1,2,n))
///                - (b(0,0,n) + b(2,0,n) + b(0,2,n) + b(2,2,n)).
/// Hence S of a facet is the sum over its edges less the sum over its corners, and S(1,1,1) is the
/// sum over the four facets parallel to t less the sum over the four edges parallel to t.
/// Corners and edges have 32 of the 64 determinants and take 16 cross products.
///
/// Claim. In the words of determinant.hpp, with unit = fl(fl(XY)Z): the computed S errs by less
/// than 2^-47, 2^-46, 2^-43, 2^-40 units at a corner, on an edge, in a facet, inside.
/// Proof. Errors in units of u P. Those by underflow are, as there, below 0.01 for a determinant,
/// and below 1 for all that come together here.
/// - Corner: C . (A x B), the determinant of determinant.hpp up to names: 46.2; at most 6.04 P.
/// - Edge along r or s: two such, 92.4, added by 12.1: 104.5; at most 12.1 P.
/// - Edge along t: C . (A x B + A' x B'). Twelve products err by 36.2 from the differences. An
///   entry of a cross product errs by 4.01 u YZ and is at most 2.01 YZ; the sum of two errs by
///   8.02 u YZ + 4.03 u YZ and is at most 4.03 YZ. Times x, rounded: 12.1 + 4.1 = 16.2, at most
///   4.04 P. Three of these: 48.6, added by 8.1 + 12.2. In sum 105.1; at most 12.2 P.
/// - Facet: four edges, 4 * 105.1, added by 24.4 + 36.6 + 48.8; four corners, 4 * 46.2, added by
///   12.1 + 18.2 + 24.2; their difference by 73. In sum below 843; at most 24.1 P, as the real
///   value is a sum of four determinants.
/// - Inside: four facets, 4 * 843, added by 48.2 + 72.3 + 96.4; four edges, 4 * 105.1, added by
///   109.8; their difference by 146. In sum below 4266.
/// The bounds are 64, 128, 1024 and 8192 u unit, and unit >= (1 - u)^2 P.

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// One bit for each hexahedron: lane j is bit j.
struct LaneVerdicts {
  unsigned positive = 0;         ///< J is positive on the closed cube, proven
  unsigned corner_negative = 0;  ///< J < 0 at a corner, proven
  unsigned overflow = 0;         ///< an infinite difference; or a NaN, and then the others are void
};

/// Each pointer to the eight corners of a hexahedron. The same bits from each implementation.
using FourJacobians = LaneVerdicts (*)(const Point3* a, const Point3* b, const Point3* c,
                                       const Point3* d);

/// The fastest that this processor can.
[[nodiscard]] FourJacobians four_jacobians() noexcept;

/// Built for a processor with AVX2, or nullptr where the compiler has none.
[[nodiscard]] FourJacobians four_jacobians_avx2() noexcept;
[[nodiscard]] FourJacobians four_jacobians_plain() noexcept;

}  // namespace hexatlas::exact
