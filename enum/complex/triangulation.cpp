#include "enum/complex/triangulation.hpp"

#include <algorithm>

#include "enum/complex/tetrahedra_at_triangles.hpp"

namespace hexatlas::complex {

std::array<std::uint8_t, 4> vertices_of(VertexSet tetrahedron) {
  std::array<std::uint8_t, 4> result{};
  for (std::uint8_t& vertex : result) {
    vertex = static_cast<std::uint8_t>(least_vertex(tetrahedron));
    tetrahedron = without_least(tetrahedron);
  }
  return result;
}

VertexSet image_of(VertexSet set, const VertexMap& map) noexcept {
  unsigned image = 0;
  for (; set != 0; set = without_least(set))
    image |= 1U << map[static_cast<std::size_t>(least_vertex(set))];
  return static_cast<VertexSet>(image);
}

Triangulation image_of(const Triangulation& triangulation, const VertexMap& map) {
  Triangulation result = triangulation;
  for (VertexSet& tetrahedron : result.tetrahedra) tetrahedron = image_of(tetrahedron, map);
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  return result;
}

std::vector<VertexSet> boundary_triangles(const Triangulation& triangulation) {
  std::vector<VertexSet> result;
  for (const TrianglePlace& place : tetrahedra_at_triangles(triangulation))
    if (place.count == 1) result.push_back(place.triangle);
  return result;
}

namespace {

/// Whether listing the triangle opposite a vertex in ascending order agrees with the orientation
/// that the ascending tetrahedron gives to it: the sign (-1)^rank of that vertex.
int parity_of_facet(VertexSet tetrahedron, VertexSet triangle) {
  const unsigned apex = static_cast<unsigned>(tetrahedron) & ~static_cast<unsigned>(triangle);
  const unsigned below = static_cast<unsigned>(tetrahedron) & (apex - 1U);
  return std::popcount(below) % 2 == 0 ? 1 : -1;
}

}  // namespace

std::optional<std::vector<int>> orientation_of(const Triangulation& triangulation) {
  const auto& tetrahedra = triangulation.tetrahedra;
  const std::vector<TrianglePlace> places = tetrahedra_at_triangles(triangulation);
  std::vector<int> sign(tetrahedra.size(), 0);
  std::vector<std::size_t> pending;
  if (!tetrahedra.empty()) {
    sign[0] = 1;
    pending.push_back(0);
  }
  while (!pending.empty()) {
    const std::size_t from = pending.back();
    pending.pop_back();
    for (const TrianglePlace& place : places) {
      if (place.count != 2 || (place.at[0] != from && place.at[1] != from)) continue;
      const std::size_t to = place.at[0] == from ? place.at[1] : place.at[0];
      const int wanted = -sign[from] * parity_of_facet(tetrahedra[from], place.triangle) *
                         parity_of_facet(tetrahedra[to], place.triangle);
      if (sign[to] == 0) {
        sign[to] = wanted;
        pending.push_back(to);
      } else if (sign[to] != wanted) {
        return std::nullopt;
      }
    }
  }
  return sign;
}

}  // namespace hexatlas::complex
