#include <algorithm>

#include "tables/check/disjoint_sets.hpp"
#include "tables/check/laws.hpp"

namespace hexatlas::check {

namespace {

/// An edge of a link: pair_key() of its ends as vertices, and its ends as corners 3 t + i of
/// triangles, that at the lesser vertex first.
struct LinkEdge {
  std::uint64_t ends;
  std::array<std::uint32_t, 2> corners;
};

/// Works out one link after another in the same memory.
class LinkChecker {
 public:
  explicit LinkChecker(const Incidence& incidence)
      : incidence_(incidence), node_of_(incidence.vertex_count, 0) {}

  /// What is wrong with the link of `vertex`, which lies in some hexahedron; empty if nothing.
  std::string broken(std::uint32_t vertex) {
    const auto triangles = collect(vertex);
    glued_.reset(3 * triangles);
    connected_.reset(triangles);
    std::size_t edges = 0;
    std::size_t free_edges = 0;
    for (std::size_t i = 0; i < edges_.size(); ++edges) {
      std::size_t end = i + 1;
      while (end < edges_.size() && edges_[end].ends == edges_[i].ends) ++end;
      if (end - i > 2)
        return "has edge " + listed(pair_of(edges_[i].ends)) + " in more than two triangles";
      if (end - i == 1) ++free_edges;
      if (end - i == 2) glue(edges_[i], edges_[i + 1]);
      i = end;
    }
    if (connected_.sets() != 1) return "is not connected";
    if (glued_.sets() != nodes_) return "is not a surface: it is pinched at a vertex";
    const auto euler =
        static_cast<std::ptrdiff_t>(nodes_ + triangles) - static_cast<std::ptrdiff_t>(edges);
    const bool boundary = incidence_.on_boundary[vertex];
    if (boundary != (free_edges > 0)) return "has a boundary that is not in the boundary";
    if (euler == (boundary ? 1 : 2)) return {};
    return std::string("is not a ") + (boundary ? "disc" : "sphere") +
           ": its Euler characteristic is " + std::to_string(euler);
  }

 private:
  std::size_t collect(std::uint32_t vertex) {
    edges_.clear();
    nodes_ = 0;
    std::uint32_t triangle = 0;
    for (const std::uint32_t c : incidence_.cells_at[vertex]) {
      const Hexahedron& cell = incidence_.cells[c];
      const auto& neighbours = kCornerNeighbours[corner_at(cell, vertex)];
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t j = (i + 1) % 3;
        const std::uint32_t a = cell[neighbours[i]], b = cell[neighbours[j]];
        LinkEdge edge{pair_key(a, b), {3 * triangle + i, 3 * triangle + j}};
        if (a > b) std::swap(edge.corners[0], edge.corners[1]);
        edges_.push_back(edge);
        if (node_of_[a] != vertex + 1) ++nodes_;
        node_of_[a] = vertex + 1;
      }
      ++triangle;
    }
    std::sort(edges_.begin(), edges_.end(),
              [](const LinkEdge& a, const LinkEdge& b) { return a.ends < b.ends; });
    return triangle;
  }

  /// Corners of triangles at one vertex of the link become one class for each fan of triangles; so
  /// there are as many classes as vertices exactly when each vertex has one fan.
  void glue(const LinkEdge& a, const LinkEdge& b) {
    glued_.unite(a.corners[0], b.corners[0]);
    glued_.unite(a.corners[1], b.corners[1]);
    connected_.unite(a.corners[0] / 3, b.corners[0] / 3);
  }

  const Incidence& incidence_;
  std::vector<LinkEdge> edges_;
  std::vector<std::uint32_t> node_of_;  ///< the last vertex with it in its link, and one more
  std::size_t nodes_ = 0;
  DisjointSets glued_{0};
  DisjointSets connected_{0};
};

}  // namespace

Finding check_links(const Incidence& incidence) {
  LinkChecker checker(incidence);
  for (std::uint32_t vertex = 0; vertex < incidence.vertex_count; ++vertex) {
    if (incidence.cells_at[vertex].empty()) continue;
    const std::string broken = checker.broken(vertex);
    if (!broken.empty()) {
      return Failure{Law::kLink, "the link of vertex " + std::to_string(vertex) + " " + broken};
    }
  }
  return std::nullopt;
}

}  // namespace hexatlas::check
