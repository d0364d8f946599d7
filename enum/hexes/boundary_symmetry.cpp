#include "enum/hexes/boundary_symmetry.hpp"

#include <algorithm>

#include "enum/canon/code.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::hexes {
BoundarySymmetry::BoundarySymmetry(const complex::Quadrangulation& boundary, int first)
    : first_(first), boundary_vertices_(boundary.vertices()) {
  const auto vertices = static_cast<std::size_t>(boundary.vertices());
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  const canon::Labelling label = canon::labelling_from(boundary, flags.flags[0]);
  std::array<Vertex, complex::kMaxVertices> with_label{};
  for (std::size_t v = 0; v < vertices; ++v) with_label[label[v]] = static_cast<Vertex>(v);
  for (int k = 0; k < flags.count; ++k) {
    const canon::Labelling other =
        canon::labelling_from(boundary, flags.flags[static_cast<std::size_t>(k)]);
    Map map{};
    for (std::size_t v = 0; v < vertices; ++v) map[v] = with_label[other[v]];
    maps_.push_back(map);
  }
  const Facet target = boundary.vertices_of(first);
  for (int q = 0; q < boundary.quads(); ++q) {
    const Facet facet = boundary.vertices_of(q);
    std::vector<ToFirst>& to_first = to_first_.emplace_back();
    for (std::size_t m = 0; m < maps_.size(); ++m) {
      ToFirst entry{.map = m};
      bool fits = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto at = std::find(target.begin(), target.end(), maps_[m][facet[i]]);
        fits = fits && at != target.end();
        entry.corner[i] = static_cast<std::uint8_t>(at - target.begin());
      }
      if (fits) to_first.push_back(entry);
    }
  }
}

BoundarySymmetry::Type type_on_bottom(const Cell& cell, int boundary_vertices) noexcept {
  BoundarySymmetry::Type type{};
  for (std::size_t i = 0; i < 4; ++i)
    type[i] = cell[4 + i] < boundary_vertices ? cell[4 + i] : BoundarySymmetry::kInterior;
  return type;
}

bool BoundarySymmetry::has_no_lesser_image(const Cell& cell, const PartialMesh& mesh,
                                           const Type& type) const noexcept {
  for (const TurnedFacet& turned : kTurnedFacets) {
    const int q = mesh.facet_at(cell[turned.facet[0]], cell[turned.facet[2]]);
    if (q < 0 || static_cast<std::size_t>(q) >= to_first_.size()) continue;
    const Facet tops = tops_over(cell, mesh.facet(q));
    for (const ToFirst& to : to_first_[static_cast<std::size_t>(q)]) {
      Type image{};
      for (std::size_t i = 0; i < 4; ++i)
        image[to.corner[i]] = tops[i] < boundary_vertices_ ? maps_[to.map][tops[i]] : kInterior;
      if (image < type) return false;
    }
  }
  return true;
}

}  // namespace hexatlas::hexes
