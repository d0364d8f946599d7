#pragma once
/// \file
/// All combinations of tetrahedra into cells by brute force: every ordered tuple of vertices whose
/// edges are edges of the mesh, with every choice of diagonals. What is inside is found by
/// colouring all tetrahedra from outside, where crossing the cell's surface changes the colour.
/// Validity is the judge's (tables/check). For small integer coordinates.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "meshing/mesh/mesh.hpp"
#include "tables/check/hybrid_cells.hpp"
#include "tables/check/signs.hpp"

namespace hexatlas::hybrid_tests {

using Vertices = std::vector<mesh::Index>;
/// A cell is known by the vertex sets of its faces; with it the tetrahedra inside, and flat ones.
struct Found {
  std::set<std::size_t> inner, flat;
  friend auto operator<=>(const Found&, const Found&) = default;
};
using Key = std::set<Vertices>;
using Cells = std::map<Key, Found>;

struct OracleShape {
  check::CellShape shape;
  std::size_t vertices;
  std::vector<std::vector<std::size_t>> faces;  ///< cyclic
  std::size_t fewest, most;                     ///< tetrahedra inside; with flat ones
};

inline OracleShape hexahedron_shape() {
  return {check::CellShape::kHexahedron,
          8,
          {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}},
          5,
          15};
}
inline OracleShape prism_shape() {
  return {check::CellShape::kPrism,
          6,
          {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {0, 2, 5, 3}},
          3,
          6};
}
inline OracleShape pyramid_shape() {
  return {check::CellShape::kPyramid,
          5,
          {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
          2,
          3};
}

template <class List>
Key key_of(const OracleShape& shape, const List& vertices) {
  Key key;
  for (const auto& face : shape.faces) {
    Vertices set;
    for (const std::size_t i : face) set.push_back(vertices[i]);
    std::sort(set.begin(), set.end());
    key.insert(set);
  }
  return key;
}

class Oracle {
 public:
  explicit Oracle(const mesh::TetMesh& mesh) : mesh_(mesh) {
    for (const mesh::Point& p : mesh.points) points_.push_back({p.x, p.y, p.z});
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
      for (std::size_t i = 0; i < 4; ++i) {
        Vertices triangle;
        for (std::size_t j = 0; j < 4; ++j)
          if (j != i) triangle.push_back(mesh.tetrahedra[t][j]);
        std::sort(triangle.begin(), triangle.end());
        sides_[triangle].push_back(t);
        for (std::size_t j = 0; j < 4; ++j)
          if (j != i) edges_.insert({mesh.tetrahedra[t][i], mesh.tetrahedra[t][j]});
      }
  }

  /// All with positive corners of quality above `least`, valid.
  Cells cells(const OracleShape& shape, double least) {
    Cells result;
    Vertices tuple;
    extend(shape, least, tuple, result);
    return result;
  }

 private:
  using Triangles = std::set<Vertices>;

  void extend(const OracleShape& shape, double least, Vertices& tuple, Cells& result) {
    if (tuple.size() == shape.vertices) {
      offer(shape, least, tuple, result);
      return;
    }
    for (mesh::Index v = 0; v < mesh_.points.size(); ++v) {
      if (std::find(tuple.begin(), tuple.end(), v) != tuple.end()) continue;
      tuple.push_back(v);
      if (has_edges(shape, tuple)) extend(shape, least, tuple, result);
      tuple.pop_back();
    }
  }

  /// Of the last vertex to earlier ones.
  bool has_edges(const OracleShape& shape, const Vertices& tuple) const {
    const std::size_t last = tuple.size() - 1;
    for (const auto& face : shape.faces)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t a = face[i];
        const std::size_t b = face[(i + 1) % face.size()];
        if (std::max(a, b) == last && !edges_.contains({tuple[a], tuple[b]})) return false;
      }
    return true;
  }

  void offer(const OracleShape& shape, double least, const Vertices& tuple, Cells& result) {
    if (!(quality(shape, tuple) > least)) return;
    const Key key = key_of(shape, tuple);
    if (result.contains(key)) return;
    if (check::jacobian_sign(check::HybridCell{shape.shape, 0, corners_of(tuple)}, points_,
                             signs_) != check::JacobianSign::kPositive)
      return;
    std::vector<Triangles> surfaces{{}};
    Triangles theoretical;
    for (const auto& face : shape.faces) {
      std::vector<Triangles> more;
      for (const Triangles& cut : cuts(face, tuple)) {
        theoretical.insert(cut.begin(), cut.end());
        if (!std::all_of(cut.begin(), cut.end(), [&](const auto& t) { return sides_.contains(t); }))
          continue;
        for (Triangles surface : surfaces) {
          surface.insert(cut.begin(), cut.end());
          more.push_back(surface);
        }
      }
      surfaces = more;
    }
    for (const Triangles& surface : surfaces)
      if (const auto found = inside(shape, tuple, surface, theoretical))
        result.emplace(key, *found);
  }

  /// The judge lists a hexahedron by its bottom and top quads.
  static std::array<std::uint32_t, 8> corners_of(const Vertices& tuple) {
    std::array<std::uint32_t, 8> corners{};
    std::copy(tuple.begin(), tuple.end(), corners.begin());
    if (tuple.size() == 8) {
      std::swap(corners[2], corners[3]);
      std::swap(corners[6], corners[7]);
    }
    return corners;
  }

  /// The triangle, or both ways to cut the quad.
  static std::vector<Triangles> cuts(const std::vector<std::size_t>& face, const Vertices& tuple) {
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
      Vertices t{tuple[face[a]], tuple[face[b]], tuple[face[c]]};
      std::sort(t.begin(), t.end());
      return t;
    };
    if (face.size() == 3) return {{triangle(0, 1, 2)}};
    return {{triangle(0, 1, 2), triangle(0, 2, 3)}, {triangle(1, 2, 3), triangle(0, 1, 3)}};
  }

  std::optional<Found> inside(const OracleShape& shape, const Vertices& tuple,
                              const Triangles& surface, const Triangles& theoretical) const {
    const auto colour = coloured(surface);
    Found found;
    for (std::size_t t = 0; t < colour.size(); ++t)
      if (colour[t] == 1) found.inner.insert(t);
    for (const auto& [triangle, sides] : sides_) {  // no theoretical triangle is inside
      if (!theoretical.contains(triangle) || surface.contains(triangle)) continue;
      for (const std::size_t t : sides)
        if (found.inner.contains(t)) return std::nullopt;
    }
    for (const auto& face : shape.faces) {
      if (face.size() != 4) continue;
      if (!is_even_face(face, tuple, surface, found)) return std::nullopt;
    }
    if (found.inner.size() < shape.fewest || found.inner.size() + found.flat.size() > shape.most)
      return std::nullopt;
    return found;
  }

  /// 1 inside the surface, 0 outside.
  std::vector<int> coloured(const Triangles& surface) const {
    std::vector<int> colour(mesh_.tetrahedra.size(), -1);
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (const auto& [triangle, sides] : sides_) {
        const int across = surface.contains(triangle) ? 1 : 0;
        const auto set = [&](std::size_t t, int value) {
          if (colour[t] >= 0) return;
          colour[t] = value;
          is_changed = true;
        };
        if (sides.size() == 1) {
          set(sides[0], across);
        } else if (colour[sides[0]] >= 0) {
          set(sides[1], colour[sides[0]] ^ across);
        } else if (colour[sides[1]] >= 0) {
          set(sides[0], colour[sides[1]] ^ across);
        }
      }
    }
    return colour;
  }

  /// Takes a flat tetrahedron on the quad in; whether both outer triangles are on the boundary of
  /// the mesh, or none.
  bool is_even_face(const std::vector<std::size_t>& face, const Vertices& tuple,
                    const Triangles& surface, Found& found) const {
    Vertices set;
    for (const std::size_t i : face) set.push_back(tuple[i]);
    std::sort(set.begin(), set.end());
    std::size_t flat = mesh_.tetrahedra.size();
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
      Vertices vertices(mesh_.tetrahedra[t].begin(), mesh_.tetrahedra[t].end());
      std::sort(vertices.begin(), vertices.end());
      if (vertices == set) flat = t;
    }
    if (found.inner.contains(flat)) return false;
    const auto both = cuts(face, tuple);
    const bool is_first = surface.contains(*both[0].begin());
    const auto even = [&](const Triangles& cut) {
      std::set<bool> kinds;
      for (const Vertices& t : cut) kinds.insert(sides_.at(t).size() == 1);
      return kinds.size() == 1;
    };
    if (!even(both[is_first ? 0 : 1])) return false;
    if (flat == mesh_.tetrahedra.size()) return true;
    found.flat.insert(flat);
    return even(both[is_first ? 1 : 0]);
  }

  [[nodiscard]] check::Point edge(mesh::Index from, mesh::Index to) const {
    return {points_[to][0] - points_[from][0], points_[to][1] - points_[from][1],
            points_[to][2] - points_[from][2]};
  }
  static double det(const check::Point& a, const check::Point& b, const check::Point& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  static double norm(const check::Point& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  }

  double quality(const OracleShape& shape, const Vertices& v) const {
    double least = 1;
    if (shape.vertices == 8)
      for (std::size_t c = 0; c < 8; ++c) {
        const auto u = edge(v[c & ~1U], v[c | 1U]);
        const auto w = edge(v[c & ~2U], v[c | 2U]);
        const auto x = edge(v[c & ~4U], v[c | 4U]);
        least = std::min(least, det(u, w, x) / (norm(u) * norm(w) * norm(x)));
      }
    if (shape.vertices == 6)
      for (std::size_t c = 0; c < 6; ++c) {
        const std::size_t base = c / 3 * 3;
        const auto u = edge(v[c], v[base + (c + 1) % 3]);
        const auto w = edge(v[c], v[base + (c + 2) % 3]);
        const auto x = edge(v[c % 3], v[c % 3 + 3]);
        const double a = norm(u), b = norm(w);
        const double t = norm(edge(v[base + (c + 1) % 3], v[base + (c + 2) % 3]));
        least = std::min(least, 2 / (3 * std::sqrt(3.0)) * det(u, w, x) *
                                    (1 / (a * b) + 1 / (b * t) + 1 / (a * t)) / norm(x));
      }
    if (shape.vertices == 5)
      for (std::size_t c = 0; c < 4; ++c) {
        const auto u = edge(v[c], v[(c + 1) % 4]);
        const auto w = edge(v[c], v[(c + 3) % 4]);
        check::Point z = edge(v[c], v[4]);
        for (std::size_t i = 0; i < 3; ++i) z[i] = std::sqrt(2.0) * (z[i] - (u[i] + w[i]) / 2);
        const double d = det(u, w, z);
        const double size = norm(u) * norm(u) + norm(w) * norm(w) + norm(z) * norm(z);
        least = std::min(least, d > 0 ? 3 * std::cbrt(d * d) / size : -1);
      }
    return least;
  }

  const mesh::TetMesh& mesh_;
  std::vector<check::Point> points_;
  check::Signs signs_;
  std::map<Vertices, std::vector<std::size_t>> sides_;
  std::set<std::pair<mesh::Index, mesh::Index>> edges_;
};

}  // namespace hexatlas::hybrid_tests
