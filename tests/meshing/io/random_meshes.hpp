#pragma once
/// \file
/// Seeded random meshes whose coordinates go through all of double precision.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io_tests {

/// Random bits, or an extreme: every finite double can occur.
inline double random_coordinate(std::mt19937_64& random) {
  using Limits = std::numeric_limits<double>;
  constexpr std::array kExtremes{0.0,           -0.0,          Limits::denorm_min(),
                                 Limits::min(), Limits::max(), -Limits::max(),
                                 0.1,           1.0 / 3,       std::bit_cast<double>(1ULL << 51U)};
  if (random() % 4 == 0) return kExtremes[random() % kExtremes.size()];
  while (true) {
    const auto number = std::bit_cast<double>(random());
    if (std::isfinite(number)) return number;
  }
}

inline std::vector<mesh::Point> random_points(std::mt19937_64& random, std::size_t count) {
  std::vector<mesh::Point> points(count);
  for (mesh::Point& p : points)
    p = {random_coordinate(random), random_coordinate(random), random_coordinate(random)};
  return points;
}

template <std::size_t N>
std::vector<std::array<mesh::Index, N>> random_cells(std::mt19937_64& random, std::size_t points,
                                                     std::size_t count) {
  std::vector<mesh::Index> all(points);
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::array<mesh::Index, N>> cells(count);
  for (auto& cell : cells) {
    std::shuffle(all.begin(), all.end(), random);
    std::copy_n(all.begin(), N, cell.begin());
  }
  return cells;
}

}  // namespace hexatlas::io_tests
