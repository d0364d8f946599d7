#include "tables/check/incidence.hpp"

#include <algorithm>
#include <utility>

namespace hexatlas::check {

namespace {

template <std::size_t size>
struct Keyed {
  std::array<std::uint32_t, size> key;
  std::uint32_t place;
  auto operator<=>(const Keyed&) const = default;
};

/// The vertex sets of the faces given by `corners`, with their places, sorted.
template <std::size_t size, std::size_t faces>
std::vector<Keyed<size>> sorted_faces(
    std::span<const Hexahedron> cells,
    const std::array<std::array<unsigned, size>, faces>& corners) {
  std::vector<Keyed<size>> result;
  result.reserve(cells.size() * faces);
  for (const Hexahedron& cell : cells) {
    for (const auto& face : corners) {
      Keyed<size> keyed{};
      for (std::size_t i = 0; i < size; ++i) keyed.key[i] = cell[face[i]];
      std::sort(keyed.key.begin(), keyed.key.end());
      keyed.place = static_cast<std::uint32_t>(result.size());
      result.push_back(keyed);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void find_facets(Incidence& incidence) {
  const auto faces = sorted_faces(incidence.cells, kQuadCorners);
  incidence.facet_of.resize(incidence.cells.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == 0 || faces[i].key != faces[i - 1].key) incidence.facets.emplace_back();
    Facet& facet = incidence.facets.back();
    if (facet.uses < 2) facet.place[facet.uses] = faces[i].place;
    ++facet.uses;
    incidence.facet_of[faces[i].place / 6][faces[i].place % 6] =
        static_cast<std::uint32_t>(incidence.facets.size() - 1);
  }
}

void find_edges(Incidence& incidence) {
  const auto faces = sorted_faces(incidence.cells, kEdgeCorners);
  incidence.edge_of.resize(incidence.cells.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == 0 || faces[i].key != faces[i - 1].key) incidence.edges.push_back(faces[i].key);
    incidence.edge_of[faces[i].place / 12][faces[i].place % 12] =
        static_cast<std::uint32_t>(incidence.edges.size() - 1);
  }
}

void find_cells_at(Incidence& incidence) {
  Lists& lists = incidence.cells_at;
  lists.start.assign(incidence.vertex_count + 1, 0);
  for (const Hexahedron& cell : incidence.cells) {
    for (const std::uint32_t vertex : cell) ++lists.start[vertex + 1];
  }
  for (std::size_t v = 0; v < incidence.vertex_count; ++v) lists.start[v + 1] += lists.start[v];
  lists.items.resize(incidence.cells.size() * 8);
  std::vector<std::uint32_t> next(lists.start.begin(), lists.start.end() - 1);
  for (std::uint32_t c = 0; c < incidence.cells.size(); ++c) {
    for (const std::uint32_t vertex : incidence.cells[c]) lists.items[next[vertex]++] = c;
  }
}

}  // namespace

Quad Incidence::quad_at(std::uint32_t place) const {
  Quad quad{};
  for (std::size_t i = 0; i < 4; ++i) quad[i] = cells[place / 6][kQuadCorners[place % 6][i]];
  return quad;
}

Incidence incidence_of(std::span<const Hexahedron> cells, std::uint32_t vertex_count) {
  Incidence incidence;
  incidence.cells = cells;
  incidence.vertex_count = vertex_count;
  find_cells_at(incidence);
  find_facets(incidence);
  find_edges(incidence);
  incidence.on_boundary.assign(vertex_count, false);
  for (const Facet& facet : incidence.facets) {
    if (facet.uses != 1) continue;
    for (const std::uint32_t vertex : incidence.quad_at(facet.place[0])) {
      incidence.on_boundary[vertex] = true;
    }
  }
  return incidence;
}

std::vector<Quad> boundary_quads(const Incidence& incidence) {
  std::vector<Quad> quads;
  for (const Facet& facet : incidence.facets) {
    if (facet.uses == 1) quads.push_back(incidence.quad_at(facet.place[0]));
  }
  return quads;
}

}  // namespace hexatlas::check
