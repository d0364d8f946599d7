#pragma once
/// \file
/// What a Delaunay triangulation is, by brute force over integer points and without the judge: used
/// to test the judge. One point may be moved infinitely little along one axis.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check::oracle {

__extension__ typedef __int128 Whole;  // NOLINT(modernize-use-using)
using Lattice = std::array<std::int64_t, 3>;
template <std::size_t size>
using Rows = std::array<std::array<Whole, size>, size>;

/// By the first row.
template <std::size_t size>
Whole determinant(const Rows<size>& rows) {
  if constexpr (size == 1) {
    return rows[0][0];
  } else {
    Whole sum = 0;
    for (std::size_t column = 0; column < size; ++column) {
      if (rows[0][column] == 0) continue;
      Rows<size - 1> rest{};
      for (std::size_t r = 1; r < size; ++r)
        for (std::size_t c = 0; c + 1 < size; ++c) rest[r - 1][c] = rows[r][c + (c >= column)];
      const Whole term = rows[0][column] * determinant<size - 1>(rest);
      sum += column % 2 == 0 ? term : -term;
    }
    return sum;
  }
}

struct Points {
  std::vector<Lattice> at;
  std::size_t moved = 0;
  std::size_t axis = 0;
  int direction = 0;  ///< 0: nothing is moved; else by an infinitesimal of this sign

  [[nodiscard]] Lattice shifted(std::size_t i, int steps) const {
    Lattice p = at[i];
    if (i == moved) p[axis] += steps;
    return p;
  }
  [[nodiscard]] Whole volume(std::array<std::size_t, 4> v, int steps) const {
    Rows<4> rows{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Lattice p = shifted(v[k], steps);
      rows[k] = {1, p[0], p[1], p[2]};
    }
    return determinant<4>(rows);
  }
  /// Positive if v[4] is inside the sphere of v[0] .. v[3], if these are positively oriented.
  [[nodiscard]] Whole sphere(std::array<std::size_t, 5> v, int steps) const {
    Rows<4> rows{};
    const Lattice e = shifted(v[4], steps);
    for (std::size_t k = 0; k < 4; ++k) {
      const Lattice p = shifted(v[k], steps);
      const Whole x = p[0] - e[0], y = p[1] - e[1], z = p[2] - e[2];
      rows[k] = {x, y, z, x * x + y * y + z * z};
    }
    return -determinant<4>(rows);
  }
  /// The sign at an infinitesimal of a polynomial of degree 2 with the values `at(0, 1, -1)`.
  template <class Value>
  [[nodiscard]] int sign(const Value& value) const {
    const Whole here = value(0);
    if (here != 0 || direction == 0) return here > 0 ? 1 : here < 0 ? -1 : 0;
    const Whole slope = (value(1) - value(-1)) * direction;
    if (slope != 0) return slope > 0 ? 1 : -1;
    const Whole bend = value(1) + value(-1);
    return bend > 0 ? 1 : bend < 0 ? -1 : 0;
  }
  [[nodiscard]] int orientation(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    return sign([&](int steps) { return volume({a, b, c, d}, steps); });
  }
  [[nodiscard]] int in_sphere(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                              std::size_t e) const {
    return sign([&](int steps) { return sphere({a, b, c, d, e}, steps); });
  }
};

/// All tetrahedra with spheres that are strictly empty; empty if the points are not in general
/// position.
inline std::vector<Tetrahedron> delaunay_of(const Points& points) {
  std::vector<Tetrahedron> result;
  const auto n = static_cast<std::uint32_t>(points.at.size());
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = a + 1; b < n; ++b)
      for (std::uint32_t c = b + 1; c < n; ++c)
        for (std::uint32_t d = c + 1; d < n; ++d) {
          const int side = points.orientation(a, b, c, d);
          if (side == 0) return {};
          bool is_empty = true;
          for (std::uint32_t e = 0; e < n; ++e) {
            if (e == a || e == b || e == c || e == d) continue;
            const int in = side * points.in_sphere(a, b, c, d, e);
            if (in == 0) return {};
            is_empty = is_empty && in < 0;
          }
          if (is_empty && side > 0) result.push_back({a, b, c, d});
          if (is_empty && side < 0) result.push_back({b, a, c, d});
        }
  return result;
}

inline Whole volume_of(const Points& points, const std::vector<Tetrahedron>& cells) {
  Whole sum = 0;
  for (const Tetrahedron& t : cells) sum += points.volume({t[0], t[1], t[2], t[3]}, 0);
  return sum;
}

/// Whether `cells` is a Delaunay triangulation of points whose hull has the volume `hull`.
/// Positive tetrahedra whose facets lie on the hull or between two of them on opposite sides cover
/// the inside of the hull everywhere the same number of times, which the volume tells.
inline bool is_delaunay(const Points& points, const std::vector<Tetrahedron>& cells, Whole hull) {
  const std::size_t n = points.at.size();
  std::set<Lattice> used;
  std::map<std::set<std::uint32_t>, std::vector<std::array<std::uint32_t, 4>>> facets;
  for (const Tetrahedron& t : cells) {
    for (const std::uint32_t v : t)
      if (v >= n) return false;
    if (points.orientation(t[0], t[1], t[2], t[3]) <= 0) return false;
    for (std::uint32_t e = 0; e < n; ++e)
      if (points.in_sphere(t[0], t[1], t[2], t[3], e) > 0) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      std::set<std::uint32_t> corners(t.begin(), t.end());
      used.insert(points.at[t[i]]);
      corners.erase(t[i]);
      std::array<std::uint32_t, 4> other = t;
      std::swap(other[i], other[3]);
      facets[corners].push_back(other);
    }
  }
  for (std::size_t v = 0; v < n; ++v)
    if (!used.contains(points.at[v])) return false;
  for (const auto& [corners, at] : facets) {
    const auto& f = at[0];
    const int inside = points.orientation(f[0], f[1], f[2], f[3]);
    if (at.size() > 2) return false;
    if (at.size() == 2 && points.orientation(f[0], f[1], f[2], at[1][3]) != -inside) return false;
    for (std::size_t v = 0; at.size() == 1 && v < n; ++v)
      if (points.orientation(f[0], f[1], f[2], v) == -inside) return false;
  }
  return volume_of(points, cells) == hull;
}

/// The mesh for the judge; the moved point by one unit in the last place of its coordinate.
TetrahedralMesh inline mesh_of(const Points& points, std::vector<Tetrahedron> cells) {
  TetrahedralMesh mesh;
  for (const Lattice& p : points.at) {
    mesh.points.push_back(
        {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  }
  if (points.direction != 0) {
    double& value = mesh.points[points.moved][points.axis];
    value = std::nextafter(value, points.direction * HUGE_VAL);
  }
  mesh.tetrahedra = std::move(cells);
  return mesh;
}

}  // namespace hexatlas::check::oracle
