#include "tables/check/incidence.hpp"

#include <algorithm>
#include <utility>

namespace hexatlas::check {

namespace {

/// Vertices of a face in ascending order, two in a number, so that keys compare fast.
template <std::size_t size>
using Key = std::array<std::uint64_t, size / 2>;

template <std::size_t size>
Key<size> key_of(const Hexahedron& cell, const std::array<unsigned, size>& corners) {
  std::array<std::uint32_t, size> face{};
  for (std::size_t i = 0; i < size; ++i) {
    std::size_t at = i;
    for (; at > 0 && face[at - 1] > cell[corners[i]]; --at) face[at] = face[at - 1];
    face[at] = cell[corners[i]];
  }
  Key<size> key{};
  for (std::size_t i = 0; i < size; i += 2) key[i / 2] = pair_key(face[i], face[i + 1]);
  return key;
}

template <std::size_t size>
struct Keyed {
  Key<size> key;
  std::uint32_t place;
  auto operator<=>(const Keyed&) const = default;
};

/// Sorts what begins with a key of vertices below `vertex_count`: dealt to their least vertices
/// first, since those of one vertex are few.
template <std::size_t size>
std::vector<Keyed<size>> sorted(const std::vector<Keyed<size>>& faces, std::uint32_t vertex_count) {
  std::vector<std::uint32_t> end(vertex_count + 1, 0);
  const auto least = [](const Keyed<size>& face) { return pair_of(face.key[0])[0]; };
  for (const Keyed<size>& face : faces) ++end[least(face) + 1];
  for (std::size_t v = 0; v < vertex_count; ++v) end[v + 1] += end[v];
  std::vector<Keyed<size>> result(faces.size());
  for (const Keyed<size>& face : faces) result[end[least(face)]++] = face;
  auto begin = result.begin();
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto next = result.begin() + end[v];
    std::sort(begin, next);
    begin = next;
  }
  return result;
}

/// The keys of the faces given by `corners`, with their places, sorted.
template <std::size_t size, std::size_t faces>
std::vector<Keyed<size>> sorted_faces(
    const Incidence& incidence, const std::array<std::array<unsigned, size>, faces>& corners) {
  std::vector<Keyed<size>> result;
  result.reserve(incidence.cells.size() * faces);
  for (const Hexahedron& cell : incidence.cells) {
    for (const auto& face : corners)
      result.push_back({key_of(cell, face), static_cast<std::uint32_t>(result.size())});
  }
  return sorted(result, incidence.vertex_count);
}

void find_facets(Incidence& incidence) {
  const auto faces = sorted_faces(incidence, kQuadCorners);
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
  const auto faces = sorted_faces(incidence, kEdgeCorners);
  incidence.edge_of.resize(incidence.cells.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == 0 || faces[i].key != faces[i - 1].key)
      incidence.edges.push_back(pair_of(faces[i].key[0]));
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
