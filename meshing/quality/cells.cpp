#include "meshing/quality/cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "meshing/quality/edge.hpp"
#include "meshing/quality/vector.hpp"
#include "meshing/quality/verdict.hpp"
#include "realize/exact/prism.hpp"

namespace hexatlas::quality {
namespace {

using mesh::Point;

template <class Cell>
Verdict verdict_of(const Cell& cell) {
  const std::optional<exact::JacobianVerdict> filtered = exact::filtered_jacobian_verdict(cell);
  return verdict_from(filtered ? *filtered : exact::exact_jacobian_verdict(cell),
                      !filtered.has_value());
}

/// The normal of the triangle a b c, as long as the sum of the sines of its angles.
Point sine_normal(const Point& a, const Point& b, const Point& c) {
  const Point ab = direction(a, b);
  const Point bc = direction(b, c);
  const Point ca = direction(c, a);
  const Point at_a = cross(ca, ab);
  const Point at_b = cross(ab, bc);
  const Point at_c = cross(bc, ca);
  return {at_a.x + at_b.x + at_c.x, at_a.y + at_b.y + at_c.y, at_a.z + at_b.z + at_c.z};
}

struct Edge {
  Point direction;
  double length;
};

/// The measure of a pyramid at a corner of the base, without sign.
double pyramid_measure(const Edge& u, const Edge& v, const Edge& w, double determinant) {
  const double longest = std::max({u.length, v.length, w.length});
  if (longest == 0) return 0;
  const double a = u.length / longest;
  const double b = v.length / longest;
  const double c = w.length / longest;
  const auto raised = [&](double at_u, double at_v, double at_w) {
    return c * at_w - (a * at_u + b * at_v) / 2;
  };
  const Point z{raised(u.direction.x, v.direction.x, w.direction.x),
                raised(u.direction.y, v.direction.y, w.direction.y),
                raised(u.direction.z, v.direction.z, w.direction.z)};
  const double root = std::cbrt(std::numbers::sqrt2 * std::abs(determinant) * a * b * c);
  return 3 * root * root / (a * a + b * b + 2 * dot(z, z));
}

}  // namespace

Verdict verdict_of_tetrahedron(const TetrahedronCorners& corners) {
  const auto p = exact_points(corners);
  const auto filtered = exact::filtered_sign_of_orientation(p[0], p[1], p[2], p[3]);
  const exact::Sign sign = filtered ? *filtered : sign_of_orientation(p[0], p[1], p[2], p[3]);
  const bool valid = sign == exact::Sign::positive;
  return {valid ? Validity::valid : Validity::invalid, !valid, !filtered.has_value()};
}

Verdict verdict_of_prism(const PrismCorners& corners) { return verdict_of(exact_points(corners)); }

Verdict verdict_of_pyramid(const PyramidCorners& corners) {
  return verdict_of(exact_points(corners));
}

double scaled_jacobian(const TetrahedronCorners& p) {
  const Point d01 = direction(p[0], p[1]);
  const Point d02 = direction(p[0], p[2]);
  const Point d03 = direction(p[0], p[3]);
  const Point d12 = direction(p[1], p[2]);
  const Point d13 = direction(p[1], p[3]);
  const Point d23 = direction(p[2], p[3]);
  double least = determinant(d01, d02, d03);
  for (const double other :
       {determinant(d01, d12, d13), determinant(d02, d12, d23), determinant(d03, d13, d23)})
    if (std::abs(other) < std::abs(least)) least = other;
  return signed_measure(std::numbers::sqrt2 * least, least, p[0], p[1], p[2], p[3]);
}

double scaled_jacobian(const PrismCorners& p) {
  constexpr double kEquilateral = 2 / (3 * std::numbers::sqrt3);
  const Point bottom = sine_normal(p[0], p[1], p[2]);
  const Point top = sine_normal(p[3], p[4], p[5]);
  double least = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const std::size_t previous = (i + 2) % 3;
    const Point lateral = direction(p[i], p[i + 3]);
    const double low = kEquilateral * dot(bottom, lateral);
    const double high = kEquilateral * dot(top, lateral);
    least = std::min(least, signed_measure(low, low, p[i], p[next], p[previous], p[i + 3]));
    // Seen from the top the lateral edge points down: the triangle is read backwards.
    least =
        std::min(least, signed_measure(high, high, p[i + 3], p[previous + 3], p[next + 3], p[i]));
  }
  return least;
}

double scaled_jacobian(const PyramidCorners& p) {
  const double scale = scale_for_lengths(p);
  const auto edge = [&](std::size_t from, std::size_t to) {
    return Edge{direction(p[from], p[to]), length(p[from], p[to], scale)};
  };
  const std::array<Edge, 4> base{edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0)};
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const std::size_t previous = (i + 3) % 4;
    const Edge& u = base[i];
    Edge v = base[previous];
    v.direction = {-v.direction.x, -v.direction.y, -v.direction.z};
    const Edge w = edge(i, 4);
    const double estimate = determinant(u.direction, v.direction, w.direction);
    least = std::min(least, signed_measure(pyramid_measure(u, v, w, estimate), estimate, p[i],
                                           p[next], p[previous], p[4]));
  }
  return least;
}

bool exceeds(const PrismCorners& p, double shape, double threshold) {
  // The factor times three determinants of directions: an error below 2^-45 (edge.hpp).
  constexpr double kError = 0x1p-44;
  if (std::abs(shape - threshold) > kError) return shape > threshold;
  return exact::corners_exceed(exact_points(p), threshold);
}

bool exceeds(const PyramidCorners& p, double shape, double threshold) {
  // |x^(2/3) - y^(2/3)| <= |x - y|^(2/3), the determinant errs by less than 2^-46, and the divisor
  // is at least 1, the longest edge being 1: |u|^2 + |v|^2 >= 2 |m|^2 with m = (u + v) / 2, and
  // 2 |m|^2 + 2 |w - m|^2 >= |w|^2. So the error is below 3 (sqrt 2 2^-46)^(2/3) < 2^-28, which
  // leaves room for some 2^-46 by the rounding of all else.
  constexpr double kError = 0x1p-27;
  if (std::abs(shape - threshold) > kError) return shape > threshold;
  return exact::corners_exceed(exact_points(p), threshold);
}

}  // namespace hexatlas::quality
