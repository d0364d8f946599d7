#pragma once
/// \file
/// Edges of cells in double precision, for measures of shape and for searches guided by them.
///
/// A direction has relative errors of some 2^-52 in each component of its difference, at any scale
/// of the coordinates; so a determinant of three directions errs by less than 2^-46, and so does a
/// sum of three divided by three.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "meshing/mesh/mesh.hpp"
#include "realize/exact/orientation.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::quality {

[[nodiscard]] inline double determinant(const mesh::Point& a, const mesh::Point& b,
                                        const mesh::Point& c) {
  return a.x * (b.y * c.z - b.z * c.y) + b.x * (c.y * a.z - c.z * a.y) +
         c.x * (a.y * b.z - a.z * b.y);
}

/// s (to - from).
[[nodiscard]] inline mesh::Point scaled_difference(const mesh::Point& from, const mesh::Point& to,
                                                   double s) {
  return {s * to.x - s * from.x, s * to.y - s * from.y, s * to.z - s * from.z};
}

[[nodiscard]] inline double greatest_component(const mesh::Point& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// to - from, divided by its length; zero if they are equal.
[[nodiscard]] inline mesh::Point direction(const mesh::Point& from, const mesh::Point& to) {
  mesh::Point d = scaled_difference(from, to, 1);
  double squared = d.x * d.x + d.y * d.y + d.z * d.z;
  if (!(squared > 0x1p-900 && squared < 0x1p900)) {
    if (std::isinf(greatest_component(d))) d = scaled_difference(from, to, 0.5);
    const double greatest = greatest_component(d);
    if (greatest == 0) return {};
    d = {d.x / greatest, d.y / greatest, d.z / greatest};
    squared = d.x * d.x + d.y * d.y + d.z * d.z;
  }
  const double length = std::sqrt(squared);
  return {d.x / length, d.y / length, d.z / length};
}

/// A factor by which lengths of edges between these points do not overflow.
template <std::size_t kCount>
[[nodiscard]] double scale_for_lengths(const std::array<mesh::Point, kCount>& points) {
  double greatest = 0;
  for (const mesh::Point& p : points) greatest = std::max(greatest, greatest_component(p));
  return greatest > 0x1p1000 ? 0.25 : 1;
}

[[nodiscard]] inline double length(const mesh::Point& from, const mesh::Point& to, double scale) {
  const mesh::Point d = scaled_difference(from, to, scale);
  const double squared = d.x * d.x + d.y * d.y + d.z * d.z;
  if (squared > 0x1p-900 && squared < 0x1p900) return std::sqrt(squared);
  return std::hypot(d.x, d.y, d.z);
}

[[nodiscard]] inline exact::Point3 exact_point(const mesh::Point& p) { return {p.x, p.y, p.z}; }

template <std::size_t kCount>
[[nodiscard]] std::array<exact::Point3, kCount> exact_points(
    const std::array<mesh::Point, kCount>& points) {
  std::array<exact::Point3, kCount> result{};
  std::transform(points.begin(), points.end(), result.begin(), exact_point);
  return result;
}

/// A measure of the corner a with the edges to b, c, d: its sign is that of their orientation,
/// exactly. `estimate` has that sign, or errs by less than 2^-46; where it might not, integers
/// decide.
[[nodiscard]] inline double signed_measure(double measure, double estimate, const mesh::Point& a,
                                           const mesh::Point& b, const mesh::Point& c,
                                           const mesh::Point& d) {
  double sign = estimate;
  if (!(std::abs(estimate) > 0x1p-40))
    sign = static_cast<double>(
        exact::sign_of_orientation(exact_point(a), exact_point(b), exact_point(c), exact_point(d)));
  if (sign == 0) return 0;
  const double size = std::clamp(std::abs(measure), std::numeric_limits<double>::min(), 1.0);
  return std::copysign(size, sign);
}

}  // namespace hexatlas::quality
