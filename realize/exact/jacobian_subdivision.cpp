// The verdict of jacobian.hpp by subdivision in double precision.
//
// Claim. With unit as in determinant.hpp, each coefficient of each part, after at most eight
// subdivisions, differs from its real value by less than 2^-44 units.
// Proof. u = 2^-53. A sum of N determinants errs by at most N 2^-46 units, and its division by N, a
// power of two, is exact but for underflow; so a coefficient errs by 2^-46 units and is below 7
// units. De Casteljau's numbers (a + b) / 2 and ((a + 2b) + c) / 4 are means: they inherit the
// greatest error of a, b, c and stay below 7 units, but for roundings, of the second at most (21 +
// 28) u / 4 < 13 u units. In each of three directions of at most eight subdivisions: 312 u units,
// below 2^-44.7; with 2^-46 below 2^-44. Errors by underflow are below 2^-1074 and the unit is
// above 2^-901.
#include <algorithm>

#include "enum/core/checks.hpp"
#include "realize/exact/jacobian_coefficients.hpp"

namespace hexatlas::exact {
namespace {

using Coefficients = JacobianNumbers<double>;

/// What is known of a part; `unknown`: double precision does not suffice.
enum class Outcome : std::uint8_t { positive, not_positive, undecided, unknown };

/// Depth first: which part refutes does not matter.
Outcome judge(const Coefficients& whole, double error, int depth) {
  const double least = *std::min_element(whole.begin(), whole.end());
  if (least > error) return Outcome::positive;
  double corner = whole[0];
  for (const std::size_t i : kCornerCoefficients) corner = std::min(corner, whole[i]);
  if (corner < -error) return Outcome::not_positive;
  if (corner <= error) return Outcome::unknown;
  if (depth == 0) return least < -error ? Outcome::undecided : Outcome::unknown;
  const auto of_part = [&](const Coefficients& part) { return judge(part, 64 * error, depth - 1); };
  Outcome result = Outcome::positive;
  const auto [low_r, high_r] = halves(whole, 0);
  for (const auto& half : {low_r, high_r}) {
    const auto [low_s, high_s] = halves(half, 1);
    for (const auto& quarter : {low_s, high_s}) {
      const auto [low_t, high_t] = halves(quarter, 2);
      for (const Outcome part : {of_part(low_t), of_part(high_t)}) {
        if (part == Outcome::not_positive) return part;
        result = std::max(result, part);
      }
    }
  }
  return result;
}

}  // namespace

std::optional<JacobianVerdict> subdivided_jacobian_verdict(const Hexahedron& corners, int depth) {
  core::expects(depth >= 0 && depth <= kMaxSubdivisionDepth, "exact: subdivision depth in [0, 8]");
  std::array<Vector3<double>, 8> points{};
  std::transform(corners.begin(), corners.end(), points.begin(), [](const Point3& p) {
    return Vector3<double>{p.x, p.y, p.z};
  });
  const EdgeVectors<double> edges = edge_vectors(points);
  DeterminantFilter filter;
  for (const auto& direction : edges)
    for (const auto& edge : direction) filter.include(edge);
  const std::optional<double> unit = filter.unit();
  if (!unit) return std::nullopt;
  Coefficients coefficients = determinant_sums(edges);
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] /= determinants_in(i);
  const double error = 0x1p-44 * *unit;
  for (const std::size_t i : kCornerCoefficients)
    if (coefficients[i] < -error) return JacobianVerdict{Positivity::not_positive, true};
  switch (judge(coefficients, error, depth)) {
    case Outcome::positive:
      return JacobianVerdict{Positivity::positive, false};
    case Outcome::not_positive:
      return JacobianVerdict{Positivity::not_positive, false};
    case Outcome::undecided:
      return JacobianVerdict{Positivity::undecided, false};
    case Outcome::unknown:
      break;
  }
  return std::nullopt;
}

}  // namespace hexatlas::exact
