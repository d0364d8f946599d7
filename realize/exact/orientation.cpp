#include "realize/exact/orientation.hpp"

#include <array>
#include <optional>

#include "realize/exact/determinant.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/limb_points.hpp"

namespace hexatlas::exact {
namespace {

using Tetrahedron = std::array<Point3, 4>;

std::optional<Sign> filtered(const Tetrahedron& points) {
  std::array<Vector3<double>, 3> edges{};
  DeterminantFilter filter;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = points[i + 1];
    edges[i] = difference<double>({p.x, p.y, p.z}, {points[0].x, points[0].y, points[0].z});
    filter.include(edges[i]);
  }
  return filter.sign(determinant(edges[0], edges[1], edges[2]), 1);
}

template <class Number>
Sign sign_of_edges(const std::array<Vector3<Number>, 3>& edges) {
  return sign_of(determinant(edges[0], edges[1], edges[2]));
}

Sign exact_sign(const Tetrahedron& points) {
  if (const auto edges = one_limb_differences(points)) return sign_of_edges(*edges);
  expect_finite(points);
  const TakenApart apart(points);
  if (const auto edges = apart.differences<1>()) return sign_of_edges(*edges);
  if (const auto edges = apart.differences<2>()) return sign_of_edges(*edges);
  const auto p = scaled_integers(points);
  return sign_of_edges<Integer>(
      {difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0])});
}

}  // namespace

std::optional<Sign> filtered_sign_of_orientation(const Point3& a, const Point3& b, const Point3& c,
                                                 const Point3& d) {
  const Tetrahedron points{a, b, c, d};
  expect_finite(points);
  return filtered(points);
}

Sign sign_of_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Tetrahedron points{a, b, c, d};
  const std::optional<Sign> sign = filtered(points);
  return sign ? *sign : exact_sign(points);
}

}  // namespace hexatlas::exact
