#pragma once
/// \file
/// The place of a weighted point with respect to the orthosphere of four others.
///
/// Definition. A point p with weight w_p has the height h_p = |p|^2 - w_p; the weight is that of
/// the square of a radius, and may be negative. For a, b, c, d of positive orientation
/// (realize/exact/orientation.hpp) there is one sphere, of real or imaginary radius, to which their
/// spheres are orthogonal: that of the affine function with the heights of a, b, c, d. Positive if
/// the height of e is strictly below that function, zero if it is on it, negative above. In general
/// the sign of D, the sum of h_p D_p over the five points p, with the determinants D_p of
/// realize/exact/in_sphere.hpp; exchanging two points changes the sign. If all weights are equal,
/// D is that of the in-sphere test. Source: H. Edelsbrunner, N. R. Shah, "Incremental topological
/// flipping works for regular triangulations" (1996).
///
/// Perturbed. By infinitesimals that depend on the places alone, as in in_sphere.hpp. Never zero
/// unless all five are in one plane. What it means for triangulations:
/// docs/theory/delaunay-ties.md.
///
/// Method. D in double precision, if it exceeds a proven bound on its error (derived in
/// realize/exact/in_orthosphere.cpp, underflow included); else integers, all coordinates being
/// multiples of one power of two, and all weights of its square: of fixed width if the differences
/// of coordinates are below 2^62 times that, and the weights below 2^123 times its square,
/// otherwise of any length.
///
/// Requires. Finite coordinates and weights, else PreconditionViolated; rounding to nearest.
/// Cost. That of the in-sphere test and a few operations more; where fixed width does not suffice,
/// some microseconds.

#include <optional>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

struct WeightedPoint3 {
  Point3 place;
  double weight = 0;
};

/// The sign, exact for any finite doubles.
[[nodiscard]] Sign sign_of_in_orthosphere(const WeightedPoint3& a, const WeightedPoint3& b,
                                          const WeightedPoint3& c, const WeightedPoint3& d,
                                          const WeightedPoint3& e);

/// The sign after perturbation; zero if and only if all five are in one plane. Requires also that
/// no two points are equal in place and weight, else PreconditionViolated, or zero if all are in
/// one plane.
[[nodiscard]] Sign sign_of_perturbed_in_orthosphere(const WeightedPoint3& a,
                                                    const WeightedPoint3& b,
                                                    const WeightedPoint3& c,
                                                    const WeightedPoint3& d,
                                                    const WeightedPoint3& e);

/// The filter alone: the sign, never `zero`, or nullopt where double precision cannot decide.
/// Not promised: that it decides any particular input.
[[nodiscard]] std::optional<Sign> filtered_sign_of_in_orthosphere(const WeightedPoint3& a,
                                                                  const WeightedPoint3& b,
                                                                  const WeightedPoint3& c,
                                                                  const WeightedPoint3& d,
                                                                  const WeightedPoint3& e);

}  // namespace hexatlas::exact
