#include "meshing/quality/hexahedron.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "enum/core/errors.hpp"
#include "realize/exact/jacobian.hpp"

namespace hexatlas::quality {
namespace {

Validity validity_from(exact::Positivity positivity) {
  switch (positivity) {
    case exact::Positivity::positive:
      return Validity::valid;
    case exact::Positivity::not_positive:
      return Validity::invalid;
    case exact::Positivity::undecided:
      return Validity::undecided;
  }
  throw core::InternalError("quality: unknown positivity");
}

/// s (to - from).
mesh::Point scaled_difference(const mesh::Point& from, const mesh::Point& to, double s) {
  return {s * to.x - s * from.x, s * to.y - s * from.y, s * to.z - s * from.z};
}

double greatest_component(const mesh::Point& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// to - from, divided by its length; zero if they are equal.
mesh::Point direction(const mesh::Point& from, const mesh::Point& to) {
  mesh::Point d = scaled_difference(from, to, 1);
  if (std::isinf(greatest_component(d))) d = scaled_difference(from, to, 0.5);
  const double greatest = greatest_component(d);
  if (greatest == 0) return {};
  d = {d.x / greatest, d.y / greatest, d.z / greatest};
  const double length = std::hypot(d.x, d.y, d.z);
  return {d.x / length, d.y / length, d.z / length};
}

double determinant(const mesh::Point& a, const mesh::Point& b, const mesh::Point& c) {
  return a.x * (b.y * c.z - b.z * c.y) + b.x * (c.y * a.z - c.z * a.y) +
         c.x * (a.y * b.z - a.z * b.y);
}

}  // namespace

Verdict verdict_of_hexahedron(const Corners& corners) {
  exact::Hexahedron hexahedron{};
  std::transform(corners.begin(), corners.end(), hexahedron.begin(), [](const mesh::Point& p) {
    return exact::Point3{p.x, p.y, p.z};
  });
  const std::optional<exact::JacobianVerdict> filtered =
      exact::filtered_jacobian_verdict(hexahedron);
  const exact::JacobianVerdict verdict =
      filtered ? *filtered : exact::exact_jacobian_verdict(hexahedron, kSubdivisionDepth);
  return {validity_from(verdict.positivity), verdict.corner_not_positive, !filtered.has_value()};
}

double scaled_jacobian(const Corners& corners) {
  double least = 1;
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const auto edge = [&corners, v](std::size_t bit) {  // in the direction of the axis of `bit`
      return direction(corners[v & ~bit], corners[v | bit]);
    };
    least = std::min(least, determinant(edge(1), edge(2), edge(4)));
  }
  return std::max(least, -1.0);
}

}  // namespace hexatlas::quality
