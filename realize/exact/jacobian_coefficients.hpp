#pragma once
/// \file
/// Private to realize/exact: the 27 coefficients of a Jacobian (jacobian.hpp) from the corners.

#include <array>
#include <cstddef>
#include <utility>

#include "realize/exact/determinant.hpp"
#include "realize/exact/jacobian.hpp"

namespace hexatlas::exact {

template <class Number>
using JacobianNumbers = std::array<Number, kJacobianCoefficients>;

inline constexpr std::array<std::size_t, 8> kCornerCoefficients{0, 2, 6, 8, 18, 20, 24, 26};
inline constexpr std::array<std::size_t, 3> kStride{1, 3, 9};

/// How many determinants the coefficient is the mean of: 2 for each middle index.
constexpr int determinants_in(std::size_t coefficient) {
  int count = 1;
  for (const std::size_t stride : kStride)
    if (coefficient / stride % 3 == 1) count *= 2;
  return count;
}

/// edges[k][o] is the edge vector in direction k whose start has, in the two other directions
/// in ascending order, the coordinates that are the low and the high bit of o.
template <class Number>
using EdgeVectors = std::array<std::array<Vector3<Number>, 4>, 3>;

template <class Number>
EdgeVectors<Number> edge_vectors(const std::array<Vector3<Number>, 8>& p) {
  constexpr std::array<std::array<std::size_t, 2>, 3> kOthers{{{2, 4}, {1, 4}, {1, 2}}};
  EdgeVectors<Number> edges;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t o = 0; o < 4; ++o) {
      const std::size_t start = (o & 1U) * kOthers[k][0] + (o >> 1U) * kOthers[k][1];
      edges[k][o] = difference(p[start + (std::size_t{1} << k)], p[start]);
    }
  return edges;
}

/// For each coefficient the sum, not the mean, of its determinants. The six bits of `choice` are
/// j, k, i, k', i', j' of the derivation.
template <class Number>
JacobianNumbers<Number> determinant_sums(const EdgeVectors<Number>& edges) {
  JacobianNumbers<Number> sums{};
  for (std::size_t choice = 0; choice < 64; ++choice) {
    const auto bit = [choice](unsigned place) { return choice >> place & 1U; };
    const std::size_t l = bit(2) + bit(4);
    const std::size_t m = bit(0) + bit(5);
    const std::size_t n = bit(1) + bit(3);
    sums[l + 3 * m + 9 * n] +=
        determinant(edges[0][choice & 3U], edges[1][choice >> 2U & 3U], edges[2][choice >> 4U]);
  }
  return sums;
}

/// De Casteljau at 1/2 in direction k: the coefficients on the lower and the upper half, times 4.
template <class Number>
std::pair<JacobianNumbers<Number>, JacobianNumbers<Number>> halves(
    const JacobianNumbers<Number>& whole, std::size_t k) {
  std::pair<JacobianNumbers<Number>, JacobianNumbers<Number>> result;
  auto& [low, high] = result;
  const std::size_t stride = kStride[k];
  for (std::size_t first = 0; first < kJacobianCoefficients; ++first) {
    if (first / stride % 3 != 0) continue;
    const std::size_t second = first + stride;
    const std::size_t third = second + stride;
    low[first] = 4 * whole[first];
    low[second] = 2 * (whole[first] + whole[second]);
    low[third] = whole[first] + 2 * whole[second] + whole[third];
    high[first] = low[third];
    high[second] = 2 * (whole[second] + whole[third]);
    high[third] = 4 * whole[third];
  }
  return result;
}

}  // namespace hexatlas::exact
