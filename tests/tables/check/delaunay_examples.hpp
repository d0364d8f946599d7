#pragma once
/// \file
/// Triangulations of points with integer coordinates, for the tests of the judge.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "tests/tables/check/delaunay_oracle.hpp"

namespace hexatlas::check::examples {

inline oracle::Points random_points(std::mt19937& random, std::size_t count, unsigned range) {
  oracle::Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.at.push_back({static_cast<int>(random() % range), static_cast<int>(random() % range),
                         static_cast<int>(random() % range)});
  return points;
}

/// (n + 1)^3 points, x fastest.
inline oracle::Points lattice(int n) {
  oracle::Points points;
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) points.at.push_back({x, y, z});
  return points;
}

/// The cube of lattice(1) in five.
inline const std::vector<Tetrahedron> kFive = {
    {0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};

/// Each cube of lattice(n) in six, along the monotone paths from corner to corner (H. W. Kuhn).
inline std::vector<Tetrahedron> kuhn(int n) {
  std::vector<Tetrahedron> cells;
  const std::array<int, 3> step = {1, n + 1, (n + 1) * (n + 1)};
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        std::array<int, 3> order = {0, 1, 2};
        do {
          Tetrahedron cell{};
          int at = x * step[0] + y * step[1] + z * step[2];
          cell[0] = static_cast<std::uint32_t>(at);
          for (std::size_t i = 0; i < 3; ++i)
            cell[i + 1] =
                static_cast<std::uint32_t>(at += step[static_cast<std::size_t>(order[i])]);
          const bool odd = (order[0] > order[1]) ^ (order[0] > order[2]) ^ (order[1] > order[2]);
          if (odd) std::swap(cell[2], cell[3]);
          cells.push_back(cell);
        } while (std::next_permutation(order.begin(), order.end()));
      }
  return cells;
}

/// A tetrahedron for each step of a closed way around the z axis, with the edge from -h to h.
inline TetrahedralMesh around_axis(const std::vector<oracle::Lattice>& ring, double h) {
  TetrahedralMesh mesh;
  const auto n = static_cast<std::uint32_t>(ring.size());
  for (const auto& p : ring)
    mesh.points.push_back(
        {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  mesh.points.push_back({0, 0, -h});
  mesh.points.push_back({0, 0, h});
  for (std::uint32_t i = 0; i < n; ++i) mesh.tetrahedra.push_back({n, i, (i + 1) % n, n + 1});
  return mesh;
}

}  // namespace hexatlas::check::examples
