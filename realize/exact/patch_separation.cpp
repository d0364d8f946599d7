#include "realize/exact/patch_separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "realize/exact/determinant.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::exact {
namespace {

using Vector = Vector3<double>;

Vector between(const Point3& to, const Point3& from) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Of length 1 for the greatest coordinate, so that no product over- or underflows needlessly.
Vector direction(const Vector& v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return size > 0 ? Vector{v.x / size, v.y / size, v.z / size} : v;
}

Point3 moved(const Point3& p, const Vector& v, double times) {
  return {p.x + times * v.x, p.y + times * v.y, p.z + times * v.z};
}

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// The corners of a quad that the other one does not have.
struct Corners {
  std::array<Point3, 4> points;
  std::size_t count = 0;
  void add(const Point3& p) { points[count++] = p; }
  [[nodiscard]] const Point3* begin() const { return points.data(); }
  [[nodiscard]] const Point3* end() const { return points.data() + count; }
};

class Separation {
 public:
  Separation(const Patch& first, const Patch& second, const Twins& twin) : quads_{first, second} {
    std::array<bool, 4> is_shared{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (twin[i] == kNoTwin) {
        own_[0].add(first[i]);
      } else {
        shared_.add(first[i]);
        is_shared[twin[i]] = true;
      }
    }
    for (std::size_t i = 0; i < 4; ++i)
      if (!is_shared[i]) own_[1].add(second[i]);
    for (const Patch& quad : quads_)
      for (const Point3& p : quad) size_ = std::max(size_, greatest(between(p, first[0])));
  }

  [[nodiscard]] bool is_found() const {
    switch (shared_.count) {
      case 0:
        return along(difference(mean(0, quads_[0][0]), mean(1, quads_[0][0]))) ||
               along(normal(0)) || along(normal(1));
      case 1:
        return along(apart()) || along(difference(mean(0, vertex()), mean(1, vertex())));
      case 2:
        return through_two();
      default:
        return false;
    }
  }

 private:
  static double greatest(const Vector& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  }
  [[nodiscard]] const Point3& vertex() const { return shared_.points[0]; }

  /// Where the own corners of a quad lie, seen from a point.
  [[nodiscard]] Vector mean(std::size_t quad, const Point3& from) const {
    Vector sum{0, 0, 0};
    for (const Point3& p : own_[quad]) {
      const Vector v = between(p, from);
      sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z};
    }
    const auto n = static_cast<double>(own_[quad].count);
    return {sum.x / n, sum.y / n, sum.z / n};
  }
  [[nodiscard]] Vector normal(std::size_t quad) const {
    const Patch& p = quads_[quad];
    return cross(direction(between(p[2], p[0])), direction(between(p[3], p[1])));
  }
  /// The difference of the directions in which the quads lie, seen from the shared vertex.
  [[nodiscard]] Vector apart() const {
    const auto unit = [](const Vector& v) {
      const Vector d = direction(v);
      const double length = std::sqrt(dot(d, d));
      return Vector{d.x / length, d.y / length, d.z / length};
    };
    return difference(unit(mean(0, vertex())), unit(mean(1, vertex())));
  }

  /// A plane with this normal: through the shared vertex, or halfway between the quads.
  [[nodiscard]] bool along(const Vector& given) const {
    const Vector n = direction(given);
    Point3 on_plane = vertex();
    if (shared_.count == 0) {
      const auto heights = [&](std::size_t quad) {
        std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                                    -std::numeric_limits<double>::infinity()};
        for (const Point3& p : own_[quad]) {
          const double height = dot(n, between(p, quads_[0][0]));
          range = {std::min(range[0], height), std::max(range[1], height)};
        }
        return range;
      };
      const auto a = heights(0);
      const auto b = heights(1);
      const double low = a[1] < b[0] ? a[1] : b[1];
      const double high = a[1] < b[0] ? b[0] : a[0];
      if (!(low < high)) return false;
      on_plane = moved(quads_[0][0], n, (low / 2 + high / 2) / dot(n, n));
    }
    // Two directions across n: the axis along which n is short is never parallel to it.
    const bool is_short_x = std::abs(n.x) <= std::min(std::abs(n.y), std::abs(n.z));
    const bool is_short_y = std::abs(n.y) <= std::abs(n.z);
    const Vector axis = is_short_x   ? Vector{1, 0, 0}
                        : is_short_y ? Vector{0, 1, 0}
                                     : Vector{0, 0, 1};
    const Vector u = cross(n, axis);
    return decides(on_plane, moved(on_plane, u, size_), moved(on_plane, cross(n, u), size_));
  }

  /// A plane through two shared corners, between the quads.
  [[nodiscard]] bool through_two() const {
    const Point3& from = shared_.points[0];
    const Vector edge = direction(between(shared_.points[1], from));
    const auto across = [&](std::size_t quad) {
      const Vector m = direction(mean(quad, from));
      const double along_edge = dot(m, edge) / dot(edge, edge);
      const Vector v{m.x - along_edge * edge.x, m.y - along_edge * edge.y,
                     m.z - along_edge * edge.z};
      const double length = std::sqrt(dot(v, v));
      return Vector{v.x / length, v.y / length, v.z / length};
    };
    const Vector in_plane = direction(cross(difference(across(0), across(1)), edge));
    return decides(from, shared_.points[1], moved(from, in_plane, size_));
  }

  /// The only place where something is proved.
  [[nodiscard]] bool decides(const Point3& p, const Point3& q, const Point3& r) const {
    if (!is_finite(p) || !is_finite(q) || !is_finite(r)) return false;
    std::optional<Sign> side_of_first;
    for (std::size_t quad = 0; quad < 2; ++quad) {
      for (const Point3& corner : own_[quad]) {
        const std::optional<Sign> side = filtered_sign_of_orientation(p, q, r, corner);
        if (!side) return false;
        if (!side_of_first) side_of_first = side;
        if (*side != (quad == 0 ? *side_of_first : opposite(*side_of_first))) return false;
      }
    }
    return true;
  }

  std::array<Patch, 2> quads_;
  std::array<Corners, 2> own_;
  Corners shared_;
  double size_ = 0;
};

}  // namespace

bool separated(const Patch& first, const Patch& second, const Twins& twin) {
  return Separation(first, second, twin).is_found();
}

}  // namespace hexatlas::exact
