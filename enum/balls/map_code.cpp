#include "enum/balls/map_code.hpp"

#include "enum/core/checks.hpp"

namespace hexatlas::balls {

SphereMap::SphereMap(int vertices) : vertices_(vertices) {
  core::expects(vertices >= 0 && vertices <= complex::kMaxCellVertices,
                "at most kMaxCellVertices vertices");
  for (auto& sense : turn_)
    for (Row& row : sense) row.fill(kNone);
}

void SphereMap::add(std::span<const std::uint8_t> facet) {
  for (std::size_t i = 0; i < facet.size(); ++i) {
    const std::uint8_t before = facet[i];
    const std::uint8_t corner = facet[(i + 1) % facet.size()];
    const std::uint8_t after = facet[(i + 2) % facet.size()];
    // The facet lies on the left of corner -> after, that is counter-clockwise of it.
    turn_[0][corner][after] = before;
    turn_[1][corner][before] = after;
  }
}

std::vector<SphereMap::Dart> SphereMap::darts() const {
  std::vector<Dart> result;
  for (std::size_t a = 0; a < complex::kMaxCellVertices; ++a)
    for (std::size_t b = 0; b < complex::kMaxCellVertices; ++b)
      if (turn_[0][a][b] != kNone)
        for (const bool mirrored : {false, true})
          result.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b), mirrored});
  return result;
}

MapWalk SphereMap::walk(Dart dart) const {
  const auto& turn = turn_[dart.mirrored ? 1 : 0];
  MapWalk walk;
  walk.code.fill(MapWalk::kEnd);
  Row number;
  number.fill(kNone);
  // The neighbour with which the turn about each vertex begins: the one it was reached from.
  Row first{};
  std::uint8_t reached = 2;
  number[dart.from] = 0;
  number[dart.to] = 1;
  walk.at[0] = dart.from;
  walk.at[1] = dart.to;
  first[dart.from] = dart.to;
  first[dart.to] = dart.from;
  std::size_t length = 0;
  for (std::uint8_t i = 0; i < reached; ++i) {
    const std::uint8_t v = walk.at[i];
    std::uint8_t w = first[v];
    do {
      if (number[w] == kNone) {
        number[w] = reached;
        first[w] = v;
        walk.at[reached++] = w;
      }
      walk.code[length++] = number[w];
      w = turn[v][w];
    } while (w != first[v]);
    ++length;
  }
  return walk;
}

SphereMap map_of(int vertices, std::span<const complex::CellFacet> facets) {
  SphereMap map(vertices);
  for (const complex::CellFacet& facet : facets) map.add(std::span(facet.vertex).first(facet.size));
  return map;
}

SphereMap map_of(int vertices, std::span<const complex::OrientedTriangle> triangles) {
  SphereMap map(vertices);
  for (const complex::OrientedTriangle& triangle : triangles) map.add(triangle);
  return map;
}

}  // namespace hexatlas::balls
