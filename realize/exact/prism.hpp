#pragma once
/// \file
/// The sign of the Jacobian determinant of a prism, and of a pyramid.
///
/// Prism. Definition. The corners p_0, p_1, p_2 (bottom) and p_3, p_4, p_5 (top, i + 3 above i)
/// define the map x(r, s, t) = sum q_i ((1 - t) p_i + t p_(i+3)) of the closed prism r, s >= 0,
/// r + s <= 1, 0 <= t <= 1, with q_0 = 1 - r - s, q_1 = r, q_2 = s. It is *valid* if the Jacobian
/// determinant J is positive on the closed prism.
/// Derivation. dx/dr = (1 - t) a + t a' and dx/ds = (1 - t) b + t b' with a = p_1 - p_0, a' =
/// p_4 - p_3, b = p_2 - p_0, b' = p_5 - p_3, and dx/dt = sum q_i v_i with v_i = p_(i+3) - p_i. So
/// J = sum q_i J_i(t), where J_i, the value on the lateral edge i, is the quadratic polynomial with
/// the Bernstein coefficients
///   det(a, b, v_i),   m_i / 2 with m_i = det(a, b', v_i) + det(a', b, v_i),   det(a', b', v_i).
/// J is a mean of the J_i, and takes their values: its least value is the least of the three. The
/// polynomial with coefficients c, m/2, d is positive on [0, 1] exactly if c > 0, d > 0, and either
/// m >= 0 or m^2 < 4 c d: if m < 0, its least value is (4 c d - m^2) / (4 (c - m + d)), at a point
/// between 0 and 1. So validity is decided without subdivision and is never left open.
///
/// Pyramid. Definition. The base p_0, p_1, p_2, p_3 (cyclic) and the apex p_4 define the map
/// x(r, s, t) = (1 - t) Q(r, s) + t p_4 of the unit cube, where Q is the bilinear map of the base,
/// Q(0,0) = p_0, Q(1,0) = p_1, Q(1,1) = p_2, Q(0,1) = p_3. Its J is 0 at t = 1, where the square
/// shrinks to the apex, for every pyramid. A pyramid is *valid* if J > 0 wherever t < 1.
/// Derivation. J = (1 - t)^2 K(r, s), K = det(Q_r, Q_s, p_4 - Q). With Q = p_0 + r A + s B + r s C
/// and D = p_4 - p_0, the terms with r^2 or s^2 repeat a vector, those with r^2 s and r s^2 too,
/// and
///   K = det(A, B, D) + r det(A, C, D) + s det(C, B, D) + r s det(A, B, C)
/// is bilinear. So K is positive on the square exactly if it is at its four corners, where it is
/// det(p_(i+1) - p_i, p_(i-1) - p_i, p_4 - p_i), six times the volume of a tetrahedron.
/// The apex sees both triangulations of the base from the positive side.
///
/// Shape of a prism at a corner: with the edges u, v of the triangle, its third edge t, the lateral
/// edge w and J there, 2 / (3 sqrt 3) J (1/(|u| |v|) + 1/(|v| |t|) + 1/(|u| |t|)) / |w|.
/// Derivation. Let A, B, C be the squares of |u|, |v|, |t|, and W that of |w|, T = A + B + C. For
/// J > 0 the shape is above q exactly if 2 J (sqrt A + sqrt B + sqrt C) > 3 sqrt 3 q sqrt(A B C W),
/// or squared,
///   e > R / L,  e = sqrt(AB) + sqrt(BC) + sqrt(CA),  R = 27 q^2 A B C W - 4 J^2 T,  L = 8 J^2.
/// With s = AB + BC + CA, e^2 = s + 2 sqrt(ABC) (sqrt A + sqrt B + sqrt C), and the square of the
/// last sum is T + 2 e: e is a zero of F(x) = (x^2 - s)^2 - 4 ABC (T + 2 x), and above sqrt s. At
/// sqrt s F is negative, and from there on convex: e is the only zero there. So, for x > -sqrt s,
/// e > x exactly if x^2 < s or F(x) < 0, which is decided without a root. R / L >= -T / 2, and
/// 4 s - T^2 is 16 times the square of the triangle's area (Heron).
///
/// Shape of a pyramid at a corner of the base with the edge w to the apex: with
/// z = sqrt 2 (w - (u + v)/2) and D = det(u, v, z) = sqrt 2 K, 3 D^(2/3) / (|u|^2 + |v|^2 + |z|^2).
/// Derivation. For K > 0 it is above q exactly if 432 K^2 > (q T)^3, where
/// T = 2 |u|^2 + 2 |v|^2 + |2 w - u - v|^2.
///
/// Method. Double precision with the bound of realize/exact/determinant.hpp, else integers.
/// Requires. Finite coordinates, else PreconditionViolated; rounding to nearest.

#include <array>
#include <optional>

#include "realize/exact/jacobian.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// Bottom 0 1 2, top 3 4 5; J > 0 at corner 0 if p_1 - p_0, p_2 - p_0, p_3 - p_0 are right-handed.
using Prism = std::array<Point3, 6>;

/// Base 0 1 2 3, apex 4; K > 0 at corner 0 if p_1 - p_0, p_3 - p_0, p_4 - p_0 are right-handed.
using Pyramid = std::array<Point3, 5>;

/// The verdict by integer arithmetic, never `undecided`; of a pyramid, `positive` means J > 0 for
/// t < 1, and its corners are those of the base. Cost: some microseconds.
[[nodiscard]] JacobianVerdict exact_jacobian_verdict(const Prism& corners);
[[nodiscard]] JacobianVerdict exact_jacobian_verdict(const Pyramid& corners);

/// The verdict by double precision, never `undecided`; nullopt where this does not suffice. Agrees
/// with exact_jacobian_verdict. Not promised: that it decides any particular input.
[[nodiscard]] std::optional<JacobianVerdict> filtered_jacobian_verdict(const Prism& corners);
[[nodiscard]] std::optional<JacobianVerdict> filtered_jacobian_verdict(const Pyramid& corners);

/// Whether J, or K, is positive and the shape greater than the threshold at each corner, of a
/// pyramid at those of the base; by integers. Equality is not greater.
/// Requires 0 <= threshold <= 1, at which nothing is greater. Cost: tens of microseconds.
[[nodiscard]] bool corners_exceed(const Prism& corners, double threshold);
[[nodiscard]] bool corners_exceed(const Pyramid& corners, double threshold);

}  // namespace hexatlas::exact
