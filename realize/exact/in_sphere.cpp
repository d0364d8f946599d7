#include "realize/exact/in_sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "enum/core/checks.hpp"
#include "realize/exact/determinant.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/limb_points.hpp"

namespace hexatlas::exact {
namespace {

/// e, a, b, c, d: what is subtracted comes first.
using FivePoints = std::array<Point3, 5>;

/// Neither D nor the D_p change if all points are moved so that e is the origin, and then D is the
/// sum of square[i] factor[i]; the factors are D_a, D_b, D_c, D_d.
template <class Number>
struct Expansion {
  std::array<typename Degrees<Number>::Two, 4> square;
  std::array<typename Degrees<Number>::Three, 4> factor;
};

/// From a - e, b - e, c - e, d - e.
template <class Number>
Expansion<Number> expansion(const std::array<Vector3<Number>, 4>& v) {
  using Two = typename Degrees<Number>::Two;
  const auto& [a, b, c, d] = v;
  const auto minor = [](const Vector3<Number>& p, const Vector3<Number>& q) -> Two {
    return p.x * q.y - p.y * q.x;
  };
  const Two ab = minor(a, b);
  const Two ac = minor(a, c);
  const Two ad = minor(a, d);
  const Two bc = minor(b, c);
  const Two bd = minor(b, d);
  const Two cd = minor(c, d);
  return {{a.x * a.x + a.y * a.y + a.z * a.z, b.x * b.x + b.y * b.y + b.z * b.z,
           c.x * c.x + c.y * c.y + c.z * c.z, d.x * d.x + d.y * d.y + d.z * d.z},
          {b.z * cd - c.z * bd + d.z * bc, c.z * ad - a.z * cd - d.z * ac,
           a.z * bd - b.z * ad + d.z * ab, b.z * ac - a.z * bc - c.z * ab}};
}

template <class Number>
typename Degrees<Number>::Five value(const Expansion<Number>& e) {
  return e.square[0] * e.factor[0] + e.square[1] * e.factor[1] + e.square[2] * e.factor[2] +
         e.square[3] * e.factor[3];
}

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
  constexpr double kLeast = 0x1p-180;
  constexpr double kGreatest = 0x1p180;
  constexpr double kError = 0x1p-44;
  std::array<Vector3<double>, 4> v{};
  double x = 0;
  double y = 0;
  double z = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3& p = points[i + 1];
    v[i] = difference<double>({p.x, p.y, p.z}, {points[0].x, points[0].y, points[0].z});
    x = std::max(x, std::abs(v[i].x));
    y = std::max(y, std::abs(v[i].y));
    z = std::max(z, std::abs(v[i].z));
  }
  if (!(std::min({x, y, z}) >= kLeast && std::max({x, y, z}) <= kGreatest)) return std::nullopt;
  const Expansion<double> terms = expansion(v);
  const double square =
      std::max({terms.square[0], terms.square[1], terms.square[2], terms.square[3]});
  const double bound = kError * (x * y * z * square);
  const double sum = value(terms);
  if (sum > bound) return Sign::positive;
  if (sum < -bound) return Sign::negative;
  return std::nullopt;
}

/// The sign of D, and, if that is zero, those of D_e, D_a, D_b, D_c, D_d.
struct Signs {
  Sign in_sphere;
  std::array<Sign, 5> by_height;
};

template <class Number>
Signs signs(const std::array<Vector3<Number>, 4>& v) {
  const Expansion<Number> terms = expansion(v);
  Signs result{sign_of(value(terms)), {}};
  if (result.in_sphere != Sign::zero) return result;
  const auto& f = terms.factor;
  const typename Degrees<Number>::Three sum = f[0] + f[1] + f[2] + f[3];
  result.by_height = {opposite(sign_of(sum)), sign_of(f[0]), sign_of(f[1]), sign_of(f[2]),
                      sign_of(f[3])};
  return result;
}

Signs exact_signs(const FivePoints& points) {
  if (const auto edges = one_limb_differences(points)) return signs(*edges);
  expect_finite(points);
  const TakenApart apart(points);
  if (const auto edges = apart.differences<1>()) return signs(*edges);
  if (const auto edges = apart.differences<2>()) return signs(*edges);
  const auto p = scaled_integers(points);
  return signs<Integer>({difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0]),
                         difference(p[4], p[0])});
}

/// The sign of the last point in lexicographic order that has one. If two points are equal, no
/// other point has one, so all such cases are found.
Sign sign_of_tie(const FivePoints& points, const std::array<Sign, 5>& by_height) {
  const auto place = [&](std::size_t i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::size_t last = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (by_height[i] == Sign::zero) continue;
    if (last == points.size() || place(last) < place(i))
      last = i;
    else
      core::expects(place(i) < place(last), "exact: two points are equal");
  }
  return last == points.size() ? Sign::zero : by_height[last];
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
  if (sign) return *sign;
  const Signs exact = exact_signs(points);
  return exact.in_sphere != Sign::zero ? exact.in_sphere : sign_of_tie(points, exact.by_height);
}

}  // namespace hexatlas::exact
