#pragma once
/// \file
/// Sets of points for tests of meshing/delaunay, seeded.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "meshing/mesh/mesh.hpp"
#include "tests/meshing/delaunay/oracle.hpp"

namespace hexatlas::delaunay_tests {

using Cloud = std::vector<mesh::Point>;
using Random = std::mt19937_64;

/// In [0, 1), the same with any standard library.
inline double unit(Random& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

inline mesh::Point in_box(Random& random, double x, double y, double z) {
  const double a = unit(random), b = unit(random), c = unit(random);
  return {x * a, y * b, z * c};
}

inline Cloud uniform(std::size_t count, Random& random, double x = 1, double y = 1, double z = 1) {
  Cloud points(count);
  for (mesh::Point& p : points) p = in_box(random, x, y, z);
  return points;
}

/// Of a few widths, down to 1e-9.
inline Cloud clusters(std::size_t count, Random& random) {
  const Cloud centres = uniform(7, random);
  Cloud points(count);
  for (mesh::Point& p : points) {
    const std::size_t k = random() % centres.size();
    const mesh::Point q = in_box(random, 1, 1, 1);
    const double width = std::pow(10.0, -static_cast<double>(k + 3));
    p = {centres[k].x + width * q.x, centres[k].y + width * q.y, centres[k].z + width * q.z};
  }
  return points;
}

/// Rounded, so no four of them are likely to be in general position with the centre only.
inline Cloud sphere(std::size_t count, Random& random) {
  Cloud points;
  while (points.size() < count) {
    const mesh::Point q = in_box(random, 2, 2, 2);
    const double x = q.x - 1, y = q.y - 1, z = q.z - 1, length = std::hypot(x, y, z);
    if (length > 0.1 && length < 1) points.push_back({x / length, y / length, z / length});
  }
  return points;
}

inline Cloud paraboloid(std::size_t count, Random& random) {
  Cloud points(count);
  for (mesh::Point& p : points) {
    p = in_box(random, 2, 2, 0);
    p.z = (p.x - 1) * (p.x - 1) + (p.y - 1) * (p.y - 1);
  }
  return points;
}

inline Cloud helix(std::size_t count, double turns) {
  Cloud points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    const double angle = 2 * std::numbers::pi * turns * t;
    points.push_back({std::cos(angle), std::sin(angle), t});
  }
  return points;
}

/// Each pair of segments, one of each line, is a tetrahedron.
inline Cloud skew_lines(std::size_t count) {
  Cloud points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<double>(i);
    points.push_back({t, 0, 0});
    points.push_back({0, t, 1});
  }
  return points;
}

inline Cloud grid(std::size_t n, double step) {
  Cloud points;
  for (std::size_t x = 0; x < n; ++x)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t z = 0; z < n; ++z)
        points.push_back({step * static_cast<double>(x), step * static_cast<double>(y),
                          step * static_cast<double>(z)});
  return points;
}

/// Every tenth is one of the others.
inline Cloud with_duplicates(Cloud points, Random& random) {
  for (std::size_t i = 0; i < points.size(); i += 10) points[i] = points[random() % points.size()];
  return points;
}

inline std::vector<Lattice> lattice_box(std::int64_t x, std::int64_t y, std::int64_t z) {
  std::vector<Lattice> points;
  for (std::int64_t i = 0; i < x; ++i)
    for (std::int64_t j = 0; j < y; ++j)
      for (std::int64_t k = 0; k < z; ++k) points.push_back({i, j, k});
  return points;
}

/// All lattice points at a squared distance from the origin.
inline std::vector<Lattice> lattice_sphere(std::int64_t squared) {
  const auto most = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squared))) + 1;
  std::vector<Lattice> points;
  for (std::int64_t x = -most; x <= most; ++x)
    for (std::int64_t y = -most; y <= most; ++y)
      for (std::int64_t z = -most; z <= most; ++z)
        if (x * x + y * y + z * z == squared) points.push_back({x, y, z});
  return points;
}

inline std::vector<Lattice> some_of(std::vector<Lattice> points, std::size_t count,
                                    Random& random) {
  std::shuffle(points.begin(), points.end(), random);
  points.resize(std::min(count, points.size()));
  return points;
}

inline std::vector<Lattice> random_lattice(std::size_t count, std::int64_t range, Random& random) {
  std::vector<Lattice> points(count);
  for (Lattice& p : points)
    for (std::int64_t& c : p)
      c = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * range + 1)) - range;
  return points;
}

/// Small sets of many kinds, `trial` after `trial`; 4 to `most` points.
inline std::vector<Lattice> small_set(std::size_t trial, std::size_t most, Random& random) {
  const std::size_t count = 4 + random() % (most - 3);
  std::vector<Lattice> points;
  switch (trial % 8) {
    case 0:
      return random_lattice(count, 1 << 20, random);
    case 1:
      return some_of(lattice_box(3, 3, 3), count, random);
    case 2:
      return some_of(lattice_sphere(26), count, random);
    case 3:
      return some_of(lattice_box(2, 3, 5), count, random);
    case 4:  // a plane and one more
      points = some_of(lattice_box(4, 4, 1), count - 1, random);
      points.push_back({static_cast<std::int64_t>(random() % 4), 1, random() % 2 == 0 ? 3 : -3});
      break;
    case 5:  // few places
      points = random_lattice(count, 1, random);
      break;
    case 6:  // a sphere with its centre, and a point outside
      points = some_of(lattice_sphere(9), count - 2, random);
      points.push_back({0, 0, 0});
      points.push_back({static_cast<std::int64_t>(random() % 9), 7, 7});
      break;
    default:  // two planes, and some twice
      points = random_lattice(count, 2, random);
      for (Lattice& p : points) p[2] = p[2] > 0 ? 1 : 0;
      points.back() = points.front();
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

inline Cloud real(const std::vector<Lattice>& points, double step = 1) {
  Cloud result;
  result.reserve(points.size());
  for (const Lattice& p : points)
    result.push_back({step * static_cast<double>(p[0]), step * static_cast<double>(p[1]),
                      step * static_cast<double>(p[2])});
  return result;
}

}  // namespace hexatlas::delaunay_tests
