#pragma once
/// \file
/// Whether tetrahedra are the Delaunay triangulation of points: laws that are local and exact, and
/// together sufficient. Nothing of meshing/delaunay is used but signs of realize/exact.
///
/// Each tetrahedron is right-handed; each facet is that of two, from its two sides, none of which
/// has the other's apex in its perturbed sphere, or of one. The latter are one closed surface with
/// Euler characteristic 2, convex at each edge, so the boundary of a convex body, which the
/// tetrahedra then cover once. Each place of a point is a vertex.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "meshing/mesh/mesh.hpp"
#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"

namespace hexatlas::delaunay_tests {

class Laws {
 public:
  using Index = mesh::Index;
  using Tetrahedron = std::array<Index, 4>;

  Laws(std::span<const mesh::Point> points, const std::vector<Tetrahedron>& mesh)
      : points_(points), mesh_(mesh) {}

  /// The first law that does not hold; none: "".
  [[nodiscard]] std::string broken() {
    if (!is_listed_in_order()) return "listed in order";
    if (!is_right_handed()) return "right-handed";
    if (!has_all_vertices()) return "the vertices are the places";
    if (!facets_hold()) return "facets: two sides, empty spheres";
    if (!surface_is_convex()) return "convex surface";
    return euler_holds() ? "" : "Euler's formula";
  }

 private:
  using Sign = exact::Sign;
  struct Facet {
    std::array<Index, 3> vertices;  ///< ascending
    Index apex;
    std::uint32_t tetrahedron;
    bool operator<(const Facet& other) const { return vertices < other.vertices; }
  };

  [[nodiscard]] exact::Point3 at(Index v) const {
    return {points_[v].x, points_[v].y, points_[v].z};
  }
  [[nodiscard]] Sign orientation(Index a, Index b, Index c, Index d) const {
    return exact::sign_of_orientation(at(a), at(b), at(c), at(d));
  }
  [[nodiscard]] bool has_inside(const Tetrahedron& t, Index p) const {
    return exact::sign_of_perturbed_in_sphere(at(t[0]), at(t[1]), at(t[2]), at(t[3]), at(p)) !=
           Sign::negative;
  }

  [[nodiscard]] bool is_listed_in_order() const {
    const auto has_form = [&](const Tetrahedron& t) {
      return t[0] < t[1] && t[1] < t[2] && t[1] < t[3] && t[2] != t[3] &&
             std::max(t[2], t[3]) < points_.size();
    };
    return !mesh_.empty() && std::all_of(mesh_.begin(), mesh_.end(), has_form) &&
           std::adjacent_find(mesh_.begin(), mesh_.end(), std::greater_equal<>()) == mesh_.end();
  }

  [[nodiscard]] bool is_right_handed() const {
    return std::all_of(mesh_.begin(), mesh_.end(), [&](const Tetrahedron& t) {
      return orientation(t[0], t[1], t[2], t[3]) == Sign::positive;
    });
  }

  /// The least numbers at each place, no other.
  [[nodiscard]] bool has_all_vertices() {
    const auto place = [&](Index v) { return std::tie(points_[v].x, points_[v].y, points_[v].z); };
    std::vector<Index> order(points_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return place(a) < place(b) || (place(a) == place(b) && a < b);
    });
    std::vector<bool> expected(points_.size()), found(points_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      if (i == 0 || place(order[i - 1]) != place(order[i])) {
        expected[order[i]] = true;
        ++vertices_;
      }
    for (const Tetrahedron& t : mesh_)
      for (const Index v : t) found[v] = true;
    return found == expected;
  }

  [[nodiscard]] bool facets_hold() {
    std::vector<Facet> all;
    all.reserve(4 * mesh_.size());
    for (std::uint32_t k = 0; k < mesh_.size(); ++k)
      for (unsigned i = 0; i < 4; ++i) {
        const Tetrahedron& t = mesh_[k];
        Facet facet{{t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}, t[i], k};
        std::sort(facet.vertices.begin(), facet.vertices.end());
        all.push_back(facet);
      }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      while (end < all.size() && all[end].vertices == all[i].vertices) ++end;
      ++facets_;
      if (end - i > 2 || (end - i == 2 && !is_between(all[i], all[i + 1]))) return false;
      if (end - i == 1 && !add_to_surface(all[i])) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_between(const Facet& one, const Facet& other) const {
    const auto [a, b, c] = one.vertices;
    return orientation(a, b, c, one.apex) != orientation(a, b, c, other.apex) &&
           !has_inside(mesh_[one.tetrahedron], other.apex) &&
           !has_inside(mesh_[other.tetrahedron], one.apex);
  }

  /// In the order in which one who stands outside sees it counter-clockwise.
  [[nodiscard]] bool add_to_surface(const Facet& facet) {
    auto [a, b, c] = facet.vertices;
    if (orientation(a, b, c, facet.apex) == Sign::positive) std::swap(b, c);
    return surface_.emplace(std::pair(a, b), c).second &&
           surface_.emplace(std::pair(b, c), a).second &&
           surface_.emplace(std::pair(c, a), b).second;
  }

  [[nodiscard]] bool surface_is_convex() const {
    std::vector<Index> on_surface;
    for (const auto& [edge, apex] : surface_) {
      on_surface.push_back(edge.first);
      const auto other = surface_.find({edge.second, edge.first});
      if (other == surface_.end() ||
          orientation(edge.first, edge.second, apex, other->second) == Sign::positive)
        return false;
    }
    std::sort(on_surface.begin(), on_surface.end());
    const auto vertices = std::unique(on_surface.begin(), on_surface.end()) - on_surface.begin();
    const auto edges = static_cast<std::ptrdiff_t>(surface_.size() / 2);
    return vertices - edges + 2 * edges / 3 == 2;
  }

  [[nodiscard]] bool euler_holds() const {
    std::vector<std::pair<Index, Index>> edges;
    edges.reserve(6 * mesh_.size());
    for (const Tetrahedron& t : mesh_)
      for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < i; ++j) edges.emplace_back(std::minmax(t[i], t[j]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return vertices_ + facets_ == edges.size() + mesh_.size() + 1;
  }

  std::span<const mesh::Point> points_;
  const std::vector<Tetrahedron>& mesh_;
  std::size_t vertices_ = 0, facets_ = 0;
  std::map<std::pair<Index, Index>, Index> surface_;  ///< apex by directed edge
};

inline std::string broken_law(std::span<const mesh::Point> points,
                              const std::vector<Laws::Tetrahedron>& mesh) {
  return Laws(points, mesh).broken();
}

}  // namespace hexatlas::delaunay_tests
