#include "realize/exact/jacobian.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/jacobian_coefficients.hpp"
#include "realize/exact/jacobian_lanes.hpp"

namespace hexatlas::exact {
namespace {

using Coefficients = JacobianNumbers<Integer>;

/// The coefficients of J times a positive number.
Coefficients integer_coefficients(const Hexahedron& corners) {
  Coefficients result = determinant_sums(edge_vectors(scaled_integers(corners)));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] *= 8 / determinants_in(i);
  return result;
}

void append_eighths(const Coefficients& whole, std::vector<Coefficients>& parts) {
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

bool all_positive(const Coefficients& part) {
  return std::all_of(part.begin(), part.end(), [](const Integer& c) { return c > 0; });
}

bool some_corner_not_positive(const Coefficients& part) {
  return std::any_of(kCornerCoefficients.begin(), kCornerCoefficients.end(),
                     [&part](std::size_t i) { return part[i] <= 0; });
}

/// Breadth first, so that a refutation is found at the least depth that has one.
Positivity positivity(const Coefficients& whole, int depth) {
  std::vector<Coefficients> parts{whole};
  for (int level = 0;; ++level) {
    parts.erase(std::remove_if(parts.begin(), parts.end(), all_positive), parts.end());
    if (parts.empty()) return Positivity::positive;
    if (std::any_of(parts.begin(), parts.end(), some_corner_not_positive))
      return Positivity::not_positive;
    if (level == depth) return Positivity::undecided;
    std::vector<Coefficients> smaller;
    smaller.reserve(8 * parts.size());
    for (const auto& part : parts) append_eighths(part, smaller);
    parts = std::move(smaller);
  }
}

}  // namespace

std::array<Sign, kJacobianCoefficients> signs_of_jacobian_coefficients(const Hexahedron& corners) {
  expect_finite(corners);
  const Coefficients coefficients = integer_coefficients(corners);
  std::array<Sign, kJacobianCoefficients> signs{};
  std::transform(coefficients.begin(), coefficients.end(), signs.begin(), sign_of);
  return signs;
}

JacobianVerdict exact_jacobian_verdict(const Hexahedron& corners, int depth) {
  expect_finite(corners);
  core::expects(depth >= 0 && depth <= kMaxSubdivisionDepth, "exact: subdivision depth in [0, 8]");
  const Coefficients coefficients = integer_coefficients(corners);
  if (some_corner_not_positive(coefficients)) return {Positivity::not_positive, true};
  return {positivity(coefficients, depth), false};
}

bool corners_exceed(const Hexahedron& corners, double threshold) {
  expect_finite(corners);
  core::expects(threshold >= 0 && threshold < 1, "exact: a threshold in [0, 1)");
  const EdgeVectors<Integer> edges = edge_vectors(scaled_integers(corners));
  const BinaryParts parts = binary_parts(threshold);  // threshold = mantissa 2^exponent
  const Integer mantissa(static_cast<long>(parts.mantissa));
  const auto shift = threshold == 0 ? 0UL : 2 * static_cast<unsigned long>(-parts.exponent);
  for (unsigned v = 0; v < 8; ++v) {
    const unsigned i = v & 1U;
    const unsigned j = v >> 1U & 1U;
    const unsigned k = v >> 2U;
    const Vector3<Integer>& a = edges[0][j + 2 * k];
    const Vector3<Integer>& b = edges[1][i + 2 * k];
    const Vector3<Integer>& c = edges[2][i + 2 * j];
    const Integer jacobian = determinant(a, b, c);
    if (jacobian <= 0) return false;
    const Integer bound = mantissa * mantissa * dot(a, a) * dot(b, b) * dot(c, c);
    if (Integer(jacobian * jacobian << shift) <= bound) return false;
  }
  return true;
}

std::optional<JacobianVerdict> filtered_jacobian_verdict(const Hexahedron& corners) {
  std::optional<JacobianVerdict> verdict;
  filtered_jacobian_verdicts({&corners, 1}, {&verdict, 1});
  return verdict;
}

void filtered_jacobian_verdicts(std::span<const Hexahedron> hexahedra,
                                std::span<std::optional<JacobianVerdict>> verdicts) {
  core::expects(hexahedra.size() == verdicts.size(), "exact: a verdict for each hexahedron");
  static const FourJacobians kFourJacobians = four_jacobians();
  for (std::size_t first = 0; first < hexahedra.size(); first += 4) {
    const std::size_t count = std::min<std::size_t>(4, hexahedra.size() - first);
    const auto corners = [&](std::size_t lane) {  // the last hexahedron fills the lanes left
      return hexahedra[first + std::min(lane, count - 1)].data();
    };
    const LaneVerdicts lanes = kFourJacobians(corners(0), corners(1), corners(2), corners(3));
    for (std::size_t lane = 0; lane < count; ++lane) {
      std::optional<JacobianVerdict>& verdict = verdicts[first + lane];
      verdict.reset();
      if ((lanes.overflow >> lane & 1U) != 0) expect_finite(hexahedra[first + lane]);
      if ((lanes.positive >> lane & 1U) != 0) verdict = {Positivity::positive, false};
      if ((lanes.corner_negative >> lane & 1U) != 0) verdict = {Positivity::not_positive, true};
    }
  }
}

}  // namespace hexatlas::exact
