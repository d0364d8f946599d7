#include "meshing/hybrid/lattice_recovery.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "enum/core/words.hpp"
#include "meshing/hybrid/lattice_vectors.hpp"

namespace hexatlas::hybrid {
namespace {

using exact::Sign;
using Index = mesh::Index;
using Triangle = ClosedSurface::Triangle;

/// Exchanges made for one edge or triangle before it is given up.
constexpr int kMostExchanges = 30;
constexpr std::size_t kLongestRing = 24;

/// Six times the volume by the cube of the longest edge; positive exactly if right-handed, else 0.
double shape(const FlippedTets& tets, const Tetrahedron& t) {
  if (tets.orientation(t[0], t[1], t[2], t[3]) != Sign::positive) return 0;
  std::array<Vector, 4> p{};
  for (std::size_t i = 0; i < 4; ++i) p[i] = tets.points()[t[i]];
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(p[i], p[j]));
  const double volume =
      dot(difference(p[1], p[0]), cross(difference(p[2], p[0]), difference(p[3], p[0])));
  constexpr double kLeastShare = 1e-30;  // where rounding sees no volume, the exact sign does
  return std::max(volume / (longest * longest * longest), kLeastShare);
}

/// The best triangulation of the polygon around an edge.
class Polygon {
 public:
  Polygon(const FlippedTets& tets, Index a, Index b, std::vector<Index> vertices)
      : tets_(tets), a_(a), b_(b), v_(std::move(vertices)), size_(v_.size()) {
    v_.push_back(v_[0]);
    best_.assign((size_ + 1) * (size_ + 1), Part{});
    for (std::size_t length = 2; length <= size_; ++length)
      for (std::size_t i = 0; i + length <= size_; ++i) choose(i, i + length);
  }

  /// The tetrahedra, none if there is no way with these corners joined to each other; `corners` are
  /// places in the polygon, ascending, the first 0; fewer than two: no wish.
  [[nodiscard]] std::vector<Tetrahedron> tetrahedra(std::span<const std::size_t> corners) const {
    std::vector<Tetrahedron> result;
    if (corners.size() < 2) {
      if (!append(0, size_ - 1, result)) result.clear();
      return result;
    }
    bool is_possible = append(corners.back(), size_, result);
    for (std::size_t i = 1; i < corners.size(); ++i)
      is_possible = is_possible && append(corners[i - 1], corners[i], result);
    if (corners.size() == 3) {
      is_possible = is_possible && shape_of(corners[0], corners[1], corners[2]) > 0;
      append_pair(corners[0], corners[1], corners[2], result);
    }
    if (!is_possible) result.clear();
    return result;
  }

 private:
  struct Part {
    double shape = 0;
    std::size_t middle = 0;
  };
  [[nodiscard]] const Part& best(std::size_t i, std::size_t j) const {
    return best_[i * (size_ + 1) + j];
  }
  [[nodiscard]] double value(std::size_t i, std::size_t j) const {
    return j == i + 1 ? 1 : best(i, j).shape;
  }
  [[nodiscard]] double shape_of(std::size_t i, std::size_t j, std::size_t k) const {
    const double above = shape(tets_, {v_[i], v_[j], v_[k], b_});
    return above > 0 ? std::min(above, shape(tets_, {v_[i], v_[k], v_[j], a_})) : 0;
  }
  void choose(std::size_t i, std::size_t j) {
    if (j - i == size_ && i == 0) return;  // the polygon itself has no edge from 0 to 0
    Part& part = best_[i * (size_ + 1) + j];
    for (std::size_t k = i + 1; k < j; ++k) {
      const double sides = std::min(value(i, k), value(k, j));
      if (sides <= part.shape) continue;
      const double least = std::min(sides, shape_of(i, k, j));
      if (least > part.shape) part = {least, k};
    }
  }
  void append_pair(std::size_t i, std::size_t j, std::size_t k,
                   std::vector<Tetrahedron>& result) const {
    result.push_back({v_[i], v_[j], v_[k], b_});
    result.push_back({v_[i], v_[k], v_[j], a_});
  }
  bool append(std::size_t i, std::size_t j, std::vector<Tetrahedron>& result) const {
    if (j == i + 1) return true;
    const Part& part = best(i, j);
    if (!(part.shape > 0)) return false;
    append_pair(i, part.middle, j, result);
    return append(i, part.middle, result) && append(part.middle, j, result);
  }

  const FlippedTets& tets_;
  Index a_, b_;
  std::vector<Index> v_;
  std::size_t size_;
  std::vector<Part> best_;
};

class Recovery {
 public:
  Recovery(FlippedTets& tets, const ClosedSurface& surface) : tets_(tets), surface_(surface) {}

  Missing run() {
    Missing missing;
    for (const auto& [a, b] : surface_.edges())
      if (!recover_edge(a, b)) {
        missing.edges.push_back({a, b});
        if (crossing_) break;
      }
    if (missing.edges.empty())
      for (const Triangle& t : surface_.triangles())
        if (!recover_triangle(t)) {
          missing.triangles.push_back(t);
          if (crossing_) break;
        }
    missing.crossing = crossing_;
    return missing;
  }

 private:
  /// Where the segment from u to v leaves the star of u: the vertices of the least face of the
  /// tetrahedron t that contains the place.
  struct Exit {
    TetIndex t = 0;
    std::vector<Index> face;
  };

  /// A vertex of the surface near which an edge or a triangle of it meets another. False: nothing
  /// was recovered.
  bool report(Index v) {
    const mesh::Point& p = tets_.points()[v];
    crossing_ = complex::BrokenLaw{"the surface meets itself near " + core::place(p.x, p.y, p.z)};
    return false;
  }

  [[nodiscard]] Exit exit_of(Index u, Index v) const {
    for (const TetIndex t : tets_.star(u)) {
      const auto facet = facet_opposite(t, u);
      std::array<Sign, 3> signs{};
      for (std::size_t i = 0; i < 3; ++i)
        signs[i] = tets_.orientation(u, facet[i], facet[(i + 1) % 3], v);
      if (std::count(signs.begin(), signs.end(), Sign::negative) > 0) continue;
      if (std::count(signs.begin(), signs.end(), Sign::zero) == 3) continue;
      Exit exit{t, {}};
      for (std::size_t i = 0; i < 3; ++i)  // a vertex is on the sides before and after it
        if (signs[(i + 1) % 3] != Sign::zero) exit.face.push_back(facet[i]);
      return exit;
    }
    return {};
  }

  /// The other vertices of t, so that seen from v they are clockwise: v, they are right-handed.
  [[nodiscard]] Triangle facet_opposite(TetIndex t, Index v) const {
    Triangle facet{};
    std::size_t count = 0;
    for (const Index w : tets_[t])
      if (w != v) facet[count++] = w;
    if (tets_.orientation(v, facet[0], facet[1], facet[2]) == Sign::negative)
      std::swap(facet[1], facet[2]);
    return facet;
  }

  bool recover_edge(Index u, Index v) {
    const std::array<Index, 2> edge{u, v};
    int failures = 0;
    for (int i = 0; i < kMostExchanges && failures < 2; ++i) {
      if (tets_.with(edge)) return true;
      if (shorten(u, v)) {
        failures = 0;
        continue;
      }
      if (crossing_) return false;
      ++failures;
      std::swap(u, v);
    }
    return tets_.with(edge).has_value();
  }

  /// Removes the facet or edge through which the segment leaves the star of u.
  bool shorten(Index u, Index v) {
    const Exit exit = exit_of(u, v);
    const std::array<Index, 2> edge{u, v};
    const auto& face = exit.face;
    if (face.size() == 1) return report(face[0]);
    if (face.size() == 2) {
      if (surface_.has_edge(face[0], face[1])) return report(face[0]);
      return remove_edge(face[0], face[1], exit.t, edge) ||
             remove_edge(face[0], face[1], exit.t, {});
    }
    if (surface_.has_triangle(face[0], face[1], face[2])) return report(face[0]);
    const TetIndex beyond = tets_.across(exit.t, place_of(tets_[exit.t], u));
    if (beyond == FlippedTets::kOutside) return false;
    if (remove_facet(exit.t, beyond, u)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (remove_edge(a, b, exit.t, edge) || remove_edge(a, b, exit.t, {})) return true;
    }
    return false;
  }

  /// Two tetrahedra at a facet become three at the edge from u through it.
  bool remove_facet(TetIndex t, TetIndex beyond, Index u) {
    const Triangle facet = facet_opposite(t, u);
    Index w = 0;
    for (const Index v : tets_[beyond])
      if (std::find(facet.begin(), facet.end(), v) == facet.end()) w = v;
    std::array<Tetrahedron, 3> fresh{};
    for (std::size_t i = 0; i < 3; ++i) {
      fresh[i] = {u, facet[i], facet[(i + 1) % 3], w};
      if (tets_.orientation(u, facet[i], facet[(i + 1) % 3], w) != Sign::positive) return false;
    }
    tets_.replace(std::array{t, beyond}, fresh);
    return true;
  }

  /// Exchanges the tetrahedra at the edge a b for others without it, that join the vertices wanted
  /// if there are any. None of them may be a or b.
  bool remove_edge(Index a, Index b, TetIndex at, std::span<const Index> wanted) {
    if (surface_.has_edge(a, b)) return false;
    auto ring = tets_.ring(a, b, at);
    if (!ring || ring->vertices.size() > kLongestRing) return false;
    auto& vertices = ring->vertices;
    std::vector<std::size_t> corners;
    if (!wanted.empty()) {
      const auto first = std::find(vertices.begin(), vertices.end(), wanted[0]);
      std::rotate(vertices.begin(), first, vertices.end());
      for (const Index v : wanted) {
        const auto place = std::find(vertices.begin(), vertices.end(), v);
        if (place == vertices.end()) return false;
        corners.push_back(static_cast<std::size_t>(place - vertices.begin()));
      }
      std::sort(corners.begin(), corners.end());
    }
    const Polygon polygon(tets_, a, b, vertices);
    const std::vector<Tetrahedron> fresh = polygon.tetrahedra(corners);
    if (fresh.empty()) return false;
    tets_.replace(ring->tetrahedra, fresh);
    return true;
  }

  bool recover_triangle(Triangle t) {
    int failures = 0;
    for (int i = 0; i < kMostExchanges && failures < 3; ++i) {
      if (tets_.with(t)) return true;
      if (pierce(t)) {
        failures = 0;
        continue;
      }
      if (crossing_) return false;
      ++failures;
      std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    return tets_.with(t).has_value();
  }

  /// Removes the edge that crosses the triangle next to its first side. Requires that its sides are
  /// edges.
  bool pierce(const Triangle& t) {
    const auto [u, v, w] = t;
    const auto at = tets_.with(std::array{u, v});
    if (!at) return false;
    const auto ring = tets_.ring(u, v, *at);
    if (!ring) return false;
    for (std::size_t i = 0; i < ring->vertices.size(); ++i) {
      const Index p = ring->vertices[i];
      const Index q = ring->vertices[(i + 1) % ring->vertices.size()];
      const Sign before = tets_.orientation(u, v, p, w);
      const Sign after = tets_.orientation(u, v, w, q);
      if (before == Sign::zero && after == Sign::positive) return report(p);
      if (before != Sign::positive || after != Sign::positive) continue;
      if (surface_.has_edge(p, q)) return report(p);
      return remove_edge(p, q, ring->tetrahedra[i], t) ||
             remove_edge(p, q, ring->tetrahedra[i], {});
    }
    return false;
  }

  FlippedTets& tets_;
  const ClosedSurface& surface_;
  std::optional<complex::BrokenLaw> crossing_;
};

}  // namespace

std::size_t adopt_diagonals(ClosedSurface& surface, const FlippedTets& tets) {
  std::size_t count = 0;
  for (const auto& [a, b] : surface.edges()) {
    if (!surface.has_edge(a, b) || tets.with(std::array{a, b})) continue;
    if (!surface.can_exchange(a, b) || !tets.with(surface.opposite(a, b))) continue;
    surface.exchange(a, b);
    ++count;
  }
  return count;
}

Missing recover(FlippedTets& tets, const ClosedSurface& surface) {
  return Recovery(tets, surface).run();
}

}  // namespace hexatlas::hybrid
