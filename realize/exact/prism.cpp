#include "realize/exact/prism.hpp"

#include <algorithm>
#include <cstddef>

#include "realize/exact/determinant.hpp"
#include "realize/exact/integers.hpp"

namespace hexatlas::exact {
namespace {

template <std::size_t kCount>
std::array<Vector3<double>, kCount> vectors(const std::array<Point3, kCount>& points) {
  std::array<Vector3<double>, kCount> result{};
  std::transform(points.begin(), points.end(), result.begin(), [](const Point3& p) {
    return Vector3<double>{p.x, p.y, p.z};
  });
  return result;
}

JacobianVerdict verdict(bool corners_positive, bool inside_positive) {
  return {corners_positive && inside_positive ? Positivity::positive : Positivity::not_positive,
          !corners_positive};
}

/// a and b of the derivation, a' and b', and the v_i.
template <class Number>
struct PrismVectors {
  Vector3<Number> a, b, a_top, b_top;
  std::array<Vector3<Number>, 3> lateral;
};

template <class Number>
PrismVectors<Number> prism_vectors(const std::array<Vector3<Number>, 6>& p) {
  return {difference(p[1], p[0]),
          difference(p[2], p[0]),
          difference(p[4], p[3]),
          difference(p[5], p[3]),
          {difference(p[3], p[0]), difference(p[4], p[1]), difference(p[5], p[2])}};
}

/// J on a lateral edge: low at the bottom, high at the top, and m, twice the middle coefficient.
template <class Number>
struct Quadratic {
  Number low, middle, high;
};

template <class Number>
std::array<Quadratic<Number>, 3> lateral_edges(const PrismVectors<Number>& p) {
  const auto along = [&p](const Vector3<Number>& v) {
    return Quadratic<Number>{determinant(p.a, p.b, v),
                             Number(determinant(p.a, p.b_top, v) + determinant(p.a_top, p.b, v)),
                             determinant(p.a_top, p.b_top, v)};
  };
  return {along(p.lateral[0]), along(p.lateral[1]), along(p.lateral[2])};
}

/// A proof that the polynomial is positive on [0, 1]; `unit` is that of the filter.
///
/// With N determinants in sum, c/unit is known up to N 2^-46, and the quotient, below 8 N in
/// absolute value, up to another 8 N u, u = 2^-53; adding the margin errs by at most 9 N u. So
/// `low` and `high` are at most, and `drop` at least, what they bound. Differences from a margin
/// are 0 or at least 2^-100, so products do not underflow, and 1 + 8u makes up for three roundings.
bool proven_positive(const Quadratic<double>& q, double unit) {
  constexpr double kMargin = 0x1p-45;
  const double low = q.low / unit - kMargin;
  const double high = q.high / unit - kMargin;
  const double drop = std::max(2 * kMargin - q.middle / unit, 0.0);
  return low > 0 && high > 0 && drop * drop * (1 + 0x1p-50) < 4 * (low * high);
}

bool is_positive(const Quadratic<Integer>& q) {
  return q.middle >= 0 || q.middle * q.middle < 4 * q.low * q.high;
}

/// Two edges of the base at each of its corners, and the edge to the apex.
template <class Number>
struct BaseCorner {
  Vector3<Number> next, previous, apex;
};

template <class Number>
std::array<BaseCorner<Number>, 4> base_corners(const std::array<Vector3<Number>, 5>& p) {
  std::array<BaseCorner<Number>, 4> result{};
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = {difference(p[(i + 1) % 4], p[i]), difference(p[(i + 3) % 4], p[i]),
                 difference(p[4], p[i])};
  return result;
}

/// threshold = mantissa / 2^shift.
struct Threshold {
  Integer mantissa;
  unsigned long shift = 0;
};

Threshold threshold_parts(double threshold) {
  core::expects(threshold >= 0 && threshold <= 1, "exact: a threshold in [0, 1]");
  const BinaryParts parts = binary_parts(threshold);  // odd mantissa: no positive exponent
  return {static_cast<long>(parts.mantissa), static_cast<unsigned long>(-parts.exponent)};
}

/// The squares of the sides of a triangle, in the symmetric functions that the derivation uses.
struct TriangleSides {
  Integer sum, pairs, product;

  TriangleSides(const Vector3<Integer>& u, const Vector3<Integer>& v) {
    const Vector3<Integer> t = difference(u, v);
    const Integer a = dot(u, u);
    const Integer b = dot(v, v);
    const Integer c = dot(t, t);
    sum = a + b + c;
    pairs = a * b + b * c + c * a;
    product = a * b * c;
  }

  /// Whether e L > R, as derived.
  [[nodiscard]] bool roots_exceed(const Integer& r, const Integer& l) const {
    const Integer ll = l * l;
    const Integer above = r * r - pairs * ll;
    return above < 0 || above * above < 4 * product * (sum * l + 2 * r) * l * ll;
  }
};

/// The three corners of one of the triangles, with the edges u, v from its first corner.
bool triangle_exceeds(const Vector3<Integer>& u, const Vector3<Integer>& v,
                      const std::array<Vector3<Integer>, 3>& lateral, const Threshold& threshold) {
  const TriangleSides sides(u, v);
  const Vector3<Integer> normal = cross(u, v);
  return std::all_of(lateral.begin(), lateral.end(), [&](const Vector3<Integer>& w) {
    const Integer jacobian = dot(normal, w);
    if (jacobian <= 0) return false;
    const Integer squared = jacobian * jacobian << 2 * threshold.shift;
    const Integer bound = 27 * threshold.mantissa * threshold.mantissa * sides.product * dot(w, w);
    return sides.roots_exceed(bound - 4 * squared * sides.sum, 8 * squared);
  });
}

bool corner_exceeds(const BaseCorner<Integer>& corner, const Threshold& threshold) {
  const Integer volume = determinant(corner.next, corner.previous, corner.apex);
  if (volume <= 0) return false;
  const Vector3<Integer> z =
      difference(difference(corner.apex, corner.next), difference(corner.previous, corner.apex));
  const Integer squares =
      2 * dot(corner.next, corner.next) + 2 * dot(corner.previous, corner.previous) + dot(z, z);
  const Integer bound = threshold.mantissa * squares;
  return Integer(432 * volume * volume << 3 * threshold.shift) > bound * bound * bound;
}

}  // namespace

JacobianVerdict exact_jacobian_verdict(const Prism& corners) {
  expect_finite(corners);
  const auto edges = lateral_edges(prism_vectors(scaled_integers(corners)));
  const bool corners_positive =
      std::all_of(edges.begin(), edges.end(),
                  [](const Quadratic<Integer>& q) { return q.low > 0 && q.high > 0; });
  return verdict(corners_positive, std::all_of(edges.begin(), edges.end(), is_positive));
}

std::optional<JacobianVerdict> filtered_jacobian_verdict(const Prism& corners) {
  expect_finite(corners);
  const PrismVectors<double> derivatives = prism_vectors(vectors(corners));
  DeterminantFilter filter;
  for (const auto& v : {derivatives.a, derivatives.b, derivatives.a_top, derivatives.b_top})
    filter.include(v);
  for (const auto& v : derivatives.lateral) filter.include(v);
  const std::optional<double> unit = filter.unit();
  if (!unit) return std::nullopt;
  const auto edges = lateral_edges(derivatives);
  if (std::all_of(edges.begin(), edges.end(),
                  [&](const Quadratic<double>& q) { return proven_positive(q, *unit); }))
    return verdict(true, true);
  for (const Quadratic<double>& q : edges)
    if (filter.sign(std::min(q.low, q.high), 1) == Sign::negative) return verdict(false, false);
  return std::nullopt;
}

JacobianVerdict exact_jacobian_verdict(const Pyramid& corners) {
  expect_finite(corners);
  const auto base = base_corners(scaled_integers(corners));
  return verdict(std::all_of(base.begin(), base.end(),
                             [](const BaseCorner<Integer>& c) {
                               return determinant(c.next, c.previous, c.apex) > 0;
                             }),
                 true);
}

std::optional<JacobianVerdict> filtered_jacobian_verdict(const Pyramid& corners) {
  expect_finite(corners);
  const auto base = base_corners(vectors(corners));
  DeterminantFilter filter;
  for (const auto& corner : base) {
    filter.include(corner.next);
    filter.include(corner.apex);
  }
  double least = determinant(base[0].next, base[0].previous, base[0].apex);
  for (std::size_t i = 1; i < 4; ++i)
    least = std::min(least, determinant(base[i].next, base[i].previous, base[i].apex));
  const std::optional<Sign> sign = filter.sign(least, 1);
  if (!sign) return std::nullopt;
  return verdict(*sign == Sign::positive, true);
}

bool corners_exceed(const Prism& corners, double threshold) {
  expect_finite(corners);
  const Threshold parts = threshold_parts(threshold);
  const auto p = prism_vectors(scaled_integers(corners));
  return triangle_exceeds(p.a, p.b, p.lateral, parts) &&
         triangle_exceeds(p.a_top, p.b_top, p.lateral, parts);
}

bool corners_exceed(const Pyramid& corners, double threshold) {
  expect_finite(corners);
  const Threshold parts = threshold_parts(threshold);
  const auto base = base_corners(scaled_integers(corners));
  return std::all_of(base.begin(), base.end(), [&](const BaseCorner<Integer>& corner) {
    return corner_exceeds(corner, parts);
  });
}

}  // namespace hexatlas::exact
