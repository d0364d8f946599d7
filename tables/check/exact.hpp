#pragma once
/// \file
/// Internal to the judge: vectors of numbers of any kind, and points as integers.

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> difference(const Vector<Number>& to, const Vector<Number>& from) {
  return {Number(to[0] - from[0]), Number(to[1] - from[1]), Number(to[2] - from[2])};
}

template <class Number>
Number minor_of(const Vector<Number>& a, const Vector<Number>& b) {
  return a[0] * b[1] - b[0] * a[1];
}

/// Small holds the minors of two rows, Large what is made of them.
template <class Large, class Small>
Large determinant(const std::array<Vector<Small>, 3>& v) {
  return Large(v[0][2]) * minor_of(v[1], v[2]) - Large(v[1][2]) * minor_of(v[0], v[2]) +
         Large(v[2][2]) * minor_of(v[0], v[1]);
}

/// Bounds of the absolute values of the coordinates.
template <std::size_t kCount>
Vector<double> bounds_of(const std::array<Vector<double>, kCount>& vectors) {
  Vector<double> bounds{};
  for (const Vector<double>& v : vectors) {
    for (std::size_t i = 0; i < 3; ++i) bounds[i] = std::max(bounds[i], std::abs(v[i]));
  }
  return bounds;
}

/// Whether products of three differences bounded so neither overflow nor lose to underflow more
/// than the error bounds of signs.cpp allow for.
inline bool are_moderate(const Vector<double>& bounds) {
  const auto [least, greatest] = std::minmax({bounds[0], bounds[1], bounds[2]});
  return least >= 0x1p-150 && greatest <= 0x1p150;
}

/// |value| = mantissa 2^exponent, for a finite value.
struct Parts {
  std::uint64_t mantissa;
  int exponent;
};

inline Parts parts_of(double value) {
  constexpr int kFraction = 52;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>(bits >> kFraction & 0x7FF);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << kFraction) - 1);
  if (biased == 0) return {fraction, -1074};
  return {fraction | std::uint64_t{1} << kFraction, biased - 1075};
}

/// value 2^-unit. Requires that this is an integer, and unit no more than the exponent.
inline mpz_class as_integer(double value, int unit) {
  const Parts parts = parts_of(value);
  if (parts.mantissa == 0) return 0;
  mpz_class integer = static_cast<unsigned long>(parts.mantissa);
  integer <<= static_cast<mp_bitcnt_t>(parts.exponent - unit);
  return value < 0 ? mpz_class(-integer) : integer;
}

/// The least exponent of a coordinate that is not zero; the greatest integer if there is none.
template <std::size_t kCount>
int unit_of(const std::array<const Point*, kCount>& points) {
  int unit = std::numeric_limits<int>::max();
  for (const Point* point : points) {
    for (const double value : *point) {
      const Parts parts = parts_of(value);
      if (parts.mantissa != 0) unit = std::min(unit, parts.exponent);
    }
  }
  return unit;
}

/// The points as integers, multiplied by 2^-unit. Requires a unit that is at most unit_of(points).
template <std::size_t kCount>
std::array<Vector<mpz_class>, kCount> as_integers(const std::array<const Point*, kCount>& points,
                                                  int unit) {
  std::array<Vector<mpz_class>, kCount> integers;
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      integers[i][axis] = as_integer((*points[i])[axis], unit);
    }
  }
  return integers;
}

template <std::size_t kCount>
std::array<Vector<mpz_class>, kCount> as_integers(const std::array<const Point*, kCount>& points) {
  return as_integers(points, unit_of(points));
}

}  // namespace hexatlas::check
