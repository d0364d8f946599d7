#include "meshing/quality/least_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <queue>
#include <vector>

#include "enum/core/checks.hpp"
#include "meshing/quality/edge.hpp"
#include "meshing/quality/vector.hpp"

namespace hexatlas::quality {
namespace {

using mesh::Point;

/// The points relative to the first, the greatest coordinate being about 1; all zero if they are
/// equal.
template <std::size_t kCount>
std::array<Point, kCount> normalised(std::array<Point, kCount> points) {
  const Point origin = points[0];
  const double scale = scale_for_lengths(points);
  double greatest = 0;
  for (Point& p : points) {
    p = scaled_difference(origin, p, scale);
    core::expects(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
                  "quality: coordinates must be finite");
    greatest = std::max(greatest, greatest_component(p));
  }
  if (greatest == 0) return points;
  for (Point& p : points) p = {p.x / greatest, p.y / greatest, p.z / greatest};
  return points;
}

/// Parts of a cell by their lower bounds, the least first.
template <class Part>
ShapeBounds least_over(const std::vector<Part>& whole, double high) {
  const auto later = [](const Part& a, const Part& b) { return a.low > b.low; };
  std::priority_queue<Part, std::vector<Part>, decltype(later)> parts(later, whole);
  int made = static_cast<int>(whole.size());
  while (parts.top().low < high - kShapeGap && made < kMostParts) {
    const auto halves = parts.top().halves();
    parts.pop();
    for (const Part& half : halves) {
      high = std::min(high, half.high);
      parts.push(half);
    }
    made += 2;
  }
  return {std::min(parts.top().low, high), high};
}

/// Indices: i + 2j of a bilinear map, l + 3m of a product of two.
using Tangents = std::array<Point, 4>;
using Squares = std::array<double, 9>;

/// The Bernstein coefficients of |sum t_ij B_i B_j|^2.
Squares squared_lengths(const Tangents& t) {
  Squares sums{};
  for (std::size_t o = 0; o < 4; ++o)
    for (std::size_t other = 0; other < 4; ++other)
      sums[(o & 1U) + (other & 1U) + 3 * ((o >> 1U) + (other >> 1U))] += dot(t[o], t[other]);
  for (std::size_t i = 0; i < 9; ++i) sums[i] /= (i % 3 == 1 ? 2 : 1) * (i / 3 == 1 ? 2 : 1);
  return sums;
}

/// A linear function of x, at least x^(3/2) for low <= x <= high; a constant if `low`, a bound on
/// an x that is not negative, is itself not positive.
class Chord {
 public:
  Chord(double low, double high) {
    const double a = std::sqrt(std::max(low, 0.0));
    const double b = std::sqrt(high);
    slope_ = a > 0 ? (a * a + a * b + b * b) / (a + b) : 0;
    start_ = a > 0 ? a * a * (a - slope_) : b * b * b;
  }
  [[nodiscard]] double at(double x) const { return start_ + slope_ * x; }

 private:
  double start_, slope_;
};

struct Triple {
  Tangents r, s, t;  ///< the derivatives: r by j + 2k, s by i + 2k, t by i + 2j
};

/// The Bernstein coefficients, at l + 3m + 9n, of the product of three bilinear maps, the first by
/// j + 2k, the second by i + 2k, the third by i + 2j; `pair` multiplies the first two.
template <class Entry, class Pair, class Last>
std::array<double, 27> products(const std::array<Entry, 4>& r, const std::array<Entry, 4>& s,
                                const std::array<Entry, 4>& t, const Pair& pair, const Last& last) {
  std::array<double, 27> sums{};
  for (std::size_t v = 0; v < 8; ++v) {  // i, j and the k of r
    const std::size_t i = v & 1U;
    const std::size_t j = v >> 1U & 1U;
    const std::size_t k = v >> 2U;
    for (std::size_t other = 0; other < 2; ++other) {  // the k of s
      const auto product = pair(r[j + 2 * k], s[i + 2 * other]);
      for (std::size_t o = 0; o < 4; ++o)
        sums[i + (o & 1U) + 3 * (j + (o >> 1U)) + 9 * (k + other)] += last(product, t[o]);
    }
  }
  for (std::size_t i = 0; i < 27; ++i)
    sums[i] /= (i % 3 == 1 ? 2 : 1) * (i / 3 % 3 == 1 ? 2 : 1) * (i / 9 == 1 ? 2 : 1);
  return sums;
}

Point mean(const Tangents& t) {
  return {(t[0].x + t[1].x + t[2].x + t[3].x) / 4, (t[0].y + t[1].y + t[2].y + t[3].y) / 4,
          (t[0].z + t[1].z + t[2].z + t[3].z) / 4};
}

/// A lower bound of S where J < 0.
double negative_bound(const Triple& d, const std::array<double, 27>& jacobian) {
  bool all_positive = true;
  const auto projections = [&all_positive](const Tangents& t) {
    const Point centre = mean(t);
    const double length = std::sqrt(dot(centre, centre));
    std::array<double, 4> result{};
    for (std::size_t o = 0; o < 4; ++o) {
      result[o] = dot(t[o], centre) / length;
      all_positive = all_positive && result[o] > 0;
    }
    return result;
  };
  const auto times = [](double a, double b) { return a * b; };
  const auto lengths = products(projections(d.r), projections(d.s), projections(d.t), times, times);
  if (!all_positive) return -1;
  double least = 0;
  for (std::size_t i = 0; i < 27; ++i)
    if (jacobian[i] < 0) least = std::min(least, jacobian[i] / lengths[i]);
  return std::max(least, -1.0);
}

/// A lower bound of S where no coefficient of J is negative.
double positive_bound(const Triple& d, const std::array<double, 27>& jacobian) {
  double lengths = 1;
  const auto relative = [&lengths](const Tangents& t) {
    Squares result = squared_lengths(t);
    const Point centre = mean(t);
    const double square = dot(centre, centre);
    lengths *= std::sqrt(square);
    for (double& entry : result) entry /= 3 * square;
    return result;
  };
  const Squares r = relative(d.r);
  const Squares s = relative(d.s);
  const Squares t = relative(d.t);
  if (!(lengths > 0)) return 0;
  const auto extremes = [](const Squares& q) { return std::minmax_element(q.begin(), q.end()); };
  const auto [r_low, r_high] = extremes(r);
  const auto [s_low, s_high] = extremes(s);
  const auto [t_low, t_high] = extremes(t);
  const Chord chord(*r_low + *s_low + *t_low, *r_high + *s_high + *t_high);
  double least = 1;
  for (std::size_t i = 0; i < 27; ++i) {
    const std::size_t l = i % 3;
    const std::size_t m = i / 3 % 3;
    const std::size_t n = i / 9;
    const double squares = r[m + 3 * n] + s[l + 3 * n] + t[l + 3 * m];
    least = std::min(least, jacobian[i] / (lengths * chord.at(squares)));
  }
  return std::max(least, 0.0);
}

/// The image of a box in the unit cube, itself that of a trilinear map; S is the same for it.
struct Box {
  Corners corners;
  double low = -1;
  double high = 1;
  std::size_t axis = 0;  ///< along which the derivatives change most

  explicit Box(const Corners& points) : corners(points) {
    const Triple d = derivatives();
    for (std::size_t v = 0; v < 8; ++v) {
      const std::size_t i = v & 1U;
      const std::size_t j = v >> 1U & 1U;
      const std::size_t k = v >> 2U;
      high = std::min(high, scaled_determinant(d.r[j + 2 * k], d.s[i + 2 * k], d.t[i + 2 * j]));
    }
    const auto jacobian = products(d.r, d.s, d.t, cross, dot);
    const bool negative = *std::min_element(jacobian.begin(), jacobian.end()) < 0;
    low = negative ? negative_bound(d, jacobian) : positive_bound(d, jacobian);
    choose_axis(d);
  }

  [[nodiscard]] std::array<Box, 2> halves() const {
    Corners first = corners;
    Corners second = corners;
    const std::size_t bit = std::size_t{1} << axis;
    for (std::size_t v = 0; v < 8; ++v)
      ((v & bit) != 0 ? first : second)[v] = middle(corners[v], corners[v ^ bit]);
    return {Box(first), Box(second)};
  }

 private:
  static Point middle(const Point& a, const Point& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  }

  static double scaled_determinant(const Point& a, const Point& b, const Point& c) {
    const double squares = dot(a, a) * dot(b, b) * dot(c, c);
    return squares > 0 ? std::max(dot(cross(a, b), c) / std::sqrt(squares), -1.0) : 0;
  }

  [[nodiscard]] Triple derivatives() const {
    Triple d;
    for (std::size_t o = 0; o < 4; ++o) {
      const std::size_t low_bit = o & 1U;
      const std::size_t high_bit = o >> 1U;
      const auto along = [&](std::size_t start, std::size_t bit) {
        return scaled_difference(corners[start], corners[start | bit], 1);
      };
      d.r[o] = along(2 * low_bit + 4 * high_bit, 1);
      d.s[o] = along(low_bit + 4 * high_bit, 2);
      d.t[o] = along(low_bit + 2 * high_bit, 4);
    }
    return d;
  }

  void choose_axis(const Triple& d) {
    // The change of t along its index bit, relative to its size.
    const auto change = [](const Tangents& t, std::size_t bit) {
      double most = 0;
      for (std::size_t o = 0; o < 4; ++o) {
        const Point step = scaled_difference(t[o], t[o ^ bit], 1);
        most = std::max(most, dot(step, step));
      }
      const Point centre = mean(t);
      return std::sqrt(most / (dot(centre, centre) + std::numeric_limits<double>::min()));
    };
    const std::array<double, 3> changes{change(d.s, 1) + change(d.t, 1),
                                        change(d.r, 1) + change(d.t, 2),
                                        change(d.r, 2) + change(d.s, 2)};
    axis = static_cast<std::size_t>(std::max_element(changes.begin(), changes.end()) -
                                    changes.begin());
  }
};

/// An interval of heights of a lateral edge where J > 0: the triangle's edges u, v at both ends,
/// and w, along which J is quadratic.
struct Span {
  std::array<Point, 2> u, v;
  Point w;
  double low = 0;
  double high = 1;

  Span(const std::array<Point, 2>& u_ends, const std::array<Point, 2>& v_ends, const Point& lateral)
      : u(u_ends), v(v_ends), w(lateral) {
    for (std::size_t end = 0; end < 2; ++end) high = std::min(high, shape_at(end));
    low = lower_bound();
  }

  [[nodiscard]] bool is_positive() const {
    const auto [first, second, third] = jacobian();
    return first > 0 && third > 0 && (second >= 0 || second * second < first * third);
  }

  [[nodiscard]] std::array<Span, 2> halves() const {
    const Point u_middle = middle(u);
    const Point v_middle = middle(v);
    return {Span({u[0], u_middle}, {v[0], v_middle}, w),
            Span({u_middle, u[1]}, {v_middle, v[1]}, w)};
  }

 private:
  static constexpr double kEquilateral = 2 / (3 * std::numbers::sqrt3);
  using Quadratic = std::array<double, 3>;  ///< Bernstein coefficients

  static double length_of(const Point& p) { return std::sqrt(dot(p, p)); }

  static Point middle(const std::array<Point, 2>& p) {
    return {(p[0].x + p[1].x) / 2, (p[0].y + p[1].y) / 2, (p[0].z + p[1].z) / 2};
  }

  [[nodiscard]] Quadratic jacobian() const {
    return {dot(cross(u[0], v[0]), w), (dot(cross(u[0], v[1]), w) + dot(cross(u[1], v[0]), w)) / 2,
            dot(cross(u[1], v[1]), w)};
  }

  [[nodiscard]] std::array<Point, 2> third() const {
    return {scaled_difference(u[0], v[0], 1), scaled_difference(u[1], v[1], 1)};
  }

  [[nodiscard]] double shape_at(std::size_t end) const {
    const double a = length_of(u[end]);
    const double b = length_of(v[end]);
    const double c = length_of(third()[end]);
    const double product = a * b * c * length_of(w);
    if (!(product > 0)) return 0;
    const double determinant = dot(cross(u[end], v[end]), w);
    return std::clamp(kEquilateral * determinant * (a + b + c) / product, -1.0, 1.0);
  }

  [[nodiscard]] double lower_bound() const {
    double lengths = length_of(w);
    std::array<double, 2> perimeter{};  // at most |u| + |v| + |t|, linear in the height
    Quadratic squares{};
    for (const auto& edge : {u, v, third()}) {
      const Point centre = middle(edge);
      const double length = length_of(centre);
      if (!(length > 0)) return 0;
      lengths *= length;
      for (std::size_t end = 0; end < 2; ++end) perimeter[end] += dot(edge[end], centre) / length;
      const double weight = 1 / (3 * length * length);
      squares[0] += weight * dot(edge[0], edge[0]);
      squares[1] += weight * dot(edge[0], edge[1]);
      squares[2] += weight * dot(edge[1], edge[1]);
    }
    const auto [least, greatest] = std::minmax_element(squares.begin(), squares.end());
    const Chord chord(*least, *greatest);
    const auto [j0, j1, j2] = jacobian();
    const auto [p0, p1] = perimeter;
    if (!(std::min(p0, p1) > 0 && lengths > 0)) return 0;
    const std::array<double, 4> above{j0 * p0, (2 * j1 * p0 + j0 * p1) / 3,
                                      (j2 * p0 + 2 * j1 * p1) / 3, j2 * p1};
    const std::array<double, 4> below{squares[0], (squares[0] + 2 * squares[1]) / 3,
                                      (2 * squares[1] + squares[2]) / 3, squares[2]};
    double bound = 1;
    for (std::size_t i = 0; i < 4; ++i)
      bound = std::min(bound, kEquilateral * above[i] / (lengths * chord.at(below[i])));
    return std::max(bound, 0.0);
  }
};

}  // namespace

ShapeBounds least_scaled_jacobian(const Corners& corners) {
  const Box whole(normalised(corners));
  return least_over(std::vector<Box>{whole}, whole.high);
}

ShapeBounds least_scaled_jacobian(const PrismCorners& corners) {
  const PrismCorners p = normalised(corners);
  const auto difference = [&p](std::size_t from, std::size_t to) {
    return scaled_difference(p[from], p[to], 1);
  };
  std::vector<Span> edges;
  double high = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    edges.emplace_back(std::array{difference(0, 1), difference(3, 4)},
                       std::array{difference(0, 2), difference(3, 5)}, difference(i, i + 3));
    high = std::min(high, edges.back().high);
  }
  if (!std::all_of(edges.begin(), edges.end(), [](const Span& e) { return e.is_positive(); }))
    return {-1, std::min(high, 0.0)};
  return least_over(edges, high);
}

}  // namespace hexatlas::quality
