#pragma once
/// \file
/// Which tetrahedra lie at each triangle. Private to enum/complex.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "enum/complex/triangulation.hpp"

namespace hexatlas::complex {

struct TrianglePlace {
  VertexSet triangle = 0;
  std::size_t count = 0;            ///< of tetrahedra at it
  std::array<std::size_t, 2> at{};  ///< the first two of them
};

/// Ascending by triangle. Cost: O(t log t).
[[nodiscard]] inline std::vector<TrianglePlace> tetrahedra_at_triangles(
    const Triangulation& triangulation) {
  std::vector<std::pair<VertexSet, std::size_t>> facets;
  facets.reserve(4 * triangulation.tetrahedra.size());
  for (std::size_t t = 0; t < triangulation.tetrahedra.size(); ++t) {
    const VertexSet tetrahedron = triangulation.tetrahedra[t];
    for (VertexSet rest = tetrahedron; rest != 0; rest = without_least(rest))
      facets.emplace_back(
          static_cast<VertexSet>(tetrahedron & ~static_cast<unsigned>(bit_of(least_vertex(rest)))),
          t);
  }
  std::sort(facets.begin(), facets.end());
  std::vector<TrianglePlace> places;
  for (const auto& [triangle, t] : facets) {
    if (places.empty() || places.back().triangle != triangle) places.push_back({triangle, 0, {}});
    TrianglePlace& place = places.back();
    if (place.count < 2) place.at[place.count] = t;
    ++place.count;
  }
  return places;
}

}  // namespace hexatlas::complex
