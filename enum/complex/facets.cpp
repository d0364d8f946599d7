#include "enum/complex/facets.hpp"

#include <algorithm>

#include "enum/cells/cube.hpp"

namespace hexatlas::complex {

std::vector<Facet> sorted_facets(const HexComplex& mesh) {
  std::vector<Facet> facets;
  facets.reserve(cells::kCubeFacets * mesh.hexahedra.size());
  for (std::uint32_t c = 0; c < mesh.hexahedra.size(); ++c)
    for (std::uint32_t f = 0; f < cells::kCubeFacets; ++f) {
      Facet facet{.cell = c, .facet = f};
      for (std::size_t i = 0; i < 4; ++i)
        facet.cycle[i] = mesh.hexahedra[c][cells::kFacetVertices[f][i]];
      facet.key = facet.cycle;
      std::sort(facet.key.begin(), facet.key.end());
      facets.push_back(facet);
    }
  std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) {
    return a.key != b.key ? a.key < b.key : a.cell < b.cell;
  });
  return facets;
}

bool are_opposite(const BoundaryQuad& a, const BoundaryQuad& b) noexcept {
  const auto at = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  for (std::size_t i = 0; i < 4; ++i)
    if (at == 4 || a[i] != b[(at + 4 - i) % 4]) return false;
  return true;
}

BoundaryQuad from_least(BoundaryQuad cycle) noexcept {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

}  // namespace hexatlas::complex
