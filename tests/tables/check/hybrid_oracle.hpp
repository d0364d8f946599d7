#pragma once
/// \file
/// What a hybrid mesh is, by brute force and without the judge: Jacobian determinants at points of
/// a grid, facets pair by pair, the boundary triangle by triangle, volumes. For small integer
/// coordinates, where double precision is exact.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check::oracle {

using Cell = std::vector<std::uint32_t>;  ///< 4, 8, 6 or 5 vertices: the number tells the shape

inline std::vector<Cell> all_cells(const HybridMesh& mesh) {
  std::vector<Cell> cells;
  const auto add = [&](const auto& list) {
    for (const auto& cell : list) cells.emplace_back(cell.begin(), cell.end());
  };
  add(mesh.tetrahedra);
  add(mesh.hexahedra);
  add(mesh.prisms);
  add(mesh.pyramids);
  return cells;
}

inline Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double det(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
inline Point mix(const Point& a, const Point& b, double t) {
  Point p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = (1 - t) * a[i] + t * b[i];
  return p;
}

/// The determinant of the derivatives of the map at (u, v, w), for a pyramid without the square of
/// the distance from the apex; each derivative is the difference of the map at both ends, since the
/// map is linear in each coordinate.
inline double jacobian(const std::vector<Point>& p, double u, double v, double w) {
  const auto square = [&](std::size_t k, double x, double y) {  // the corners k to k + 3
    return mix(mix(p[k], p[k + 1], x), mix(p[k + 3], p[k + 2], x), y);
  };
  const auto triangle = [&](std::size_t k, double x, double y) {
    Point q{};
    for (std::size_t i = 0; i < 3; ++i)
      q[i] = (1 - x - y) * p[k][i] + x * p[k + 1][i] + y * p[k + 2][i];
    return q;
  };
  switch (p.size()) {
    case 4:
      return det(minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0]));
    case 5:
      return det(minus(square(0, 1, v), square(0, 0, v)), minus(square(0, u, 1), square(0, u, 0)),
                 minus(p[4], square(0, u, v)));
    case 6: {
      const auto at = [&](double x, double y) {
        return mix(triangle(0, x, y), triangle(3, x, y), w);
      };
      return det(minus(at(1, 0), at(0, 0)), minus(at(0, 1), at(0, 0)),
                 minus(triangle(3, u, v), triangle(0, u, v)));
    }
    default: {
      const auto at = [&](double x, double y, double z) {
        return mix(square(0, x, y), square(4, x, y), z);
      };
      return det(minus(at(1, v, w), at(0, v, w)), minus(at(u, 1, w), at(u, 0, w)),
                 minus(at(u, v, 1), at(u, v, 0)));
    }
  }
}

/// The least value on a grid with so many steps in u and v and in w, powers of two.
inline double least_jacobian(const std::vector<Point>& p, int steps, int heights) {
  double least = jacobian(p, 0, 0, 0);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= heights; ++k) {
        if (p.size() == 6 && i + j > steps) continue;
        const double one = steps, height = heights;
        least = std::min(least, jacobian(p, i / one, j / one, k / height));
      }
  return least;
}

inline std::vector<Point> corners_of(const HybridMesh& mesh, const Cell& cell) {
  std::vector<Point> corners;
  for (const std::uint32_t v : cell) corners.push_back(mesh.points[v]);
  return corners;
}

/// Facets counterclockwise from outside, turned so that the least vertex comes first.
inline std::vector<Cell> facets(const Cell& c) {
  std::vector<Cell> all;
  if (c.size() == 4)
    all = {{c[0], c[2], c[1]}, {c[0], c[1], c[3]}, {c[1], c[2], c[3]}, {c[2], c[0], c[3]}};
  if (c.size() == 5)
    all = {{c[3], c[2], c[1], c[0]},
           {c[0], c[1], c[4]},
           {c[1], c[2], c[4]},
           {c[2], c[3], c[4]},
           {c[3], c[0], c[4]}};
  if (c.size() == 6)
    all = {{c[2], c[1], c[0]},
           {c[3], c[4], c[5]},
           {c[1], c[4], c[3], c[0]},
           {c[2], c[5], c[4], c[1]},
           {c[0], c[3], c[5], c[2]}};
  if (c.size() == 8)
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      all.push_back({c[i], c[next], c[next + 4], c[i + 4]});
    }
  if (c.size() == 8) all.push_back({c[3], c[2], c[1], c[0]});
  if (c.size() == 8) all.push_back({c[4], c[5], c[6], c[7]});
  for (Cell& f : all) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return all;
}

inline Cell turned(Cell facet) {
  std::reverse(facet.begin() + 1, facet.end());
  return facet;
}

/// Corners are distinct points, and no value on the grid is not positive.
inline bool has_good_cells(const HybridMesh& mesh) {
  for (const Cell& cell : all_cells(mesh)) {
    if (std::set<std::uint32_t>(cell.begin(), cell.end()).size() != cell.size()) return false;
    if (*std::max_element(cell.begin(), cell.end()) >= mesh.points.size()) return false;
    if (least_jacobian(corners_of(mesh, cell), 4, 4) <= 0) return false;
  }
  return true;
}

/// The facets of one cell only; none at all if two facets do not fit together.
inline std::vector<Cell> boundary(const HybridMesh& mesh, bool& fits) {
  std::multiset<Cell> open;
  std::set<std::set<std::uint32_t>> closed;
  std::vector<Cell> every;
  for (const Cell& cell : all_cells(mesh))
    for (const Cell& facet : facets(cell)) {
      every.push_back(facet);
      const std::set<std::uint32_t> vertices(facet.begin(), facet.end());
      const auto partner = open.find(turned(facet));
      fits = fits && !closed.contains(vertices);
      if (partner == open.end()) {
        open.insert(facet);
      } else {
        open.erase(partner);
        closed.insert(vertices);
      }
    }
  for (const Cell& a : every)
    for (const Cell& b : every) {
      std::vector<std::size_t> common;  // places in a
      for (std::size_t i = 0; i < a.size(); ++i)
        if (std::find(b.begin(), b.end(), a[i]) != b.end()) common.push_back(i);
      if (common.size() >= 3 && a != b && a != turned(b)) {
        // Quads may have three vertices in common, as long as these are a path in both.
        if (a.size() == 3 || b.size() == 3) fits = false;
        if (common.size() == 4) fits = false;
      }
    }
  // Opposite corners of a quad are joined by no edge.
  std::set<std::set<std::uint32_t>> edges;
  for (const Cell& f : every)
    for (std::size_t i = 0; i < f.size(); ++i) edges.insert({f[i], f[(i + 1) % f.size()]});
  for (const Cell& f : every)
    if (f.size() == 4 && (edges.contains({f[0], f[2]}) || edges.contains({f[1], f[3]})))
      fits = false;
  return {open.begin(), open.end()};
}

/// Whether the facets are the boundary triangles of the given mesh, quads being two of them.
inline bool is_boundary(const std::vector<Cell>& mine, const HybridMesh& mesh,
                        const TetrahedralMesh& given) {
  std::map<Point, std::uint32_t> number;
  const auto place = [&](const Point& p) {
    return number.emplace(p, static_cast<std::uint32_t>(number.size())).first->second;
  };
  bool fits = true;
  std::set<Cell> triangles;
  for (const Cell& t : boundary({given.points, given.tetrahedra, {}, {}, {}}, fits)) {
    Cell at{place(given.points[t[0]]), place(given.points[t[1]]), place(given.points[t[2]])};
    std::rotate(at.begin(), std::min_element(at.begin(), at.end()), at.end());
    triangles.insert(at);
  }
  const auto erase = [&](Cell t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return triangles.erase(t) == 1;
  };
  for (const std::size_t size : {std::size_t{3}, std::size_t{4}})
    for (const Cell& f : mine) {
      if (f.size() != size) continue;
      Cell at;
      for (const std::uint32_t v : f) at.push_back(place(mesh.points[v]));
      if (size == 3 && !erase(at)) return false;
      if (size == 3) continue;
      const bool first = erase({at[0], at[1], at[2]});
      if (first ? !erase({at[0], at[2], at[3]})
                : !erase({at[0], at[1], at[3]}) || !erase({at[1], at[2], at[3]}))
        return false;
    }
  return fits && triangles.empty();
}

/// 72 times the volume, by the divergence theorem; the integral over a bilinear patch by its four
/// corners: the mean of the two ways to cut it.
inline double volume(const std::vector<Cell>& facets, const std::vector<Point>& points) {
  double sum = 0;
  const auto cone = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return det(points[a], points[b], points[c]);
  };
  for (const Cell& f : facets) {
    if (f.size() == 3) sum += 12 * cone(f[0], f[1], f[2]);
    if (f.size() == 4)
      sum += 6 * (cone(f[0], f[1], f[2]) + cone(f[0], f[2], f[3]) + cone(f[0], f[1], f[3]) +
                  cone(f[1], f[2], f[3]));
  }
  return sum;
}

inline bool accepts(const HybridMesh& mesh, const TetrahedralMesh& given) {
  if (!has_good_cells(mesh)) return false;
  bool fits = true;
  const std::vector<Cell> outside = boundary(mesh, fits);
  return fits && is_boundary(outside, mesh, given);
}

}  // namespace hexatlas::check::oracle
