#pragma once
/// \file
/// Whether a segment meets a bilinear patch, and whether two flat convex quads have a common point
/// outside what they share: in other ways than the library's. Small integer coordinates only.
///
/// A segment and a patch. Across the direction of the segment two bilinear equations in (s, t) are
/// left; without s they are one quadratic in t, whose roots a + b sqrt(D) are inserted as such.
/// Where it vanishes for all t, s and t change places; where it vanishes again, all is parallel to
/// one plane, and the critical points of the segment are tried one by one.
///
/// Two flat convex quads. The corners of their intersection are among the corners of both and the
/// points where an edge of one meets the plane, or an edge, of the other.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

namespace hexatlas::oracle {

__extension__ using Wide = __int128;
using Vec = std::array<std::int64_t, 3>;
using QuadPoints = std::array<Vec, 4>;

inline int sign_of(Wide x) { return (x > 0) - (x < 0); }
inline Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline std::int64_t dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline bool is_flat(const QuadPoints& q) {
  return dot(cross(minus(q[1], q[0]), minus(q[2], q[0])), minus(q[3], q[0])) == 0;
}

/// By triangles: each diagonal has the two other corners strictly on different sides.
inline bool is_strictly_convex(const QuadPoints& q) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec diagonal = minus(q[i + 2], q[i]);
    const Vec left = cross(diagonal, minus(q[i + 1], q[i]));
    const Vec right = cross(diagonal, minus(q[(i + 3) % 4], q[i]));
    if (left == Vec{} || right == Vec{} || dot(left, right) >= 0) return false;
  }
  return true;
}

/// a + b sqrt(d), for one d.
struct Surd {
  Wide a = 0, b = 0;
  Wide d = 0;
  [[nodiscard]] int sign() const {
    const int sign_a = sign_of(a);
    const int sign_b = d == 0 ? 0 : sign_of(b);
    if (sign_a * sign_b >= 0) return sign_a != 0 ? sign_a : sign_b;
    return sign_a * sign_of(a * a - b * b * d);
  }
  friend Surd operator+(const Surd& x, const Surd& y) { return {x.a + y.a, x.b + y.b, x.d}; }
  friend Surd operator-(const Surd& x, const Surd& y) { return {x.a - y.a, x.b - y.b, x.d}; }
  friend Surd operator*(const Surd& x, const Surd& y) {
    return {x.a * y.a + x.b * y.b * x.d, x.a * y.b + x.b * y.a, x.d};
  }
  friend Surd operator*(Wide k, const Surd& x) { return {k * x.a, k * x.b, x.d}; }
};

struct SegmentPoints {
  Vec from{}, to{};
  bool without_from = false, without_to = false;
};

namespace detail {

/// A ratio n / m lies in [0, 1], without the ends that are left out.
inline bool in_unit(const Surd& n, const Surd& m, bool without_0, bool without_1) {
  const int low = n.sign() * m.sign();
  const int high = (m - n).sign() * m.sign();
  return low >= (without_0 ? 1 : 0) && high >= (without_1 ? 1 : 0);
}

struct Bilinear {  // of (s, t): value[0] + value[1] s + value[2] t + value[3] s t
  std::array<std::int64_t, 4> value{};
};

inline Bilinear along(const Vec& u, const QuadPoints& q, const Vec& origin) {
  const Vec e = minus(minus(q[2], q[3]), minus(q[1], q[0]));
  return {{dot(u, minus(q[0], origin)), dot(u, minus(q[1], q[0])), dot(u, minus(q[3], q[0])),
           dot(u, e)}};
}

/// On the line of the segment runs the whole ruling of t = numerator / w: by its two ends.
inline bool meets_ruling(const SegmentPoints& g, const QuadPoints& q, const Surd& numerator,
                         Wide w) {
  const Vec d = minus(g.to, g.from);
  const Bilinear f = along(d, q, g.from);
  Surd begin = (w * Surd{f.value[0], 0, numerator.d}) + f.value[2] * numerator;
  Surd end =
      (w * Surd{f.value[0] + f.value[1], 0, numerator.d}) + (f.value[2] + f.value[3]) * numerator;
  if (w < 0) {
    begin = -1 * begin;
    end = -1 * end;
  }
  if ((end - begin).sign() < 0) std::swap(begin, end);
  const Surd length{(w < 0 ? -w : w) * dot(d, d), 0, numerator.d};
  // Edges of patches that are not folded have a length: [begin, end] is more than a point.
  return g.without_from || g.without_to ? end.sign() > (g.without_from ? 0 : -1) &&
                                              (length - begin).sign() > (g.without_to ? 0 : -1)
                                        : end.sign() >= 0 && (length - begin).sign() >= 0;
}

/// nullopt where the quadratic in t vanishes.
inline std::optional<bool> meets_by_roots(const SegmentPoints& g, const QuadPoints& q) {
  const Vec d = minus(g.to, g.from);
  std::size_t greatest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(d[k]) > std::abs(d[greatest])) greatest = k;
  std::array<Bilinear, 2> f;
  for (std::size_t m = 0; m < 2; ++m) {
    Vec axis{};
    axis[(greatest + 1 + m) % 3] = 1;
    f[m] = along(cross(d, axis), q, g.from);
  }
  const auto& [x, y] = f;
  const Wide r2 = Wide{x.value[2]} * y.value[3] - Wide{y.value[2]} * x.value[3];
  const Wide r1 = Wide{x.value[0]} * y.value[3] + Wide{x.value[2]} * y.value[1] -
                  Wide{y.value[0]} * x.value[3] - Wide{y.value[2]} * x.value[1];
  const Wide r0 = Wide{x.value[0]} * y.value[1] - Wide{y.value[0]} * x.value[1];
  if (r2 == 0 && r1 == 0 && r0 == 0) return std::nullopt;
  if (r2 == 0 && r1 == 0) return false;
  const Wide root = r2 == 0 ? 0 : r1 * r1 - 4 * r2 * r0;
  if (root < 0) return false;
  const Wide w = r2 == 0 ? r1 : 2 * r2;
  for (const int branch : {1, -1}) {
    const Surd t = r2 == 0 ? Surd{-r0, 0, 0} : Surd{-r1, branch, root};  // over w
    const Surd unit{w, 0, root};
    if (!in_unit(t, unit, false, false)) continue;
    bool is_whole_ruling = true;
    for (const Bilinear& h : f) {
      const Surd m = h.value[1] * unit + h.value[3] * t;  // s = n / m
      if (m.sign() == 0) continue;
      is_whole_ruling = false;
      const Surd n = Wide{-1} * (h.value[0] * unit + h.value[2] * t);
      if (!in_unit(n, m, false, false)) break;
      const Bilinear p = along(d, q, g.from);
      const Surd place = p.value[0] * (m * unit) + p.value[1] * (n * unit) + p.value[2] * (m * t) +
                         p.value[3] * (n * t);  // over m w |d|^2
      if (in_unit(place, Wide{dot(d, d)} * (m * unit), g.without_from, g.without_to)) return true;
      break;
    }
    if (!is_whole_ruling) continue;
    const auto vanishes = [&](const Bilinear& h) {
      return (h.value[0] * unit + h.value[2] * t).sign() == 0;
    };
    if (vanishes(x) && vanishes(y) && meets_ruling(g, q, t, w)) return true;
  }
  return false;
}

/// The point (from (w - n) + to n) / w of a segment, times w, in the closed convex quad times w.
inline bool is_inside(const Vec& point, std::int64_t w, const QuadPoints& q) {
  const Vec normal = cross(minus(q[1], q[0]), minus(q[3], q[0]));
  const auto side = [&](std::size_t i) {
    Vec at{};
    for (std::size_t k = 0; k < 3; ++k) at[k] = point[k] - w * q[i][k];
    return dot(normal, cross(minus(q[(i + 1) % 4], q[i]), at));
  };
  for (std::size_t i = 0; i < 4; ++i)
    if (side(i) < 0) return false;
  Vec at{};
  for (std::size_t k = 0; k < 3; ++k) at[k] = point[k] - w * q[0][k];
  return dot(normal, at) == 0;
}

/// Segment parallel to the plane of a flat convex quad: the ends, the places at which lines of
/// edges are crossed, and the middles between any two of them.
inline bool meets_in_plane(const SegmentPoints& g, const QuadPoints& q) {
  const Vec normal = cross(minus(q[1], q[0]), minus(q[3], q[0]));
  if (dot(normal, minus(g.from, q[0])) != 0) return false;
  const Vec d = minus(g.to, g.from);
  std::vector<std::array<std::int64_t, 2>> places{{0, 1}, {1, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec across = cross(normal, minus(q[(i + 1) % 4], q[i]));
    std::int64_t w = dot(across, d);
    std::int64_t n = dot(across, minus(q[i], g.from));
    if (w < 0) {
      w = -w;
      n = -n;
    }
    if (w > 0 && n >= 0 && n <= w) places.push_back({n, w});
  }
  const auto is_met = [&](std::int64_t n, std::int64_t w) {
    if ((g.without_from && n == 0) || (g.without_to && n == w)) return false;
    Vec point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = w * g.from[k] + n * d[k];
    return is_inside(point, w, q);
  };
  for (const auto& [n, w] : places)
    for (const auto& [m, v] : places)
      if (is_met(n * v + m * w, 2 * w * v)) return true;
  return false;
}

}  // namespace detail

/// Requires a quad that is not flat, or strictly convex; different ends; ends that are left out in
/// the patch. Coordinates of absolute value at most 3 or so.
inline bool meets(const SegmentPoints& segment, const QuadPoints& q) {
  if (const auto answer = detail::meets_by_roots(segment, q)) return *answer;
  if (const auto answer = detail::meets_by_roots(segment, {q[0], q[3], q[2], q[1]})) return *answer;
  return detail::meets_in_plane(segment, q);
}

/// Whether the intersection of two flat convex quads is more than the points in `is_shared`, a
/// predicate on points times their denominator.
template <class Shared>
bool flat_quads_meet(const QuadPoints& a, const QuadPoints& b, const Shared& is_shared) {
  struct Scaled {
    Vec point;
    std::int64_t w;
  };
  std::vector<Scaled> corners;
  const auto add = [&](const Vec& point, std::int64_t w) {
    if (detail::is_inside(point, w, a) && detail::is_inside(point, w, b))
      corners.push_back({point, w});
  };
  const auto add_on_edge = [&](const Vec& from, const Vec& to, std::int64_t n, std::int64_t w) {
    if (w == 0) return;
    if (w < 0) {
      w = -w;
      n = -n;
    }
    Vec point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = w * from[k] + n * (to[k] - from[k]);
    add(point, w);
  };
  for (const auto& [p, q] : {std::array{a, b}, std::array{b, a}}) {
    const Vec normal = cross(minus(q[1], q[0]), minus(q[3], q[0]));
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec& from = p[i];
      const Vec& to = p[(i + 1) % 4];
      add(from, 1);
      const Vec d = minus(to, from);
      add_on_edge(from, to, dot(normal, minus(q[0], from)), dot(normal, d));
      for (std::size_t j = 0; j < 4; ++j) {
        const Vec across = cross(normal, minus(q[(j + 1) % 4], q[j]));
        add_on_edge(from, to, dot(across, minus(q[j], from)), dot(across, d));
      }
    }
  }
  for (const Scaled& x : corners)
    for (const Scaled& y : corners) {
      Vec middle{};
      for (std::size_t k = 0; k < 3; ++k) middle[k] = x.point[k] * y.w + y.point[k] * x.w;
      if (!is_shared(middle, 2 * x.w * y.w)) return true;
    }
  return false;
}

}  // namespace hexatlas::oracle
