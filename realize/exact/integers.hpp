#pragma once
/// \file
/// Points scaled by a common power of two so that all coordinates are integers, which changes no
/// sign of a homogeneous polynomial. Private to realize/exact: the door to GMP.
///
/// Cost. A coordinate has at most 2098 bits, 53 if all have one exponent.

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "enum/core/checks.hpp"
#include "realize/exact/binary.hpp"
#include "realize/exact/determinant.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

using Integer = mpz_class;

[[nodiscard]] inline Integer scaled_integer(double value, int unit_exponent) {
  if (value == 0) return 0;
  const BinaryParts parts = binary_parts(value);
  return Integer(static_cast<long>(parts.mantissa))
         << static_cast<unsigned long>(parts.exponent - unit_exponent);
}

template <std::size_t kCount>
void expect_finite(const std::array<Point3, kCount>& points) {
  for (const Point3& p : points)
    core::expects(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
                  "exact: coordinates must be finite");
}

/// The greatest k for which all coordinates are multiples of 2^k; the greatest int if all are zero.
template <std::size_t kCount>
[[nodiscard]] int unit_exponent_of(const std::array<Point3, kCount>& points) noexcept {
  int unit_exponent = std::numeric_limits<int>::max();
  for (const Point3& p : points)
    for (const double value : {p.x, p.y, p.z})
      if (value != 0) unit_exponent = std::min(unit_exponent, binary_parts(value).exponent);
  return unit_exponent;
}

/// The points divided by 2^unit_exponent. Requires that it is at most unit_exponent_of(points).
template <std::size_t kCount>
[[nodiscard]] std::array<Vector3<Integer>, kCount> scaled_integers(
    const std::array<Point3, kCount>& points, int unit_exponent) {
  std::array<Vector3<Integer>, kCount> result;
  for (std::size_t i = 0; i < kCount; ++i)
    result[i] = {scaled_integer(points[i].x, unit_exponent),
                 scaled_integer(points[i].y, unit_exponent),
                 scaled_integer(points[i].z, unit_exponent)};
  return result;
}

/// The points times a power of two that they share.
template <std::size_t kCount>
[[nodiscard]] std::array<Vector3<Integer>, kCount> scaled_integers(
    const std::array<Point3, kCount>& points) {
  return scaled_integers(points, unit_exponent_of(points));
}

[[nodiscard]] inline Sign sign_of(const Integer& value) noexcept {
  return static_cast<Sign>(sgn(value));
}

}  // namespace hexatlas::exact
