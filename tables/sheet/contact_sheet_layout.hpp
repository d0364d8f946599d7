#pragma once
/// \file
/// Points for drawings: vectors, and positions of the nodes of a graph by stress majorization.
///
/// Floating point, for pictures only. Only + - * / and sqrt are used, so that the same input gives
/// the same picture on every IEEE machine.

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace hexatlas::sheet {

struct Vec {
  double x = 0, y = 0, z = 0;
};
[[nodiscard]] constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] constexpr Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
[[nodiscard]] constexpr double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(Vec a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline Vec unit(Vec a) { return (1 / length(a)) * a; }

[[nodiscard]] Vec mean(const std::vector<Vec>& points);

/// Pairs of nodes, each pair once.
using Links = std::vector<std::pair<std::size_t, std::size_t>>;

/// Matrix of the lengths of shortest paths. Requires a connected graph.
[[nodiscard]] std::vector<std::vector<double>> path_lengths(std::size_t nodes, const Links& links);

/// Positions, mean 0, whose distances are close to the given ones: the best of several starts, by
/// the sum of the squared differences. Source: J. de Leeuw, Applications of convex analysis to
/// multidimensional scaling (1977). In the plane z = 0 if `is_flat`.
[[nodiscard]] std::vector<Vec> stress_layout(const std::vector<std::vector<double>>& distances,
                                             bool is_flat);

struct Likeness {
  std::vector<Vec> points;
  std::vector<Vec> shape;  ///< the given one or its mirror image
};
/// The orientation-preserving affine image of the points, mean 0, that is alike to `shape` or to
/// its mirror image: half way between the best affine map, by squared distances, and the one that
/// makes the inertia of the points that of a ball. `shape` has mean 0 and is of the first points.
/// Requires these not to lie in a plane.
[[nodiscard]] Likeness alike(const std::vector<Vec>& points, const std::vector<Vec>& shape);

}  // namespace hexatlas::sheet
