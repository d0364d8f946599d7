#pragma once
/// \file
/// Random points with small integer coordinates and their signs, for tests: determinants by
/// Leibniz' formula in 64 bits, which shares nothing with the libraries.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace hexatlas::sample {

using Point = std::array<std::int64_t, 3>;
using Points = std::vector<Point>;

/// The sign of det(b - a, c - a, d - a).
inline int sign_of_points(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return (c[i] - a[i]) * (d[j] - a[j]) - (c[j] - a[j]) * (d[i] - a[i]);
  };
  const std::int64_t determinant =
      (b[0] - a[0]) * minor(1, 2) - (b[1] - a[1]) * minor(0, 2) + (b[2] - a[2]) * minor(0, 1);
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

/// The signs of all a < b < c < d, ascending by d, then c, then b, then a.
inline std::vector<std::int8_t> signs_of(const Points& points) {
  std::vector<std::int8_t> signs;
  for (std::size_t d = 3; d < points.size(); ++d)
    for (std::size_t c = 2; c < d; ++c)
      for (std::size_t b = 1; b < c; ++b)
        for (std::size_t a = 0; a < b; ++a)
          signs.push_back(
              static_cast<std::int8_t>(sign_of_points(points[a], points[b], points[c], points[d])));
  return signs;
}

/// Points in general position with coordinates in [-range, range].
inline Points random_points(std::size_t count, std::int64_t range, std::mt19937_64& random) {
  while (true) {
    Points points(count);
    for (Point& point : points)
      for (std::int64_t& coordinate : point)
        coordinate =
            static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * range + 1)) - range;
    const std::vector<std::int8_t> signs = signs_of(points);
    if (std::count(signs.begin(), signs.end(), 0) == 0) return points;
  }
}

/// Whether the signs, by variable - 1, satisfy a clause.
inline bool satisfies(const std::vector<std::int8_t>& signs,
                      const std::vector<std::int32_t>& clause) {
  for (const std::int32_t literal : clause)
    if (signs[static_cast<std::size_t>(std::abs(literal)) - 1] == (literal > 0 ? 1 : -1))
      return true;
  return false;
}

inline bool satisfies_all(const std::vector<std::int8_t>& signs,
                          const std::vector<std::vector<std::int32_t>>& clauses) {
  for (const auto& clause : clauses)
    if (!satisfies(signs, clause)) return false;
  return true;
}

}  // namespace hexatlas::sample
