#include "realize/exact/patch.hpp"

#include <algorithm>

#include "realize/exact/integers.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::exact {
namespace {

using Vector = Vector3<Integer>;
using Rational = mpq_class;

/// An affine function on the segment: its value at the start, and that at the end minus it.
struct Affine {
  Integer constant, slope;
};

/// c2 u^2 + c1 u + c0 for u from 0, the start of the segment, to 1.
struct Quadratic {
  Integer c2, c1, c0;
  [[nodiscard]] bool is_zero() const { return c2 == 0 && c1 == 0 && c0 == 0; }
  [[nodiscard]] Rational operator()(const Rational& u) const { return (c2 * u + c1) * u + c0; }
};

Rational ratio(const Integer& numerator, const Integer& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

/// Part of the segment, empty if low > high.
struct Interval {
  Rational low = 0, high = 1;

  void keep_where_not_negative(const Affine& f) {
    if (f.slope == 0) {
      if (f.constant < 0) high = -1;
      return;
    }
    const Rational root = ratio(-f.constant, f.slope);
    if (f.slope > 0)
      low = std::max(low, root);
    else
      high = std::min(high, root);
  }
  [[nodiscard]] bool has(const Rational& u) const { return low <= u && u <= high; }
};

/// The points of the segment at which the polynomial is zero, within the interval, are those in the
/// patch.
struct Meeting {
  Interval interval;
  Quadratic zero;
};

/// Over the basis a, c, e, all coordinates times |D|.
Meeting with_curved(const std::array<Vector, 6>& p, const Integer& determinant_ace) {
  const Vector a = difference(p[1], p[0]);
  const Vector c = difference(p[3], p[0]);
  const Vector e = difference(difference(p[2], p[3]), a);
  const int sign = sgn(determinant_ace);
  const Integer unit = abs(determinant_ace);
  const auto coordinate = [&](const auto& determinant_with) {
    const Integer start = sign * determinant_with(difference(p[4], p[0]));
    return Affine{start, sign * determinant_with(difference(p[5], p[0])) - start};
  };
  const Affine s = coordinate([&](const Vector& x) { return determinant(x, c, e); });
  const Affine t = coordinate([&](const Vector& x) { return determinant(a, x, e); });
  const Affine third = coordinate([&](const Vector& x) { return determinant(a, c, x); });
  Meeting result;
  for (const Affine& f : {s, t}) {
    result.interval.keep_where_not_negative(f);
    result.interval.keep_where_not_negative({unit - f.constant, -f.slope});
  }
  result.zero = {s.slope * t.slope,
                 s.slope * t.constant + s.constant * t.slope - unit * third.slope,
                 s.constant * t.constant - unit * third.constant};
  return result;
}

Meeting with_flat(const std::array<Vector, 6>& p) {
  const Vector normal = cross(difference(p[1], p[0]), difference(p[3], p[0]));
  Meeting result;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector inwards = cross(normal, difference(p[(i + 1) % 4], p[i]));
    const Integer start = dot(inwards, difference(p[4], p[i]));
    result.interval.keep_where_not_negative({start, dot(inwards, difference(p[5], p[i])) - start});
  }
  const Integer start = dot(normal, difference(p[4], p[0]));
  result.zero = {0, dot(normal, difference(p[5], p[0])) - start, start};
  return result;
}

bool has_root(const Quadratic& f, const Interval& interval) {
  const int low = sgn(f(interval.low));
  const int high = sgn(f(interval.high));
  if (low * high <= 0) return true;
  if (sgn(f.c2) != low) return false;
  const Rational turn = ratio(-f.c1, 2 * f.c2);
  return interval.has(turn) && sgn(f(turn)) != low;
}

/// A left out end is a root; the other one, if any, is then rational.
bool is_met(const Meeting& meeting, bool without_from, bool without_to) {
  const Interval& interval = meeting.interval;
  const Quadratic& f = meeting.zero;
  if (interval.low > interval.high) return false;
  const auto is_kept = [&](const Rational& u) {
    return interval.has(u) && !(without_from && u == 0) && !(without_to && u == 1);
  };
  if (f.is_zero()) return interval.low < interval.high || is_kept(interval.low);
  if (!without_from && !without_to) return has_root(f, interval);
  if (f.c2 == 0) return false;
  return is_kept(without_from ? ratio(-f.c1, f.c2) : ratio(f.c0, f.c2));
}

bool is_strictly_convex(const std::array<Vector, 4>& p) {
  std::array<Vector, 4> normal;
  for (std::size_t i = 0; i < 4; ++i)
    normal[i] = cross(difference(p[(i + 1) % 4], p[i]), difference(p[(i + 3) % 4], p[i]));
  return std::all_of(normal.begin(), normal.end(),
                     [&](const Vector& n) { return dot(normal[0], n) > 0; });
}

}  // namespace

bool is_folded(const Patch& patch) {
  // D = -det(p1 - p0, p2 - p0, p3 - p0).
  return sign_of_orientation(patch[0], patch[1], patch[2], patch[3]) == Sign::zero &&
         !is_strictly_convex(scaled_integers(patch));
}

bool meets(const Segment& segment, const Patch& patch) {
  const std::array points{patch[0], patch[1], patch[2], patch[3], segment.from, segment.to};
  expect_finite(points);
  const std::array<Vector, 6> p = scaled_integers(points);
  const Integer determinant_ace =
      -determinant(difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0]));
  core::expects(determinant_ace != 0 || is_strictly_convex({p[0], p[1], p[2], p[3]}),
                "exact: a patch that is folded");
  return is_met(determinant_ace != 0 ? with_curved(p, determinant_ace) : with_flat(p),
                segment.without_from, segment.without_to);
}

}  // namespace hexatlas::exact
