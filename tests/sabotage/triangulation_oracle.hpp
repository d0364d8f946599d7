#pragma once
/// \file
/// Triangulations of small cells and balls, judged slowly and by other ways than the judge's:
/// - balls by the links of their vertices (the judge: by shellings);
/// - groups and equivalence by all permutations of the vertices (the judge: by facets, and for
/// balls by
///   numberings from a tetrahedron);
/// - embeddings by the corners of the intersection of two tetrahedra, each a point of three planes
/// in
///   rational coordinates (the judge: by circuits);
/// - convex position by the facets of convex hulls (the judge: by circuits);
/// - orientation by volumes (the judge: by propagation of signs).
/// Simplices are ascending lists of vertices.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace hexatlas::sabotage {

__extension__ typedef __int128 Int128;

using Simplex = std::vector<int>;
using Complex = std::vector<Simplex>;
using Points = std::vector<std::array<std::int64_t, 3>>;

struct SlowCell {
  int boundary = 0;
  std::vector<std::vector<int>> facets;  ///< counter-clockwise from outside
};

inline std::vector<Simplex> subsets(const Simplex& set, std::size_t size) {
  std::vector<Simplex> result;
  for (unsigned bits = 0; bits < 1U << set.size(); ++bits) {
    Simplex subset;
    for (std::size_t i = 0; i < set.size(); ++i) {
      if (((bits >> i) & 1U) != 0) subset.push_back(set[i]);
    }
    if (subset.size() == size) result.push_back(subset);
  }
  return result;
}

inline Simplex first_numbers(int count) {
  Simplex numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

inline bool contains(const Simplex& set, int vertex) {
  return std::find(set.begin(), set.end(), vertex) != set.end();
}

inline Simplex common(const Simplex& a, const Simplex& b) {
  Simplex both;
  for (const int v : a) {
    if (contains(b, v)) both.push_back(v);
  }
  return both;
}

inline Simplex without(const Simplex& a, const Simplex& b) {
  Simplex rest;
  for (const int v : a) {
    if (!contains(b, v)) rest.push_back(v);
  }
  return rest;
}

inline std::map<Simplex, int> face_counts(const Complex& cells, std::size_t size) {
  std::map<Simplex, int> counts;
  for (const Simplex& cell : cells) {
    for (const Simplex& face : subsets(cell, size)) ++counts[face];
  }
  return counts;
}

/// Whether cells of one size hang together by faces with one vertex less.
inline bool is_strongly_connected(const Complex& cells) {
  if (cells.empty()) return false;
  std::vector<bool> reached(cells.size(), false);
  reached[0] = true;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (std::size_t j = 0; j < cells.size(); ++j) {
        if (!reached[i] || reached[j] || common(cells[i], cells[j]).size() + 1 < cells[i].size()) {
          continue;
        }
        reached[j] = true;
        more = true;
      }
    }
  }
  return std::find(reached.begin(), reached.end(), false) == reached.end();
}

inline Complex link_of(const Complex& cells, int vertex) {
  Complex link;
  for (const Simplex& cell : cells) {
    if (contains(cell, vertex)) link.push_back(without(cell, {vertex}));
  }
  return link;
}

inline Complex boundary_of(const Complex& cells) {
  Complex boundary;
  if (cells.empty()) return boundary;
  for (const auto& [face, count] : face_counts(cells, cells[0].size() - 1)) {
    if (count == 1) boundary.push_back(face);
  }
  return boundary;
}

/// Edges form one path or one circle.
inline bool is_path_or_circle(const Complex& edges) {
  for (const auto& [vertex, count] : face_counts(edges, 1)) {
    if (count > 2) return false;
  }
  return is_strongly_connected(edges);
}

/// Triangles form a sphere, or a disc.
inline bool is_sphere_or_disc(const Complex& triangles) {
  const auto edges = face_counts(triangles, 2);
  const auto vertices = face_counts(triangles, 1);
  for (const auto& [edge, count] : edges) {
    if (count > 2) return false;
  }
  for (const auto& [vertex, count] : vertices) {
    if (!is_path_or_circle(link_of(triangles, vertex[0]))) return false;
  }
  const bool closed = boundary_of(triangles).empty();
  return is_strongly_connected(triangles) &&
         vertices.size() + triangles.size() == edges.size() + (closed ? 2 : 1);
}

/// Triangles in two tetrahedra at most, links spheres or discs, one boundary sphere. With a cone
/// over the boundary this is a closed 3-manifold; all those with up to eight vertices are spheres,
/// so with seven vertices this is a ball. With eight, the one exception is a bundle over the circle
/// with 27 facets, so this is a ball if there are less than 15 tetrahedra.
inline bool is_ball(const Complex& tetrahedra) {
  for (const auto& [triangle, count] : face_counts(tetrahedra, 3)) {
    if (count > 2) return false;
  }
  const Complex boundary = boundary_of(tetrahedra);
  if (!is_strongly_connected(tetrahedra) || boundary.empty()) return false;
  for (const auto& [vertex, count] : face_counts(tetrahedra, 1)) {
    if (!is_sphere_or_disc(link_of(tetrahedra, vertex[0]))) return false;
  }
  return is_sphere_or_disc(boundary) && boundary_of(boundary).empty();
}

inline bool uses_all(const Complex& cells, int vertices) {
  return face_counts(cells, 1).size() == static_cast<std::size_t>(vertices);
}

inline Simplex sorted(Simplex simplex) {
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

/// Whether some choice of diagonals gives these boundary triangles.
inline bool bounds_cell(const Complex& tetrahedra, const SlowCell& cell) {
  const Complex boundary = boundary_of(tetrahedra);
  for (unsigned choice = 0; choice < 1U << cell.facets.size(); ++choice) {
    Complex triangles;
    for (std::size_t i = 0; i < cell.facets.size(); ++i) {
      const std::vector<int>& f = cell.facets[i];
      const bool other = ((choice >> i) & 1U) != 0;
      if (f.size() == 3) {
        triangles.push_back(sorted(f));
      } else {
        triangles.push_back(sorted(other ? Simplex{f[1], f[2], f[3]} : Simplex{f[0], f[1], f[2]}));
        triangles.push_back(sorted(other ? Simplex{f[1], f[3], f[0]} : Simplex{f[0], f[2], f[3]}));
      }
    }
    std::sort(triangles.begin(), triangles.end());
    if (triangles == boundary) return true;
  }
  return false;
}

inline bool has_boundary_tetrahedron(const Complex& tetrahedra, const SlowCell& cell) {
  return std::any_of(cell.facets.begin(), cell.facets.end(), [&](const std::vector<int>& f) {
    return std::find(tetrahedra.begin(), tetrahedra.end(), sorted(f)) != tetrahedra.end();
  });
}

/// A cycle, written from each of its vertices in both directions, in the least way.
inline std::vector<int> least_writing(std::vector<int> cycle) {
  std::vector<int> least = cycle;
  for (int direction = 0; direction < 2; ++direction) {
    for (std::size_t turn = 0; turn < cycle.size(); ++turn) {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
      least = std::min(least, cycle);
    }
    std::reverse(cycle.begin(), cycle.end());
  }
  return least;
}

using Maps = std::vector<std::vector<int>>;

/// All permutations of the vertices that map facets to facets and interior vertices to such.
inline Maps maps_of_cell(const SlowCell& cell, int vertices) {
  std::set<std::vector<int>> facets;
  for (const auto& facet : cell.facets) facets.insert(least_writing(facet));
  Maps maps;
  std::vector<int> map = first_numbers(vertices);
  do {
    bool fits = true;
    for (auto facet : cell.facets) {
      for (int& v : facet) v = map[static_cast<std::size_t>(v)];
      fits = fits && facets.contains(least_writing(facet));
    }
    if (fits) maps.push_back(map);
  } while (std::next_permutation(map.begin(), map.end()));
  return maps;
}

inline Maps all_maps(int vertices) {
  Maps maps;
  std::vector<int> map = first_numbers(vertices);
  do {
    maps.push_back(map);
  } while (std::next_permutation(map.begin(), map.end()));
  return maps;
}

/// The ordered numbers of the format.
inline std::vector<int> numbers_of(const Complex& tetrahedra, const std::vector<int>& map) {
  std::vector<int> numbers;
  for (const Simplex& tetrahedron : tetrahedra) {
    int number = 0;
    for (const int v : tetrahedron) number += 1 << map[static_cast<std::size_t>(v)];
    numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

struct SlowForm {
  std::vector<int> least;
  int automorphisms = 0;
};

inline SlowForm form_of(const Complex& tetrahedra, const Maps& maps) {
  SlowForm form;
  for (const auto& map : maps) {
    const std::vector<int> numbers = numbers_of(tetrahedra, map);
    if (form.least.empty() || numbers < form.least) form = {numbers, 0};
    if (numbers == form.least) ++form.automorphisms;
  }
  return form;
}

/// Whether each tetrahedron after the first meets those before it, as sets of faces, in what one to
/// three triangles generate.
inline bool is_slow_shelling(const Complex& order) {
  std::set<Simplex> before;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::set<Simplex> met;
    std::set<Simplex> generated;
    std::size_t triangles = 0;
    for (std::size_t size = 1; size <= 4; ++size) {
      for (const Simplex& face : subsets(order[i], size)) {
        if (!before.contains(face)) continue;
        met.insert(face);
        if (size != 3) continue;
        ++triangles;
        for (std::size_t small = 1; small <= 3; ++small) {
          for (const Simplex& part : subsets(face, small)) generated.insert(part);
        }
      }
    }
    if (i > 0 && (met != generated || triangles == 0 || triangles > 3)) return false;
    for (std::size_t size = 1; size <= 4; ++size) {
      for (const Simplex& face : subsets(order[i], size)) before.insert(face);
    }
  }
  return true;
}

/// Puts the tetrahedra in the order of a shelling, from place `count` on; false if there is none.
inline bool find_slow_shelling(Complex& tetrahedra, std::size_t count = 0) {
  if (count == tetrahedra.size()) return true;
  for (std::size_t next = count; next < tetrahedra.size(); ++next) {
    std::swap(tetrahedra[count], tetrahedra[next]);
    const auto end = tetrahedra.begin() + static_cast<std::ptrdiff_t>(count) + 1;
    if (is_slow_shelling({tetrahedra.begin(), end}) && find_slow_shelling(tetrahedra, count + 1)) {
      return true;
    }
    std::swap(tetrahedra[count], tetrahedra[next]);
  }
  return false;
}

/// a x + b y + c z = d.
using Plane = std::array<Int128, 4>;

inline Int128 determinant_of(const std::array<std::array<Int128, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

inline Plane plane_through(const Points& p, int i, int j, int k) {
  const auto& a = p[static_cast<std::size_t>(i)];
  const auto& b = p[static_cast<std::size_t>(j)];
  const auto& c = p[static_cast<std::size_t>(k)];
  Plane plane{};
  for (std::size_t x = 0; x < 3; ++x) {
    const std::size_t y = (x + 1) % 3;
    const std::size_t z = (x + 2) % 3;
    plane[x] = static_cast<Int128>(b[y] - a[y]) * (c[z] - a[z]) -
               static_cast<Int128>(b[z] - a[z]) * (c[y] - a[y]);
  }
  plane[3] = plane[0] * a[0] + plane[1] * a[1] + plane[2] * a[2];
  return plane;
}

inline Int128 side(const Plane& plane, const std::array<std::int64_t, 3>& q) {
  return plane[0] * q[0] + plane[1] * q[1] + plane[2] * q[2] - plane[3];
}

/// The planes of the facets, with the tetrahedron on their non-negative sides; none if it is flat.
inline std::vector<Plane> facet_planes(const Points& p, const Simplex& t) {
  std::vector<Plane> planes;
  for (const int apex : t) {
    const Simplex base = without(t, {apex});
    Plane plane = plane_through(p, base[0], base[1], base[2]);
    const Int128 value = side(plane, p[static_cast<std::size_t>(apex)]);
    if (value == 0) return {};
    if (value < 0) {
      for (Int128& x : plane) x = -x;
    }
    planes.push_back(plane);
  }
  return planes;
}

/// Whether the two are not flat and all corners of their intersection are common vertices.
/// Requires coordinates below 2^11, so that 128 bits suffice.
inline bool meet_in_common_face(const Points& p, const Simplex& s, const Simplex& t) {
  std::vector<Plane> planes = facet_planes(p, s);
  const std::vector<Plane> more = facet_planes(p, t);
  if (planes.empty() || more.empty()) return false;
  planes.insert(planes.end(), more.begin(), more.end());
  for (const Simplex& three : subsets(first_numbers(8), 3)) {
    std::array<std::array<Int128, 3>, 3> rows{};
    std::array<Int128, 3> right{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Plane& plane = planes[static_cast<std::size_t>(three[i])];
      rows[i] = {plane[0], plane[1], plane[2]};
      right[i] = plane[3];
    }
    const Int128 denominator = determinant_of(rows);
    if (denominator == 0) continue;
    std::array<Int128, 3> numerator{};  // Cramer's rule
    for (std::size_t x = 0; x < 3; ++x) {
      auto replaced = rows;
      for (std::size_t i = 0; i < 3; ++i) replaced[i][x] = right[i];
      numerator[x] = determinant_of(replaced);
    }
    const Int128 sign = denominator > 0 ? 1 : -1;
    const bool inside = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return sign * (plane[0] * numerator[0] + plane[1] * numerator[1] + plane[2] * numerator[2] -
                     plane[3] * denominator) >=
             0;
    });
    if (!inside) continue;
    const Simplex both = common(s, t);
    const bool is_vertex = std::any_of(both.begin(), both.end(), [&](int v) {
      const auto& q = p[static_cast<std::size_t>(v)];
      return numerator[0] == q[0] * denominator && numerator[1] == q[1] * denominator &&
             numerator[2] == q[2] * denominator;
    });
    if (!is_vertex) return false;
  }
  return true;
}

inline Int128 six_volumes(const Points& p, const Simplex& t) {
  return side(plane_through(p, t[0], t[1], t[2]), p[static_cast<std::size_t>(t[3])]);
}

/// Boundary triangles, counter-clockwise from outside.
inline Complex outward_triangles(const Complex& tetrahedra, const SlowCell& cell) {
  const Complex boundary = boundary_of(tetrahedra);
  Complex outward;
  for (const auto& f : cell.facets) {
    // The three consecutive vertices from each one on, once if there are three in all.
    for (std::size_t i = 0; i < (f.size() == 3 ? 1 : f.size()); ++i) {
      const Simplex triangle = {f[i], f[(i + 1) % f.size()], f[(i + 2) % f.size()]};
      if (std::binary_search(boundary.begin(), boundary.end(), sorted(triangle))) {
        outward.push_back(triangle);
      }
    }
  }
  return outward;
}

/// Six times the volume that the triangles enclose, positive if they are counter-clockwise from
/// outside.
inline Int128 enclosed_volume(Points p, const Complex& outward) {
  p.push_back({0, 0, 0});
  const auto origin = static_cast<int>(p.size()) - 1;
  Int128 volume = 0;
  for (const Simplex& t : outward) volume -= six_volumes(p, {t[0], t[1], t[2], origin});
  return volume;
}

inline Int128 filled_volume(const Points& p, const Complex& tetrahedra) {
  Int128 filled = 0;
  for (const Simplex& t : tetrahedra) {
    const Int128 volume = six_volumes(p, t);
    filled += volume > 0 ? volume : -volume;
  }
  return filled;
}

/// Any two tetrahedra meet in their common face; and the volume that the facets enclose is that of
/// the tetrahedra. Without a cell, the first tetrahedron is positive.
inline bool is_embedded(const Points& p, const Complex& tetrahedra, const SlowCell* cell) {
  if (cell == nullptr ? six_volumes(p, tetrahedra[0]) <= 0
                      : enclosed_volume(p, outward_triangles(tetrahedra, *cell)) !=
                            filled_volume(p, tetrahedra)) {
    return false;
  }
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    if (facet_planes(p, tetrahedra[i]).empty()) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (!meet_in_common_face(p, tetrahedra[i], tetrahedra[j])) return false;
    }
  }
  return true;
}

/// Whether each point is beyond some facet of the convex hull of the others (which is not flat, or
/// has the point beside it).
inline bool is_in_convex_position(const Points& p) {
  const auto count = static_cast<int>(p.size());
  for (int v = 0; v < count; ++v) {
    const Simplex others = without(first_numbers(count), {v});
    bool beyond = false;
    for (const Simplex& base : subsets(others, 3)) {
      const Plane plane = plane_through(p, base[0], base[1], base[2]);
      if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0) continue;
      Int128 least = 0;
      Int128 most = 0;
      for (const int q : others) {
        least = std::min(least, side(plane, p[static_cast<std::size_t>(q)]));
        most = std::max(most, side(plane, p[static_cast<std::size_t>(q)]));
      }
      const Int128 own = side(plane, p[static_cast<std::size_t>(v)]);
      if ((own > 0 && most == 0) || (own < 0 && least == 0)) beyond = true;
    }
    if (!beyond) return false;
  }
  return true;
}

/// Whether the Jacobian determinant of the trilinear map is positive at all points of a grid, times
/// steps^6. Necessary only.
inline bool has_positive_jacobian_on_grid(const Points& p, int steps) {
  for (int x = 0; x <= steps; ++x) {
    for (int y = 0; y <= steps; ++y) {
      for (int z = 0; z <= steps; ++z) {
        const std::array<Int128, 3> at = {x, y, z};
        std::array<std::array<Int128, 3>, 3> rows{};
        for (unsigned v = 0; v < 8; ++v) {
          for (unsigned axis = 0; axis < 3; ++axis) {
            Int128 weight = ((v >> axis) & 1U) != 0 ? 1 : -1;
            for (unsigned other = 0; other < 3; ++other) {
              if (other != axis) {
                weight *= ((v >> other) & 1U) != 0 ? at[other] : steps - at[other];
              }
            }
            for (std::size_t k = 0; k < 3; ++k) rows[axis][k] += weight * p[v][k];
          }
        }
        if (determinant_of(rows) <= 0) return false;
      }
    }
  }
  return true;
}

}  // namespace hexatlas::sabotage
