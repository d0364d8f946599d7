#include "meshing/hexahedrize/angles.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "enum/core/checks.hpp"
#include "meshing/quality/edge.hpp"

namespace hexatlas::hexahedrize {
namespace {

using flips::Peeling;
using mesh::Point;

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Point midpoint(const Point& a, const Point& b) {
  return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
}

/// Perpendicular to the edge d of a quad, into the quad; not of length 1.
Point into_quad(const Peeling& peeling, std::span<const Point> points, Peeling::Dart d) {
  const auto at = [&](Peeling::Dart of) { return points[peeling.origin(of)]; };
  const Peeling::Dart across = Peeling::opposite(d);
  const Point edge = quality::direction(at(d), at(Peeling::next(d)));
  const Point inward = quality::direction(midpoint(at(d), at(Peeling::next(d))),
                                          midpoint(at(across), at(Peeling::next(across))));
  const double along = dot(edge, inward);
  return {inward.x - along * edge.x, inward.y - along * edge.y, inward.z - along * edge.z};
}

/// From the quad of d through the inside to that of its twin.
std::int16_t angle_at(const Peeling& peeling, std::span<const Point> points, Peeling::Dart d) {
  constexpr double kLeast = 1e-9;  // of a sine, so that roundings do not count
  const Point edge =
      quality::direction(points[peeling.origin(d)], points[peeling.origin(Peeling::next(d))]);
  const Point here = into_quad(peeling, points, d);
  const Point there = into_quad(peeling, points, peeling.twin(d));
  const double sine = -quality::determinant(edge, here, there);
  const double cosine = dot(here, there);
  if (!(std::hypot(sine, cosine) > kLeast)) return flips::kFlatAngle;
  const auto angle = std::lround(std::atan2(sine, cosine) * (180 / std::numbers::pi));
  return static_cast<std::int16_t>(angle < 0 ? angle + flips::kFullTurn : angle);
}

}  // namespace

flips::Angles interior_angles(const Peeling& peeling, std::span<const Point> points) {
  core::expects(peeling.taken().empty() && points.size() == peeling.vertices(),
                "interior_angles: a point for each vertex of a surface");
  flips::Angles angles;
  for (Peeling::Dart d = 0; d < 4 * peeling.quad_numbers(); ++d)
    angles.push_back(angle_at(peeling, points, d));
  return angles;
}

}  // namespace hexatlas::hexahedrize
