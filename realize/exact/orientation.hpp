#pragma once
/// \file
/// The orientation of four points.
///
/// Definition. The sign of det(b - a, c - a, d - a): positive if d sees a, b, c
/// counter-clockwise, as for the origin followed by the unit points of a right-handed frame.
///
/// Method. The determinant in double precision, if it exceeds a proven bound on its error
/// (derived in realize/exact/determinant.hpp, underflow included); else integers, all coordinates
/// being multiples of one power of two: of fixed width if the differences are below 2^126 times
/// that, otherwise of any length.
/// The idea of a filter is that of Fortune and Van Wyk, "Efficient exact arithmetic for
/// computational geometry" (1993); the bound is derived here.
///
/// Requires. Finite coordinates, else PreconditionViolated; rounding to nearest.
/// Cost. About 40 operations. If the filter cannot decide, three times that for differences below
/// 2^62, ten times below 2^126, else about a microsecond.

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
