#pragma once
/// \file
/// The place of a point with respect to the sphere through four others.
///
/// Definition. For a, b, c, d of positive orientation (realize/exact/orientation.hpp): positive if
/// e is strictly inside, zero if e is on the sphere, negative if it is strictly outside. In
/// general the sign of D, the sum of |p|^2 D_p over the five points p, where D_a, D_b, D_c, D_d is
/// det(b - a, c - a, d - a) with that point replaced by e, and D_e is minus that determinant. So
/// minus D is the determinant of five rows (1, p, |p|^2): exchanging two points changes the sign.
///
/// Perturbed. As if each |p|^2 were |p|^2 + eps_p with positive infinitesimals eps_p, each
/// infinitely greater than those of all points before p in the lexicographic order of the
/// coordinates (x, y, z). If D is zero, the sign is that of D_p for the last p in that order
/// whose D_p is not zero. So it depends on the places of the points only, and is never zero unless
/// all five are in one plane. Source: O. Devillers and M. Teillaud, "Perturbations for Delaunay and
/// weighted Delaunay 3D triangulations" (2011). What it means for triangulations:
/// docs/theory/delaunay-ties.md.
///
/// Method. D in double precision, if it exceeds a proven bound on its error (derived in
/// realize/exact/in_sphere.cpp, underflow included); else integers, all coordinates being multiples
/// of one power of two: of fixed width if the differences are below 2^126 times that, otherwise of
/// any length.
///
/// Requires. Finite coordinates, else PreconditionViolated; rounding to nearest.
/// Cost. About 100 operations. If the filter cannot decide, five times that for differences below
/// 2^62 (of lattices, of rounded points of a surface), twenty times below 2^126, else some
/// microseconds.

#include <optional>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// The sign, exact for any finite doubles.
[[nodiscard]] Sign sign_of_in_sphere(const Point3& a, const Point3& b, const Point3& c,
                                     const Point3& d, const Point3& e);

/// The sign after perturbation; zero if and only if all five are in one plane. Requires also that
/// no two points are equal, else PreconditionViolated, or zero if all are in one plane.
[[nodiscard]] Sign sign_of_perturbed_in_sphere(const Point3& a, const Point3& b, const Point3& c,
                                               const Point3& d, const Point3& e);

/// The same without the filter, for those who know that it cannot decide.
[[nodiscard]] Sign unfiltered_sign_of_perturbed_in_sphere(const Point3& a, const Point3& b,
                                                          const Point3& c, const Point3& d,
                                                          const Point3& e);

/// The filter alone: the sign, never `zero`, or nullopt where double precision cannot decide.
/// Not promised: that it decides any particular input.
[[nodiscard]] std::optional<Sign> filtered_sign_of_in_sphere(const Point3& a, const Point3& b,
                                                             const Point3& c, const Point3& d,
                                                             const Point3& e);

}  // namespace hexatlas::exact
