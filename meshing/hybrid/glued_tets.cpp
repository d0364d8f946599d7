#include "meshing/hybrid/glued_tets.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::hybrid {
namespace {

/// The vertices of a facet, ascending, and whose it is: 4 t + the vertex opposite to it.
struct OwnedFacet {
  Triangle vertices{};
  std::uint32_t owner = 0;
};

OwnedFacet owned_facet(const Tetrahedron& tetrahedron, TetIndex t, std::size_t facet) {
  OwnedFacet result{{}, static_cast<std::uint32_t>(4 * t + facet)};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != facet) result.vertices[count++] = tetrahedron[i];
  std::sort(result.vertices.begin(), result.vertices.end());
  return result;
}

}  // namespace

GluedTets::GluedTets(const TetGraph& graph) {
  tetrahedra_.reserve(graph.size());
  across_.reserve(4 * graph.size());
  for (TetIndex t = 0; t < graph.size(); ++t) {
    tetrahedra_.push_back(graph[t]);
    for (unsigned facet = 0; facet < 4; ++facet) across_.push_back(graph.across(t, facet));
  }
}

GluedTets::GluedTets(std::vector<Tetrahedron> tetrahedra) : tetrahedra_(std::move(tetrahedra)) {
  core::expects(tetrahedra_.size() < (std::size_t{1} << 30U), "fewer than 2^30 tetrahedra");
  std::vector<OwnedFacet> facets;
  facets.reserve(4 * tetrahedra_.size());
  for (TetIndex t = 0; t < tetrahedra_.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) facets.push_back(owned_facet(tetrahedra_[t], t, i));
  std::sort(facets.begin(), facets.end(),
            [](const OwnedFacet& a, const OwnedFacet& b) { return a.vertices < b.vertices; });
  across_.assign(4 * tetrahedra_.size(), kOutside);
  for (std::size_t i = 1; i < facets.size(); ++i) {
    if (facets[i].vertices != facets[i - 1].vertices) continue;
    across_[facets[i].owner] = facets[i - 1].owner / 4;
    across_[facets[i - 1].owner] = facets[i].owner / 4;
  }
}

void GluedTets::replace(std::span<const TetIndex> old, std::span<const Tetrahedron> fresh) {
  constexpr std::uint32_t kNobody = 0xFFFF'FFFF;
  std::map<Triangle, std::uint32_t> open;  // the facet on the other side, or kNobody
  for (const TetIndex t : old)
    for (std::size_t i = 0; i < 4; ++i) {
      const TetIndex beyond = across(t, i);
      if (std::find(old.begin(), old.end(), beyond) != old.end()) continue;
      const Triangle triangle = owned_facet(tetrahedra_[t], t, i).vertices;
      std::uint32_t other = kNobody;
      if (beyond != kOutside)
        for (std::size_t j = 0; j < 4; ++j)
          if (const OwnedFacet facet = owned_facet(tetrahedra_[beyond], beyond, j);
              facet.vertices == triangle)
            other = facet.owner;
      open.emplace(triangle, other);
    }
  for (const Tetrahedron& vertices : fresh) {
    const auto t = static_cast<TetIndex>(tetrahedra_.size());
    tetrahedra_.push_back(vertices);
    across_.insert(across_.end(), 4, kOutside);
    for (std::size_t i = 0; i < 4; ++i) {
      const OwnedFacet facet = owned_facet(vertices, t, i);
      const auto [same, is_new] = open.emplace(facet.vertices, facet.owner);
      if (is_new) continue;
      if (same->second != kNobody) {
        across_[facet.owner] = same->second / 4;
        across_[same->second] = t;
      }
      open.erase(same);
    }
  }
  core::ensures(open.empty(), "tetrahedra are replaced by such with the same boundary");
}

}  // namespace hexatlas::hybrid
