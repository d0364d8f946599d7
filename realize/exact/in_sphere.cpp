#include "realize/exact/in_sphere.hpp"

#include <array>

#include "realize/exact/determinant.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/limb_points.hpp"
#include "realize/exact/sphere_expansion.hpp"

namespace hexatlas::exact {
namespace {

/// Claim. Let X, Y, Z be the greatest absolute values of the coordinates of the four computed
/// differences, and S the greatest computed squared length. If 2^-180 <= X, Y, Z <= 2^180, the
/// computed value differs from D by at most 2^-44 fl(fl(fl(XY)Z)S).
///
/// Proof. u, h, P = XYZ as in realize/exact/determinant.hpp; T is the greatest real squared length
/// of the computed differences, so T >= 2^-360. (1) D is a sum of products of five true
/// differences, each the product of the computed ones
///     divided by five factors 1 + d, |d| <= u. The absolute values of the latter add up to at most
///     4 * 6 P T, so D differs from its value for the computed differences by at most
///     5.01 u * 24 P T <= 120.3 u P T.
/// (2) As there, a minor errs by at most 4.01 u XY + 2.01 h, its product with z by at most
///     6.02 u P + 2.01 Z h + h, and a factor, three of these and two additions, by at most
///     28.12 u P + 6.03 Z h + 3.01 h <= 28.13 u P, since h <= 2^-535 P and Z h <= 2^-715 P. It is
///     at most 6.04 P.
/// (3) A square errs by at most 3.01 u T + 3.01 h <= 3.02 u T.
/// (4) A product of these two errs by at most 3.02 u T 6.04 P + T 28.13 u P + 6.05 u P T + h
///     <= 52.5 u P T, since h <= 2^-175 P T: four of them by 210 u P T. Each is at most 6.05 P T,
///     so the three additions err by at most 6.06 (2 + 3 + 4) u P T <= 54.6 u P T.
/// (5) In sum 385 u P T. The bound is at least 512 u (1 - u)^3 P (1 - 3.02 u) T. Nothing overflows,
///     since 25 P T <= 75 2^900.
std::optional<Sign> filtered(const FivePoints& points) {
  constexpr double kError = 0x1p-44;
  const auto computed = moderate_differences(points);
  if (!computed) return std::nullopt;
  const Expansion<double> terms = expansion(computed->edges);
  const double bound = kError * (computed->box * greatest(terms.height));
  const double sum = value(terms);
  if (sum > bound) return Sign::positive;
  if (sum < -bound) return Sign::negative;
  return std::nullopt;
}

template <class Number>
SphereSigns signs(const std::array<Vector3<Number>, 4>& v) {
  return sphere_signs(expansion(v));
}

SphereSigns exact_signs(const FivePoints& points) {
  if (const auto edges = one_limb_differences(points)) return signs(*edges);
  expect_finite(points);
  const TakenApart apart(points);
  if (const auto edges = apart.differences<1>()) return signs(*edges);
  if (const auto edges = apart.differences<2>()) return signs(*edges);
  const auto p = scaled_integers(points);
  return signs<Integer>({difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0]),
                         difference(p[4], p[0])});
}

Sign perturbed_sign(const FivePoints& points) {
  const SphereSigns exact = exact_signs(points);
  return exact.in_sphere != Sign::zero ? exact.in_sphere : sign_of_tie(points, exact.by_height);
}

}  // namespace

std::optional<Sign> filtered_sign_of_in_sphere(const Point3& a, const Point3& b, const Point3& c,
                                               const Point3& d, const Point3& e) {
  const FivePoints points{e, a, b, c, d};
  expect_finite(points);
  return filtered(points);
}

Sign sign_of_in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                       const Point3& e) {
  const FivePoints points{e, a, b, c, d};
  const std::optional<Sign> sign = filtered(points);
  return sign ? *sign : exact_signs(points).in_sphere;
}

Sign sign_of_perturbed_in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                 const Point3& e) {
  const FivePoints points{e, a, b, c, d};
  const std::optional<Sign> sign = filtered(points);
  return sign ? *sign : perturbed_sign(points);
}

Sign unfiltered_sign_of_perturbed_in_sphere(const Point3& a, const Point3& b, const Point3& c,
                                            const Point3& d, const Point3& e) {
  return perturbed_sign({e, a, b, c, d});
}

}  // namespace hexatlas::exact
