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

/// D of the header is the sum of square[i] factor[i], since neither D nor the D_p change if the
/// five points are moved, and e is moved to the origin: factor is D_a, D_b, D_c, D_d.
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

/// The sign of D, and, if that is zero, of D_e, D_a, D_b, D_c, D_d.
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
  if (const auto edges = two_limb_differences(points)) return signs(*edges);
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
