#pragma once
/// \file
/// The determinant of an in-sphere test as a sum over four points, and its ties. Private to
/// realize/exact.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>

#include "enum/core/checks.hpp"
#include "realize/exact/determinant.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// e, a, b, c, d: what is subtracted comes first.
using FivePoints = std::array<Point3, 5>;

/// Of points whose coordinates are not too far from 1 for an error bound.
struct ModerateDifferences {
  std::array<Vector3<double>, 4> edges;  ///< a - e, b - e, c - e, d - e, rounded
  double box;  ///< fl(fl(XY)Z) for the greatest absolute values X, Y, Z of their coordinates
};

/// nullopt unless 2^-180 <= X, Y, Z <= 2^180.
[[nodiscard]] inline std::optional<ModerateDifferences> moderate_differences(
    const FivePoints& points) noexcept {
  constexpr double kLeast = 0x1p-180;
  constexpr double kGreatest = 0x1p180;
  ModerateDifferences result{};
  double x = 0;
  double y = 0;
  double z = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3& p = points[i + 1];
    Vector3<double>& v = result.edges[i];
    v = difference<double>({p.x, p.y, p.z}, {points[0].x, points[0].y, points[0].z});
    x = std::max(x, std::abs(v.x));
    y = std::max(y, std::abs(v.y));
    z = std::max(z, std::abs(v.z));
  }
  if (!(std::min({x, y, z}) >= kLeast && std::max({x, y, z}) <= kGreatest)) return std::nullopt;
  result.box = x * y * z;
  return result;
}

[[nodiscard]] inline double greatest(const std::array<double, 4>& values) noexcept {
  return std::max({values[0], values[1], values[2], values[3]});
}

/// Neither D nor the D_p change if all points are moved so that e is the origin, and the heights
/// by the same amount so that that of e is zero. Then D is the sum of height[i] factor[i]; the
/// factors are D_a, D_b, D_c, D_d.
template <class Number>
struct Expansion {
  std::array<typename Degrees<Number>::Two, 4> height;
  std::array<typename Degrees<Number>::Three, 4> factor;
};

/// From a - e, b - e, c - e, d - e, with their squared lengths as heights.
template <class Number>
[[nodiscard]] Expansion<Number> expansion(const std::array<Vector3<Number>, 4>& v) {
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
[[nodiscard]] typename Degrees<Number>::Five value(const Expansion<Number>& e) {
  return e.height[0] * e.factor[0] + e.height[1] * e.factor[1] + e.height[2] * e.factor[2] +
         e.height[3] * e.factor[3];
}

/// The sign of D, and, if that is zero, those of D_e, D_a, D_b, D_c, D_d.
struct SphereSigns {
  Sign in_sphere;
  std::array<Sign, 5> by_height;
};

template <class Number>
[[nodiscard]] SphereSigns sphere_signs(const Expansion<Number>& terms) {
  SphereSigns result{sign_of(value(terms)), {}};
  if (result.in_sphere != Sign::zero) return result;
  const auto& f = terms.factor;
  const typename Degrees<Number>::Three sum = f[0] + f[1] + f[2] + f[3];
  result.by_height = {opposite(sign_of(sum)), sign_of(f[0]), sign_of(f[1]), sign_of(f[2]),
                      sign_of(f[3])};
  return result;
}

/// The sign of the last point in lexicographic order that has one. If two points are equal, no
/// other point has one, so all such cases are found.
[[nodiscard]] inline Sign sign_of_tie(const FivePoints& points,
                                      const std::array<Sign, 5>& by_height) {
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

}  // namespace hexatlas::exact
