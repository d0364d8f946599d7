#include "meshing/hybrid/lattice_points.hpp"
#include "enum/core/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "meshing/hybrid/lattice_vectors.hpp"

namespace hexatlas::hybrid {
namespace {

using Corners = std::array<mesh::Point, 3>;
using Places = std::array<std::size_t, 3>;

constexpr double kMostPlaces = 0x1p28;

double coordinate(const mesh::Point& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

double distance_to_segment(const mesh::Point& p, const mesh::Point& a, const mesh::Point& b) {
  const Vector along = difference(b, a);
  const double t = std::clamp(dot(difference(p, a), along) / dot(along, along), 0.0, 1.0);
  return distance(p, {a.x + t * along.x, a.y + t * along.y, a.z + t * along.z});
}

double distance_to_triangle(const mesh::Point& p, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Vector normal = cross(difference(b, a), difference(c, a));
  bool is_above = norm(normal) > 0;
  double least = distance_to_segment(p, c, a);
  for (std::size_t i = 0; i < 3; ++i) {
    const mesh::Point& from = corners[i];
    const mesh::Point& to = corners[(i + 1) % 3];
    least = std::min(least, distance_to_segment(p, from, to));
    if (dot(cross(difference(to, from), difference(p, from)), normal) < 0) is_above = false;
  }
  return is_above ? std::min(least, std::abs(dot(difference(p, a), normal)) / norm(normal)) : least;
}

/// Three directions at right angles to each other.
using Frame = std::array<Vector, 3>;

constexpr Frame kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

mesh::Point in_frame(const mesh::Point& p, const Frame& f) {
  return {dot(p, f[0]), dot(p, f[1]), dot(p, f[2])};
}

mesh::Point from_frame(const mesh::Point& p, const Frame& f) {
  return {p.x * f[0].x + p.y * f[1].x + p.z * f[2].x, p.x * f[0].y + p.y * f[1].y + p.z * f[2].y,
          p.x * f[0].z + p.y * f[1].z + p.z * f[2].z};
}

bool is_axis(const Vector& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z) < 1 + 1e-9; }

/// A direction of planes, one of two that are opposite, and the area of the triangles in them.
struct Flat {
  Vector normal;
  double area = 0;
};

/// By area, the greatest first.
std::vector<Flat> flats(std::span<const mesh::Point> points,
                        std::span<const std::array<mesh::Index, 3>> triangles) {
  constexpr double kCells = 1e6;  // normals in the same cell of this many along each axis are one
  std::map<std::array<double, 3>, Flat> found;
  for (const auto& [a, b, c] : triangles) {
    Vector n = cross(difference(points[b], points[a]), difference(points[c], points[a]));
    const double area = norm(n);
    if (!(area > 0)) continue;
    n = {n.x / area, n.y / area, n.z / area};
    std::array<double, 3> key{std::round(n.x * kCells), std::round(n.y * kCells),
                              std::round(n.z * kCells)};
    if (key < std::array<double, 3>{}) {
      n = {-n.x, -n.y, -n.z};
      key = {-key[0], -key[1], -key[2]};
    }
    found.try_emplace({key[0] + 0.0, key[1] + 0.0, key[2] + 0.0}, Flat{n, 0}).first->second.area +=
        area;
  }
  std::vector<Flat> result;
  result.reserve(found.size());
  for (const auto& [key, flat] : found) result.push_back(flat);
  std::stable_sort(result.begin(), result.end(),
                   [](const Flat& a, const Flat& b) { return a.area > b.area; });
  return result;
}

/// The area of the flat parts that are at right angles to a direction of the frame.
double area_along(const Frame& frame, const std::vector<Flat>& all) {
  double area = 0;
  for (const Flat& flat : all)
    if (is_axis(in_frame(flat.normal, frame))) area += flat.area;
  return area;
}

/// Along the normal of the greatest flat part, and of the greatest that is at right angles to it;
/// or the axes, if there is no such frame or no more flat area along it.
Frame frame_of(std::span<const mesh::Point> points,
               std::span<const std::array<mesh::Index, 3>> triangles) {
  constexpr double kGreat = 0.05;  // of the area
  constexpr double kRight = 1e-6;
  const std::vector<Flat> all = flats(points, triangles);
  double area = 0;
  for (const Flat& flat : all) area += flat.area;
  for (const Flat& flat : all) {
    const Vector& w = all.front().normal;
    if (flat.area < kGreat * area) break;
    if (std::abs(dot(flat.normal, w)) > kRight) continue;
    Vector v = cross(w, flat.normal);
    const double length = norm(v);
    v = {v.x / length, v.y / length, v.z / length};
    const Frame frame{cross(v, w), v, w};
    constexpr double kMore = 1 + 1e-6;
    return area_along(frame, all) > kMore * area_along(kAxes, all) ? frame : kAxes;
  }
  return kAxes;
}

class Lattice {
 public:
  Lattice(std::span<const mesh::Point> points, double spacing) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const mesh::Point& p : points) values.push_back(coordinate(p, axis));
      std::sort(values.begin(), values.end());
      lay(axis, values, spacing);
    }
  }

  [[nodiscard]] double places() const noexcept { return places_; }
  [[nodiscard]] double greatest_step() const noexcept { return greatest_step_; }

  /// Marks the places near a triangle.
  void mark(const Corners& corners, double near, double wall) {
    const double reach = std::max(near, wall);
    Places first{};
    Places last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::minmax({coordinate(corners[0], axis), coordinate(corners[1], axis),
                       coordinate(corners[2], axis)});
      const auto& planes = planes_[axis];
      first[axis] = static_cast<std::size_t>(
          std::lower_bound(planes.begin(), planes.end(), low - reach) - planes.begin());
      last[axis] = static_cast<std::size_t>(
          std::upper_bound(planes.begin(), planes.end(), high + reach) - planes.begin());
    }
    for (std::size_t k = first[2]; k < last[2]; ++k)
      for (std::size_t j = first[1]; j < last[1]; ++j)
        for (std::size_t i = first[0]; i < last[0]; ++i) {
          const double d = distance_to_triangle(at({i, j, k}), corners);
          std::uint8_t& mark = marks_[number({i, j, k})];
          if (d < near) mark |= kNear;
          if (d <= wall) mark |= kWall;
        }
  }

  void allocate() { marks_.assign(planes_[0].size() * planes_[1].size() * planes_[2].size(), 0); }

  /// Marks what can be reached from the sides of the bounding box without touching the wall.
  void flood() {
    std::vector<Places> open;
    const auto reach = [&](const Places& p) {
      std::uint8_t& mark = marks_[number(p)];
      if ((mark & (kWall | kOutside)) != 0) return;
      mark |= kOutside;
      open.push_back(p);
    };
    for_each([&](const Places& p) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (p[axis] == 0 || p[axis] + 1 == planes_[axis].size()) {
          reach(p);
          return;
        }
    });
    while (!open.empty()) {
      const Places p = open.back();
      open.pop_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Places next = p;
        if (p[axis] > 0) {
          --next[axis];
          reach(next);
        }
        next[axis] = p[axis] + 1;
        if (next[axis] < planes_[axis].size()) reach(next);
      }
    }
  }

  [[nodiscard]] std::vector<mesh::Point> chosen() const {
    std::vector<mesh::Point> result;
    for_each([&](const Places& p) {
      if ((marks_[number(p)] & (kNear | kOutside)) == 0) result.push_back(at(p));
    });
    return result;
  }

 private:
  static constexpr std::uint8_t kNear = 1, kWall = 2, kOutside = 4;

  /// Planes from the least to the greatest value, each through the nearest value if that is nearly
  /// the same.
  void lay(std::size_t axis, const std::vector<double>& values, double spacing) {
    const double low = values.front();
    const double length = values.back() - low;
    const double steps = std::max(1.0, std::round(length / spacing));
    places_ *= steps + 1;
    if (!(places_ <= kMostPlaces)) return;
    constexpr double kSame = 1e-6;
    const double step = length / steps;
    greatest_step_ = std::max(greatest_step_, step);
    const auto count = static_cast<int>(steps);
    for (int i = 0; i <= count; ++i) {
      double value = low + length * (i / steps);
      const auto after = std::lower_bound(values.begin(), values.end(), value);
      for (const auto& it : {after, after == values.begin() ? after : after - 1})
        if (it != values.end() && std::abs(*it - value) < kSame * step) value = *it;
      planes_[axis].push_back(value);
    }
  }

  [[nodiscard]] mesh::Point at(const Places& p) const {
    return {planes_[0][p[0]], planes_[1][p[1]], planes_[2][p[2]]};
  }
  [[nodiscard]] std::size_t number(const Places& p) const {
    return (p[2] * planes_[1].size() + p[1]) * planes_[0].size() + p[0];
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t k = 0; k < planes_[2].size(); ++k)
      for (std::size_t j = 0; j < planes_[1].size(); ++j)
        for (std::size_t i = 0; i < planes_[0].size(); ++i) visit(Places{i, j, k});
  }

  std::array<std::vector<double>, 3> planes_;
  double places_ = 1, greatest_step_ = 0;
  std::vector<std::uint8_t> marks_;
};

}  // namespace

double usual_side(std::span<const mesh::Point> points,
                  std::span<const std::array<mesh::Index, 3>> triangles) {
  std::vector<double> sides;
  for (const auto& [a, b, c] : triangles) {
    std::array<double, 3> side{distance(points[a], points[b]), distance(points[b], points[c]),
                               distance(points[c], points[a])};
    std::sort(side.begin(), side.end());
    sides.push_back((side[0] + side[1]) / 2);
  }
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  std::nth_element(sides.begin(), middle, sides.end());
  return *middle;
}

std::variant<std::vector<mesh::Point>, complex::BrokenLaw> lattice_points(
    std::span<const mesh::Point> points, std::span<const std::array<mesh::Index, 3>> triangles,
    double spacing, double clearance) {
  const Frame frame = frame_of(points, triangles);
  std::vector<mesh::Point> turned(points.begin(), points.end());
  if (frame != kAxes)
    for (mesh::Point& p : turned) p = in_frame(p, frame);
  Lattice lattice(turned, spacing);
  if (!(lattice.places() <= kMostPlaces))
    return complex::BrokenLaw{
        "the lattice would have more than 2^28 places in the bounding box: "
        "the spacing " +
        core::shortest(spacing) + " is too small"};
  lattice.allocate();
  // A step that crosses the surface has an end that is at most half a step away from it.
  const double wall = lattice.greatest_step() * (0.5 + 1e-9);
  for (const auto& [a, b, c] : triangles)
    lattice.mark({turned[a], turned[b], turned[c]}, clearance * spacing, wall);
  lattice.flood();
  std::vector<mesh::Point> result = lattice.chosen();
  if (frame != kAxes)
    for (mesh::Point& p : result) p = from_frame(p, frame);
  return result;
}

}  // namespace hexatlas::hybrid
