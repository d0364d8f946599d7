#pragma once
/// \file
/// Grids of cubes, whole or spoiled, and a test of hexahedra that shares nothing with the code
/// under test.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "realize/untangle/untangle.hpp"
#include "tests/enum/support.hpp"

namespace hexatlas::grids {

using exact::Point3;
using untangle::Mesh;

/// n^3 unit cubes; interior points are free.
inline Mesh cubes(std::uint32_t n) {
  Mesh mesh;
  const std::uint32_t m = n + 1;
  for (std::uint32_t z = 0; z < m; ++z)
    for (std::uint32_t y = 0; y < m; ++y)
      for (std::uint32_t x = 0; x < m; ++x) {
        mesh.points.push_back({double(x), double(y), double(z)});
        const auto inside = [n](std::uint32_t k) { return 0 < k && k < n; };
        mesh.is_free.push_back(inside(x) && inside(y) && inside(z) ? 1 : 0);
      }
  for (std::uint32_t z = 0; z < n; ++z)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        std::array<std::uint32_t, 8> cell{};
        for (std::uint32_t v = 0; v < 8; ++v)
          cell[v] = x + (v & 1U) + m * (y + (v >> 1U & 1U) + m * (z + (v >> 2U)));
        mesh.hexahedra.push_back(cell);
      }
  return mesh;
}

/// A number in [0, 1].
inline double fraction(support::Random& random) {
  return static_cast<double>(random.below(1U << 20U)) / (1U << 20U);
}

/// Each free point goes anywhere in the box.
inline void scatter(Mesh& mesh, double size, support::Random& random) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.is_free[v] != 0)
      mesh.points[v] = {size * fraction(random), size * fraction(random), size * fraction(random)};
}

/// The Jacobian determinant at (r, s, t), from the definition of the trilinear map.
inline double jacobian(const std::array<Point3, 8>& p, double r, double s, double t) {
  std::array<std::array<double, 3>, 3> d{};
  const std::array<double, 3> at{r, s, t};
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned v = 0; v < 8; ++v) {
      double weight = (v >> axis & 1U) != 0 ? 1 : -1;
      for (unsigned other = 0; other < 3; ++other)
        if (other != axis) weight *= (v >> other & 1U) != 0 ? at[other] : 1 - at[other];
      d[axis][0] += weight * p[v].x;
      d[axis][1] += weight * p[v].y;
      d[axis][2] += weight * p[v].z;
    }
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

/// The least Jacobian determinant over 5^3 places in each hexahedron.
inline double least_jacobian(const Mesh& mesh, const std::vector<Point3>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& cell : mesh.hexahedra) {
    std::array<Point3, 8> corners{};
    for (std::size_t v = 0; v < 8; ++v) corners[v] = points[cell[v]];
    for (int i = 0; i < 125; ++i)
      least =
          std::min(least, jacobian(corners, 0.25 * (i % 5), 0.25 * (i / 5 % 5), 0.25 * (i / 25)));
  }
  return least;
}

inline bool is_finite(const std::vector<Point3>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

}  // namespace hexatlas::grids
