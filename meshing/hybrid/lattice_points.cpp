#include "meshing/hybrid/lattice_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
    for (double i = 0; i <= steps; ++i) {
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
  Lattice lattice(points, spacing);
  if (!(lattice.places() <= kMostPlaces))
    return complex::BrokenLaw{
        "the lattice would have more than 2^28 places in the bounding box: "
        "the spacing " +
        std::to_string(spacing) + " is too small"};
  lattice.allocate();
  // A step that crosses the surface has an end that is at most half a step away from it.
  const double wall = lattice.greatest_step() * (0.5 + 1e-9);
  for (const auto& [a, b, c] : triangles)
    lattice.mark({points[a], points[b], points[c]}, clearance * spacing, wall);
  lattice.flood();
  return lattice.chosen();
}

}  // namespace hexatlas::hybrid
