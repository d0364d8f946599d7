#pragma once
/// \file
/// Internal to the judge: signs of four points, and the circuits of five.

#include <bit>
#include <cstdint>

#include "tables/check/catalogue_read.hpp"

namespace hexatlas::check {

/// C(n, k) for small numbers.
[[nodiscard]] constexpr std::uint32_t binomial(std::uint32_t n, std::uint32_t k) noexcept {
  std::uint32_t result = 1;
  for (std::uint32_t i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return n < k ? 0 : result;
}

/// The place of a set of four vertices a < b < c < d: C(a,1) + C(b,2) + C(c,3) + C(d,4). So the
/// sets within 0 .. n-1 have the places 0 .. C(n,4) - 1. The variable of the format is one more.
[[nodiscard]] constexpr std::uint32_t place_of(VertexBits four) noexcept {
  std::uint32_t place = 0;
  std::uint32_t size = 1;
  for (unsigned rest = four; rest != 0; rest &= rest - 1) {
    place += binomial(static_cast<std::uint32_t>(std::countr_zero(rest)), size++);
  }
  return place;
}

/// Two sides of five points: the coefficients of an affine dependency of them have these signs, the
/// points of coefficient zero being on neither side. If the five points are not in one plane, it is
/// their only one up to a factor.
struct Circuit {
  unsigned positive = 0;
  unsigned negative = 0;
};

/// The coefficient of the i-th point is (-1)^i times the determinant of the others in ascending
/// order (Cramer's rule). `sign_of(four)` is the sign of that determinant.
template <class SignOf>
[[nodiscard]] Circuit circuit_of(VertexBits five, const SignOf& sign_of) {
  Circuit circuit;
  int factor = 1;
  for (unsigned rest = five; rest != 0; rest &= rest - 1) {
    const unsigned point = rest & (0U - rest);
    const int sign = factor * sign_of(static_cast<VertexBits>(five & ~point));
    if (sign > 0) circuit.positive |= point;
    if (sign < 0) circuit.negative |= point;
    factor = -factor;
  }
  return circuit;
}

/// Calls `use` with each subset of `set` of that size.
template <class Use>
void for_each_subset(VertexBits set, int size, const Use& use) {
  for (unsigned subset = set; subset != 0; subset = (subset - 1U) & set) {
    if (std::popcount(subset) == size) use(static_cast<VertexBits>(subset));
  }
}

}  // namespace hexatlas::check
