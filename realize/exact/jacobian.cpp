#include "realize/exact/jacobian.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "realize/exact/determinant.hpp"
#include "realize/exact/integers.hpp"

namespace hexatlas::exact {
namespace {

template <class Number>
using Coefficients = std::array<Number, kJacobianCoefficients>;

constexpr std::array<std::size_t, 8> kCornerCoefficients{0, 2, 6, 8, 18, 20, 24, 26};
constexpr std::array<std::size_t, 3> kStride{1, 3, 9};

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
Coefficients<Number> determinant_sums(const EdgeVectors<Number>& edges) {
  Coefficients<Number> sums{};
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

/// The coefficients of J times a positive number.
Coefficients<Integer> integer_coefficients(const Hexahedron& corners) {
  Coefficients<Integer> result = determinant_sums(edge_vectors(scaled_integers(corners)));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= 8 / determinants_in(i);
  return result;
}

/// De Casteljau at 1/2 in direction k: the coefficients on the lower and the upper half, times 4.
std::pair<Coefficients<Integer>, Coefficients<Integer>> halves(const Coefficients<Integer>& whole,
                                                               std::size_t k) {
  std::pair<Coefficients<Integer>, Coefficients<Integer>> result;
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

void append_eighths(const Coefficients<Integer>& whole, std::vector<Coefficients<Integer>>& parts) {
  const auto [low_r, high_r] = halves(whole, 0);
  for (const auto& half : {low_r, high_r}) {
    const auto [low_s, high_s] = halves(half, 1);
    for (const auto& quarter : {low_s, high_s}) {
      auto [low_t, high_t] = halves(quarter, 2);
      parts.push_back(std::move(low_t));
      parts.push_back(std::move(high_t));
    }
  }
}

bool all_positive(const Coefficients<Integer>& part) {
  return std::all_of(part.begin(), part.end(), [](const Integer& c) { return c > 0; });
}

bool some_corner_not_positive(const Coefficients<Integer>& part) {
  return std::any_of(kCornerCoefficients.begin(), kCornerCoefficients.end(),
                     [&part](std::size_t i) { return part[i] <= 0; });
}

/// Breadth first, so that a refutation is found at the least depth that has one.
Positivity positivity(const Coefficients<Integer>& whole, int depth) {
  std::vector<Coefficients<Integer>> parts{whole};
  for (int level = 0;; ++level) {
    parts.erase(std::remove_if(parts.begin(), parts.end(), all_positive), parts.end());
    if (parts.empty()) return Positivity::positive;
    if (std::any_of(parts.begin(), parts.end(), some_corner_not_positive))
      return Positivity::not_positive;
    if (level == depth) return Positivity::undecided;
    std::vector<Coefficients<Integer>> smaller;
    smaller.reserve(8 * parts.size());
    for (const auto& part : parts) append_eighths(part, smaller);
    parts = std::move(smaller);
  }
}

}  // namespace

std::array<Sign, kJacobianCoefficients> signs_of_jacobian_coefficients(const Hexahedron& corners) {
  expect_finite(corners);
  const Coefficients<Integer> coefficients = integer_coefficients(corners);
  std::array<Sign, kJacobianCoefficients> signs{};
  std::transform(coefficients.begin(), coefficients.end(), signs.begin(), sign_of);
  return signs;
}

JacobianVerdict exact_jacobian_verdict(const Hexahedron& corners, int depth) {
  expect_finite(corners);
  core::expects(depth >= 0 && depth <= kMaxSubdivisionDepth, "exact: subdivision depth in [0, 8]");
  const Coefficients<Integer> coefficients = integer_coefficients(corners);
  if (some_corner_not_positive(coefficients)) return {Positivity::not_positive, true};
  return {positivity(coefficients, depth), false};
}

std::optional<JacobianVerdict> filtered_jacobian_verdict(const Hexahedron& corners) {
  expect_finite(corners);
  std::array<Vector3<double>, 8> points{};
  std::transform(corners.begin(), corners.end(), points.begin(), [](const Point3& p) {
    return Vector3<double>{p.x, p.y, p.z};
  });
  const EdgeVectors<double> edges = edge_vectors(points);
  DeterminantFilter filter;
  for (const auto& direction : edges)
    for (const auto& edge : direction) filter.include(edge);

  const Coefficients<double> sums = determinant_sums(edges);
  const auto has_sign = [&](std::size_t i, Sign sign) {
    return filter.sign(sums[i], determinants_in(i)) == sign;
  };
  bool proven_positive = true;
  for (std::size_t i = 0; i < sums.size() && proven_positive; ++i)
    proven_positive = has_sign(i, Sign::positive);
  if (proven_positive) return JacobianVerdict{Positivity::positive, false};
  for (const std::size_t i : kCornerCoefficients)
    if (has_sign(i, Sign::negative)) return JacobianVerdict{Positivity::not_positive, true};
  return std::nullopt;
}

}  // namespace hexatlas::exact
