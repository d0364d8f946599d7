#pragma once
/// \file
/// Private to meshing/delaunay: the tetrahedra that join one site to the facets around it become
/// neighbours of each other.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/digging.hpp"
#include "meshing/delaunay/local_vertices.hpp"

namespace hexatlas::delaunay {

/// New cell i has the site as vertex 0, then the vertices of facet i. Two of them are neighbours
/// where their facets share an edge. By small numbers of the vertices if there are few, else by
/// sorting the edges.
template <class Index>
class StarLinks {
 public:
  using Claim = typename LocalVertices<Index>::Claim;
  using Facet = CavityFacet<Index>;

  explicit StarLinks(Claim* claims) : locals_(claims), edges_(kEdges) {}
  void use(Claim* claims) noexcept { locals_.use(claims); }

  /// The vertices that the facets have, each once or more; false if they are too many for small
  /// numbers.
  [[nodiscard]] bool number(std::span<const Index> vertices) noexcept {
    return locals_.number(vertices);
  }

  /// Requires that all vertices of the facets were numbered.
  void link(Cells<Index>& cells, std::span<const Facet> facets, const Index* new_cells);
  /// For any vertices.
  void link_by_sorting(Cells<Index>& cells, std::span<const Facet> facets, const Index* new_cells);

 private:
  static constexpr std::size_t kMost = LocalVertices<Index>::kMost;
  static constexpr std::size_t kEdges = kMost * kMost;
  using Numbers = std::array<std::uint32_t, 3>;

  LocalVertices<Index> locals_;
  std::vector<Index> edges_;                     ///< references, by two local numbers
  std::vector<Numbers> numbers_;                 ///< of the vertices of each facet
  std::vector<std::array<Index, 3>> far_edges_;  ///< two vertices and a reference
};

template <class Index>
void StarLinks<Index>::link(Cells<Index>& cells, std::span<const Facet> facets,
                            const Index* new_cells) {
  if (numbers_.size() < facets.size()) numbers_.resize(2 * facets.size());
  Index* const edges = edges_.data();
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto& v = facets[i].vertices;
    const unsigned a = locals_.number_of(v[0]), b = locals_.number_of(v[1]),
                   c = locals_.number_of(v[2]);
    const Index at = 4 * new_cells[i];
    numbers_[i] = {a, b, c};
    edges[kMost * b + c] = at + 1;
    edges[kMost * c + a] = at + 2;
    edges[kMost * a + b] = at + 3;
  }
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto [a, b, c] = numbers_[i];
    auto& neighbors = cells[new_cells[i]].neighbors;
    neighbors[1] = edges[kMost * c + b];
    neighbors[2] = edges[kMost * a + c];
    neighbors[3] = edges[kMost * b + a];
  }
}

/// The two references at each edge, brought together.
template <class Index>
void StarLinks<Index>::link_by_sorting(Cells<Index>& cells, std::span<const Facet> facets,
                                       const Index* new_cells) {
  far_edges_.clear();
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (unsigned k = 0; k < 3; ++k) {
      const auto& v = facets[i].vertices;
      const auto [low, high] = std::minmax(v[(k + 1) % 3], v[(k + 2) % 3]);
      far_edges_.push_back({low, high, static_cast<Index>(4 * new_cells[i] + k + 1)});
    }
  std::sort(far_edges_.begin(), far_edges_.end());
  for (std::size_t i = 0; i < far_edges_.size(); i += 2) {
    const Index a = far_edges_[i][2], b = far_edges_[i + 1][2];
    cells[a / 4].neighbors[a % 4] = b;
    cells[b / 4].neighbors[b % 4] = a;
  }
}

}  // namespace hexatlas::delaunay
