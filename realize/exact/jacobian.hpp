#pragma once
/// \file
/// The sign of the Jacobian determinant of a trilinear hexahedron.
///
/// Definition. The corners p_ijk (number i + 2j + 4k) define the map of the unit cube
/// x(r, s, t) = sum p_ijk B_i(r) B_j(s) B_k(t), B_0(r) = 1 - r, B_1(r) = r. Its Jacobian
/// determinant J has degree 2 in each of r, s, t and so 27 Bernstein coefficients.
///
/// Derivation. dx/dr = sum A_jk B_j(s) B_k(t) with the edge vectors A_jk = p_1jk - p_0jk, and
/// so for s, t with edge vectors B_ik, C_ij. Since B_i B_i' is B^2_(i+i'), halved if i != i', the
/// coefficient (l, m, n) of J is the mean of det(A_jk, B_ik', C_i'j') over all i + i' = l,
/// j + j' = m, k + k' = n: of 1 determinant at a corner, 2 on an edge, 4 in a facet, 8 inside.
/// The Bernstein polynomials are positive inside the cube and sum to 1. Hence, if all coefficients
/// are positive, so is J on the closed cube; and the eight corner coefficients are values of J.
/// Otherwise the cube is cut into 8 by de Casteljau's algorithm, exactly, and each part judged.
///
/// Source. The test of a hexahedron by its 27 coefficients and subdivision: Johnen, Weill, Remacle,
/// "Robust and efficient validation of the linear hexahedral element" (2017), arXiv 1706.01613.
/// Error bound: realize/exact/jacobian_lanes.hpp.
///
/// Requires. Finite coordinates, else PreconditionViolated; rounding to nearest.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

inline constexpr std::size_t kJacobianCoefficients = 27;
inline constexpr int kMaxSubdivisionDepth = 8;

/// The corners, numbered x + 2y + 4z.
using Hexahedron = std::array<Point3, 8>;

/// J is positive on the closed cube; or not positive at some point of it; or not known to depth d.
enum class Positivity : std::uint8_t { positive, not_positive, undecided };

struct JacobianVerdict {
  Positivity positivity = Positivity::undecided;
  bool corner_not_positive = false;  ///< J <= 0 at one of the eight corners
  friend bool operator==(const JacobianVerdict&, const JacobianVerdict&) = default;
};

/// The signs of the coefficients, (l, m, n) at l + 3m + 9n; exact for any finite doubles.
[[nodiscard]] std::array<Sign, kJacobianCoefficients> signs_of_jacobian_coefficients(
    const Hexahedron& corners);

/// The verdict by integer arithmetic, after at most `depth` subdivisions into 8.
/// With depth d it is not_positive exactly if J <= 0 at a point with coordinates in 2^-d Z.
/// Requires 0 <= depth <= kMaxSubdivisionDepth. Cost: at most 8^d parts, in practice those
/// near a zero of J; tens of microseconds for the first.
[[nodiscard]] JacobianVerdict exact_jacobian_verdict(const Hexahedron& corners, int depth);

/// The verdict by double precision with a proven error bound and without subdivision: never
/// `undecided`; nullopt where this does not suffice. Agrees with exact_jacobian_verdict.
[[nodiscard]] std::optional<JacobianVerdict> filtered_jacobian_verdict(const Hexahedron& corners);

/// The same of many hexahedra, which is faster for each: some 30 ns with AVX2, 150 without; the
/// same verdicts. Requires. As many verdicts as hexahedra, else PreconditionViolated.
void filtered_jacobian_verdicts(std::span<const Hexahedron> hexahedra,
                                std::span<std::optional<JacobianVerdict>> verdicts);

/// The verdict by double precision with a proven error bound after at most `depth` subdivisions;
/// nullopt where this does not suffice. Agrees with exact_jacobian_verdict, `undecided` included.
/// Requires finite coordinates and 0 <= depth <= kMaxSubdivisionDepth. Cost: a microsecond, and
/// a quarter of one for each part.
[[nodiscard]] std::optional<JacobianVerdict> subdivided_jacobian_verdict(const Hexahedron& corners,
                                                                         int depth);

/// Whether at each corner det / (|u| |v| |w|) > threshold, u, v, w being its edges and det their
/// determinant, the value of J there; by integers, since a product of lengths is the root of one.
/// Requires finite coordinates and 0 <= threshold < 1. Cost: tens of microseconds.
[[nodiscard]] bool corners_exceed(const Hexahedron& corners, double threshold);

}  // namespace hexatlas::exact
