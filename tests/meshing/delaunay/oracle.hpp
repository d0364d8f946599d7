#pragma once
/// \file
/// Brute force for tests of meshing/delaunay: the rule of docs/theory/delaunay-ties.md, applied to
/// all sets of four points with integer coordinates. Nothing of the library is used.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace hexatlas::delaunay_tests {

using Lattice = std::array<std::int64_t, 3>;
using Tetrahedra = std::vector<std::array<std::uint32_t, 4>>;

__extension__ using Wide = __int128;

/// Of integers: Wide if differences of coordinates are below 2^22, of weights below 2^44.
template <class T>
struct Oracle {
  using Place = std::array<T, 3>;

  static T six_volumes(const Place& a, const Place& b, const Place& c, const Place& d) {
    const auto column = [&](std::size_t i) {
      return Place{T(b[i] - a[i]), T(c[i] - a[i]), T(d[i] - a[i])};
    };
    const Place x = column(0), y = column(1), z = column(2);
    return T(x[0] * T(y[1] * z[2] - y[2] * z[1]) - x[1] * T(y[0] * z[2] - y[2] * z[0]) +
             x[2] * T(y[0] * z[1] - y[1] * z[0]));
  }

  static int sign(const T& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

  /// Positive: the fifth lies inside the perturbed sphere of the others, which are right-handed; if
  /// weights are given, in their perturbed orthosphere.
  static int perturbed_in_sphere(const std::array<Place, 5>& p,
                                 const std::array<T, 5>& weights = {}) {
    std::array<T, 5> factors{};
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<Place, 5> q = p;
      q[k] = p[4];
      factors[k] = six_volumes(q[0], q[1], q[2], q[3]);
    }
    factors[4] = T(-six_volumes(p[0], p[1], p[2], p[3]));
    T sum = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      // Heights seen from the last point: the sum is the same.
      T height = T(weights[4] - weights[k]);
      for (std::size_t i = 0; i < 3; ++i) height += T(p[k][i] - p[4][i]) * T(p[k][i] - p[4][i]);
      sum += T(height * factors[k]);
    }
    if (sum != 0) return sign(sum);
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return p[j] < p[i]; });
    for (const std::size_t k : order)
      if (factors[k] != 0) return sign(factors[k]);
    return 0;
  }

  /// As Triangulation::tetrahedra().
  static Tetrahedra delaunay(const std::vector<Place>& points) {
    return regular(points, std::vector<T>(points.size(), T(0)));
  }

  /// The same with weights. Only the heaviest at a place can be a vertex.
  static Tetrahedra regular(const std::vector<Place>& points, const std::vector<T>& weights) {
    std::map<Place, std::uint32_t> best;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const auto at = best.emplace(points[i], i).first;
      if (weights[i] > weights[at->second]) at->second = i;
    }
    std::vector<std::uint32_t> vertices;
    vertices.reserve(best.size());
    for (const auto& [place, number] : best) vertices.push_back(number);
    std::sort(vertices.begin(), vertices.end());
    Tetrahedra result;
    const std::size_t n = vertices.size();
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        for (std::size_t c = b + 1; c < n; ++c)
          for (std::size_t d = c + 1; d < n; ++d)
            add_if_empty(points, weights, vertices,
                         {vertices[a], vertices[b], vertices[c], vertices[d]}, result);
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  static void add_if_empty(const std::vector<Place>& points, const std::vector<T>& weights,
                           const std::vector<std::uint32_t>& vertices,
                           std::array<std::uint32_t, 4> t, Tetrahedra& result) {
    const T volume = six_volumes(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
    if (volume == 0) return;
    if (volume < 0) std::swap(t[2], t[3]);
    for (const std::uint32_t e : vertices)
      if (std::find(t.begin(), t.end(), e) == t.end() &&
          perturbed_in_sphere(
              {points[t[0]], points[t[1]], points[t[2]], points[t[3]], points[e]},
              {weights[t[0]], weights[t[1]], weights[t[2]], weights[t[3]], weights[e]}) > 0)
        return;
    result.push_back(t);
  }
};

}  // namespace hexatlas::delaunay_tests
