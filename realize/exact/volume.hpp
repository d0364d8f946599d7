#pragma once
/// \file
/// The side on which a closed surface has its inside.
///
/// Definition. A closed, coherently oriented surface of triangles (a, b, c) encloses the signed
/// volume sum det(a, b, c) / 6; it is positive if the triangles are counter-clockwise from outside.
///
/// Method. Integers: the coordinates scaled by a common power of two. No rounding, no tolerance.
///
/// Requires. Finite coordinates, else PreconditionViolated. Cost. Some microseconds per
/// triangle; more if exponents are far apart.
/// Not promised: a meaning for surfaces that are not closed or that cut themselves.

#include <array>
#include <span>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// The sign of sum det(a, b, c).
[[nodiscard]] Sign sign_of_volume(std::span<const std::array<Point3, 3>> triangles);

}  // namespace hexatlas::exact
