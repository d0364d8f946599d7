#pragma once
/// \file
/// The orientation of four points.
///
/// Definition. The sign of det(b - a, c - a, d - a): positive if d sees a, b, c
/// counter-clockwise, as for the origin followed by the unit points of a right-handed frame.
///
/// Method. The determinant in double precision, if it exceeds a proven bound on its error
/// (derived in realize/exact/determinant.hpp, underflow included); else integers, of fixed width
/// where the coordinates are multiples below 2^125 of one power of two, otherwise of any length.
/// The idea of a filter is that of Fortune and Van Wyk, "Efficient exact arithmetic for
/// computational geometry" (1993); the bound is derived here.
///
/// Requires. Finite coordinates, else PreconditionViolated; rounding to nearest.
/// Cost. About 40 operations. If the filter cannot decide, ten times that for multiples below
/// 2^61 of one power of two, twice as much again below 2^125, else some microseconds.

#include <optional>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// The sign of the orientation, exact for any finite doubles.
[[nodiscard]] Sign sign_of_orientation(const Point3& a, const Point3& b, const Point3& c,
                                       const Point3& d);

/// The filter alone: the sign, never `zero`, or nullopt where double precision cannot decide.
/// Not promised: that it decides any particular input.
[[nodiscard]] std::optional<Sign> filtered_sign_of_orientation(const Point3& a, const Point3& b,
                                                               const Point3& c, const Point3& d);

}  // namespace hexatlas::exact
