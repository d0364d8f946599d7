#pragma once
/// \file
/// The orientation of four points with small integer coordinates.
///
/// Definition. As sign_of_orientation of realize/exact/orientation.hpp: the sign of
/// det(b - a, c - a, d - a).
///
/// Method. Differences are at most 2^21, minors of two of them at most 2^43 in absolute value, and
/// so the determinant is at most 3 2^64: minors in 64 bits, the sum in 128 bits, no filter.
///
/// Requires. Coordinates of absolute value at most kIntegerPointBound; not checked, since this is
/// the innermost loop of its callers. Cost. Some nanoseconds.

#include <array>
#include <cstdint>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

inline constexpr std::int64_t kIntegerPointBound = std::int64_t{1} << 20U;

using IntegerPoint3 = std::array<std::int64_t, 3>;

/// The sign of the orientation.
[[nodiscard]] Sign sign_of_orientation(const IntegerPoint3& a, const IntegerPoint3& b,
                                       const IntegerPoint3& c, const IntegerPoint3& d) noexcept;

}  // namespace hexatlas::exact
