#include "realize/exact/in_orthosphere.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "enum/core/checks.hpp"
#include "realize/exact/binary.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/limb_points.hpp"
#include "realize/exact/limbs.hpp"
#include "realize/exact/sphere_expansion.hpp"

namespace hexatlas::exact {
namespace {

/// In the order of FivePoints.
struct FiveWeighted {
  FivePoints places;
  std::array<double, 5> weights;
};

FiveWeighted five(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                  const WeightedPoint3& d, const WeightedPoint3& e) {
  return {{e.place, a.place, b.place, c.place, d.place},
          {e.weight, a.weight, b.weight, c.weight, d.weight}};
}

void expect_finite(const FiveWeighted& points) {
  expect_finite(points.places);
  core::expects(std::all_of(points.weights.begin(), points.weights.end(),
                            [](double w) { return std::isfinite(w); }),
                "exact: weights must be finite");
}

/// From squared lengths to heights: the weights less that of e are taken off.
template <class Number>
void lower(Expansion<Number>& terms, const std::array<typename Degrees<Number>::Two, 4>& weights) {
  for (std::size_t i = 0; i < 4; ++i) terms.height[i] = terms.height[i] - weights[i];
}

/// Claim. Let X, Y, Z be the greatest absolute values of the coordinates of the four computed
/// differences, S the greatest computed squared length, and V the greatest absolute value of the
/// four computed differences of weights. If 2^-180 <= X, Y, Z <= 2^180 and V <= 2^360, the computed
/// value differs from D by at most 2^-44 fl(fl(fl(XY)Z) fl(S + V)).
///
/// Proof. u, h, P = XYZ, T >= 2^-360 as in realize/exact/in_sphere.cpp; H = T + V.
/// (1) D is a sum of products of five true differences of coordinates, or of three of them and one
///     of weights. A difference of doubles has no error by underflow. So each product is that of
///     the computed ones divided by at most five factors 1 + d, |d| <= u. The absolute values of
///     the latter add up to at most 4 * 6 P T + 4 * 6 P V, so D differs from its value for the
///     computed differences by at most 5.01 u * 24 P H <= 120.3 u P H.
/// (2) As there, a factor errs by at most 28.13 u P and is at most 6.04 P.
/// (3) A square errs by at most 3.02 u T; it is at most (1 + 3.02 u) T, so taking off a difference
///     of weights errs by at most 1.01 u H more: a height by at most 4.03 u H.
/// (4) A product of these two errs by at most 4.03 u H 6.04 P + H 28.13 u P + 6.05 u P H + h
///     <= 58.6 u P H, since h <= 2^-175 P T: four of them by 234.4 u P H. Each is at most 6.05 P H,
///     so the three additions err by at most 6.06 (2 + 3 + 4) u P H <= 54.6 u P H.
/// (5) In sum 410 u P H. The bound is at least 512 u (1 - u)^4 P (1 - 3.02 u) H. Nothing overflows,
///     since 25 P H <= 100 2^900.
std::optional<Sign> filtered(const FiveWeighted& points) {
  constexpr double kError = 0x1p-44;
  constexpr double kGreatest = 0x1p360;
  const auto computed = moderate_differences(points.places);
  if (!computed) return std::nullopt;
  std::array<double, 4> weights{};
  for (std::size_t i = 0; i < 4; ++i) weights[i] = points.weights[i + 1] - points.weights[0];
  const double weight = greatest(
      {std::abs(weights[0]), std::abs(weights[1]), std::abs(weights[2]), std::abs(weights[3])});
  if (!(weight <= kGreatest)) return std::nullopt;
  Expansion<double> terms = expansion(computed->edges);
  const double bound = kError * (computed->box * (greatest(terms.height) + weight));
  lower(terms, weights);
  const double sum = value(terms);
  if (sum > bound) return Sign::positive;
  if (sum < -bound) return Sign::negative;
  return std::nullopt;
}

/// The greatest k for which all weights are multiples of 2^(2k); the greatest int if all are zero.
int unit_exponent_of(const std::array<double, 5>& weights) noexcept {
  int unit = std::numeric_limits<int>::max();
  for (const double w : weights)
    // Rounded down, whatever the sign.
    if (w != 0) unit = std::min(unit, binary_parts(w).exponent >> 1);
  return unit;
}

/// Differences to the first weight, divided by 2^(2 unit): below 2^124, so that heights of
/// differences of one limb are below 4 2^124 and fit as squared lengths do (limbs.hpp). nullopt if
/// a weight is too great. Requires that the weights are multiples.
std::optional<std::array<Limbs<2>, 4>> limb_differences(const std::array<double, 5>& weights,
                                                        int unit) noexcept {
  constexpr int kBits = 123;
  std::array<Wide, 5> integers{};
  for (std::size_t i = 0; i < 5; ++i) {
    if (weights[i] == 0) continue;
    const BinaryParts parts = binary_parts(weights[i]);
    const int shift = parts.exponent - 2 * unit;
    const auto magnitude = static_cast<std::uint64_t>(std::abs(parts.mantissa));
    if (shift + static_cast<int>(std::bit_width(magnitude)) > kBits) return std::nullopt;
    const Wide integer = static_cast<Wide>(UnsignedWide{magnitude} << static_cast<unsigned>(shift));
    integers[i] = weights[i] < 0 ? -integer : integer;
  }
  std::array<Limbs<2>, 4> result{};
  for (std::size_t i = 0; i < 4; ++i)
    result[i].set_pair(0, static_cast<UnsignedWide>(integers[i + 1] - integers[0]));
  return result;
}

SphereSigns exact_signs(const FiveWeighted& points) {
  expect_finite(points);
  const int greatest_unit = unit_exponent_of(points.weights);
  const TakenApart apart(points.places, greatest_unit);
  if (const auto edges = apart.differences<1>())
    if (const auto weights = limb_differences(points.weights, apart.unit())) {
      Expansion<Limbs<1>> terms = expansion(*edges);
      lower(terms, *weights);
      return sphere_signs(terms);
    }
  const int unit = apart.unit();
  const auto p = scaled_integers(points.places, unit);
  Expansion<Integer> terms = expansion<Integer>({difference(p[1], p[0]), difference(p[2], p[0]),
                                                 difference(p[3], p[0]), difference(p[4], p[0])});
  std::array<Integer, 4> weights;
  const Integer first = scaled_integer(points.weights[0], 2 * unit);
  for (std::size_t i = 0; i < 4; ++i)
    weights[i] = scaled_integer(points.weights[i + 1], 2 * unit) - first;
  lower(terms, weights);
  return sphere_signs(terms);
}

}  // namespace

std::optional<Sign> filtered_sign_of_in_orthosphere(const WeightedPoint3& a,
                                                    const WeightedPoint3& b,
                                                    const WeightedPoint3& c,
                                                    const WeightedPoint3& d,
                                                    const WeightedPoint3& e) {
  const FiveWeighted points = five(a, b, c, d, e);
  expect_finite(points);
  return filtered(points);
}

Sign sign_of_in_orthosphere(const WeightedPoint3& a, const WeightedPoint3& b,
                            const WeightedPoint3& c, const WeightedPoint3& d,
                            const WeightedPoint3& e) {
  const FiveWeighted points = five(a, b, c, d, e);
  const std::optional<Sign> sign = filtered(points);
  return sign ? *sign : exact_signs(points).in_sphere;
}

Sign sign_of_perturbed_in_orthosphere(const WeightedPoint3& a, const WeightedPoint3& b,
                                      const WeightedPoint3& c, const WeightedPoint3& d,
                                      const WeightedPoint3& e) {
  const FiveWeighted points = five(a, b, c, d, e);
  const std::optional<Sign> sign = filtered(points);
  if (sign) return *sign;
  const SphereSigns exact = exact_signs(points);
  return exact.in_sphere != Sign::zero ? exact.in_sphere
                                       : sign_of_tie(points.places, exact.by_height);
}

}  // namespace hexatlas::exact
