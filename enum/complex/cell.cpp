#include "enum/complex/cell.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "enum/cells/cube.hpp"

namespace hexatlas::complex {
namespace {

struct NamedCell {
  std::string_view name;
  int vertices;
  std::vector<std::vector<std::uint8_t>> facets;
};

CellFacet facet_from(const std::vector<std::uint8_t>& vertices) {
  CellFacet facet;
  facet.size = static_cast<std::uint8_t>(vertices.size());
  std::copy(vertices.begin(), vertices.end(), facet.vertex.begin());
  return facet;
}

const std::vector<NamedCell>& named_cells() {
  static const std::vector<NamedCell> cells = [] {
    std::vector<NamedCell> list{
        {"tetrahedron", 4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}},
        {"pyramid", 5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}}},
        {"prism", 6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}}},
        {"octahedron",
         6,
         {{0, 2, 4}, {1, 4, 2}, {1, 3, 4}, {0, 4, 3}, {0, 5, 2}, {1, 2, 5}, {1, 5, 3}, {0, 3, 5}}},
        {"hexahedron", cells::kCubeVertices, {}}};
    for (const auto& facet : cells::kFacetVertices)
      list.back().facets.emplace_back(facet.begin(), facet.end());
    return list;
  }();
  return cells;
}

/// Position of the directed edge a b in the facet, which has it.
std::size_t position(const CellFacet& facet, std::uint8_t a) {
  std::size_t at = 0;
  while (facet.vertex[at] != a) ++at;
  return at;
}

std::uint8_t vertex_after(const CellFacet& facet, std::size_t at, std::size_t steps) {
  return facet.vertex[(at + steps) % facet.size];
}

void reverse(CellFacet& facet) {
  std::reverse(facet.vertex.begin() + 1, facet.vertex.begin() + facet.size);
}

void start_with_least(CellFacet& facet) {
  const auto end = facet.vertex.begin() + facet.size;
  std::rotate(facet.vertex.begin(), std::min_element(facet.vertex.begin(), end), end);
}

/// The facet on the left of each directed edge; -1 if there is none.
class LeftFacets {
 public:
  explicit LeftFacets(const std::vector<CellFacet>& facets) {
    for (auto& row : left_) row.fill(-1);
    for (std::size_t f = 0; f < facets.size(); ++f)
      for (std::size_t i = 0; i < facets[f].size; ++i) {
        int& left = left_[facets[f].vertex[i]][vertex_after(facets[f], i, 1)];
        is_coherent_ = is_coherent_ && left < 0;
        left = static_cast<int>(f);
      }
  }
  [[nodiscard]] int of(std::uint8_t a, std::uint8_t b) const { return left_[a][b]; }
  [[nodiscard]] bool is_coherent() const { return is_coherent_; }

 private:
  std::array<std::array<int, kMaxCellVertices>, kMaxCellVertices> left_{};
  bool is_coherent_ = true;
};

std::string edge_text(int a, int b) {
  return std::to_string(std::min(a, b)) + " " + std::to_string(std::max(a, b));
}

using EdgeFacets =
    std::array<std::array<std::vector<std::size_t>, kMaxCellVertices>, kMaxCellVertices>;

std::optional<BrokenLaw> broken_facet_law(const std::vector<CellFacet>& facets, int vertices) {
  if (vertices > kMaxCellVertices)
    return BrokenLaw{std::to_string(vertices) + " vertices; a cell has at most " +
                     std::to_string(kMaxCellVertices)};
  if (facets.size() < 4) return BrokenLaw{"fewer than four facets"};
  std::set<VertexSet> seen;
  unsigned used = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const CellFacet& facet = facets[f];
    if (facet.size != 3 && facet.size != 4)
      return BrokenLaw{"a facet is neither a triangle nor a quad", f};
    for (std::size_t i = 0; i < facet.size; ++i)
      if (facet.vertex[i] >= vertices) return BrokenLaw{"a vertex is out of range", f};
    if (std::popcount(static_cast<unsigned>(facet.vertices())) != facet.size)
      return BrokenLaw{"a facet has a vertex twice", f};
    if (!seen.insert(facet.vertices()).second)
      return BrokenLaw{"a facet has the vertices of an earlier one", f};
    used |= facet.vertices();
  }
  for (int v = 0; v < vertices; ++v)
    if ((used & bit_of(v)) == 0)
      return BrokenLaw{"vertex " + std::to_string(v) + " lies on no facet"};
  return std::nullopt;
}

EdgeFacets facets_at_edges(const std::vector<CellFacet>& facets) {
  EdgeFacets at;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < facets[f].size; ++i) {
      const std::uint8_t a = facets[f].vertex[i];
      const std::uint8_t b = vertex_after(facets[f], i, 1);
      at[std::min(a, b)][std::max(a, b)].push_back(f);
    }
  return at;
}

/// Turns facets over to agree with the first, across common edges.
std::optional<BrokenLaw> make_coherent(std::vector<CellFacet>& facets, const EdgeFacets& at) {
  std::vector<bool> reached(facets.size(), false);
  std::vector<std::size_t> pending{0};
  reached[0] = true;
  while (!pending.empty()) {
    const std::size_t f = pending.back();
    pending.pop_back();
    for (std::size_t i = 0; i < facets[f].size; ++i) {
      const std::uint8_t a = facets[f].vertex[i];
      const std::uint8_t b = vertex_after(facets[f], i, 1);
      const auto& both = at[std::min(a, b)][std::max(a, b)];
      const std::size_t g = both[0] == f ? both[1] : both[0];
      if (reached[g]) continue;
      reached[g] = true;
      pending.push_back(g);
      if (vertex_after(facets[g], position(facets[g], a), 1) == b) reverse(facets[g]);
    }
  }
  if (std::find(reached.begin(), reached.end(), false) != reached.end())
    return BrokenLaw{"the surface is not connected"};
  if (!LeftFacets(facets).is_coherent()) return BrokenLaw{"the surface is not orientable"};
  return std::nullopt;
}

std::optional<BrokenLaw> broken_sphere_law(const std::vector<CellFacet>& facets, int vertices) {
  const LeftFacets left(facets);
  std::size_t sides = 0;
  for (const CellFacet& facet : facets) sides += facet.size;
  for (int vertex = 0; vertex < vertices; ++vertex) {
    const auto v = static_cast<std::uint8_t>(vertex);
    std::size_t degree = 0;
    for (const CellFacet& facet : facets) degree += (facet.vertices() & bit_of(v)) != 0 ? 1 : 0;
    const auto start = std::find_if(facets.begin(), facets.end(), [&](const CellFacet& facet) {
      return (facet.vertices() & bit_of(v)) != 0;
    });
    // Turn about v: the next facet lies on the left of v b if this one has b v.
    std::size_t turned = 0;
    auto f = static_cast<std::size_t>(start - facets.begin());
    do {
      const std::uint8_t before =
          vertex_after(facets[f], position(facets[f], v), facets[f].size - std::size_t{1});
      f = static_cast<std::size_t>(left.of(v, before));
      ++turned;
    } while (f != static_cast<std::size_t>(start - facets.begin()));
    if (turned != degree)
      return BrokenLaw{"the facets at vertex " + std::to_string(v) + " form more than one fan"};
  }
  const auto euler = vertices - static_cast<int>(sides / 2) + static_cast<int>(facets.size());
  if (euler != 2)
    return BrokenLaw{"the surface is no sphere: Euler characteristic " + std::to_string(euler)};
  return std::nullopt;
}

/// The map that takes facet 0 with its first edge to the directed edge a b, and keeps (or, if
/// `mirror`, reverses) orientation; nullopt if there is none.
std::optional<VertexMap> symmetry(const Cell& cell, const LeftFacets& left, std::uint8_t a,
                                  std::uint8_t b, bool mirror) {
  constexpr std::uint8_t kUnset = 255;
  VertexMap map{};
  map.fill(kUnset);
  const auto set = [&map](std::uint8_t from, std::uint8_t to) {
    if (map[from] == kUnset) map[from] = to;
    return map[from] == to;
  };
  std::vector<bool> done(cell.facets.size(), false);
  std::vector<std::size_t> pending{0};
  const CellFacet& first = cell.facets[0];
  if (!set(first.vertex[0], a) || !set(first.vertex[1], b)) return std::nullopt;
  done[0] = true;
  while (!pending.empty()) {
    const CellFacet& from = cell.facets[pending.back()];
    pending.pop_back();
    std::size_t i = 0;
    while (map[from.vertex[i]] == kUnset || map[vertex_after(from, i, 1)] == kUnset) ++i;
    const std::uint8_t tail = map[from.vertex[i]];
    const std::uint8_t head = map[vertex_after(from, i, 1)];
    const int g = mirror ? left.of(head, tail) : left.of(tail, head);
    if (g < 0 || cell.facets[static_cast<std::size_t>(g)].size != from.size) return std::nullopt;
    const CellFacet& to = cell.facets[static_cast<std::size_t>(g)];
    for (std::size_t k = 0; k < from.size; ++k)
      if (!set(vertex_after(from, i, k),
               vertex_after(to, position(to, tail), mirror ? from.size - k : k)))
        return std::nullopt;
    for (std::size_t k = 0; k < from.size; ++k) {
      const int next = left.of(vertex_after(from, k, 1), from.vertex[k]);
      if (done[static_cast<std::size_t>(next)]) continue;
      done[static_cast<std::size_t>(next)] = true;
      pending.push_back(static_cast<std::size_t>(next));
    }
  }
  for (std::size_t v = 0; v < map.size(); ++v)
    if (map[v] == kUnset) map[v] = static_cast<std::uint8_t>(v);
  return map;
}

}  // namespace

VertexSet CellFacet::vertices() const noexcept {
  unsigned set = 0;
  for (std::size_t i = 0; i < size; ++i) set |= 1U << vertex[i];
  return static_cast<VertexSet>(set);
}

std::span<const std::string_view> cell_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const NamedCell& cell : named_cells()) list.push_back(cell.name);
    return list;
  }();
  return names;
}

std::optional<Cell> cell_named(std::string_view name) {
  for (const NamedCell& named : named_cells())
    if (named.name == name) {
      Cell cell{named.vertices, {}};
      for (const auto& facet : named.facets) cell.facets.push_back(facet_from(facet));
      return cell;
    }
  return std::nullopt;
}

std::variant<Cell, BrokenLaw> cell_of(const std::vector<CellFacet>& facets, int vertices) {
  if (auto broken = broken_facet_law(facets, vertices)) return *broken;
  const EdgeFacets at = facets_at_edges(facets);
  for (int a = 0; a < vertices; ++a)
    for (int b = a + 1; b < vertices; ++b) {
      const auto& both = at[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      if (!both.empty() && both.size() != 2)
        return BrokenLaw{"edge " + edge_text(a, b) + " lies on " + std::to_string(both.size()) +
                             (both.size() == 1 ? " facet" : " facets"),
                         both.front()};
    }
  Cell cell{vertices, facets};
  if (auto broken = make_coherent(cell.facets, at)) return *broken;
  if (auto broken = broken_sphere_law(cell.facets, vertices)) return *broken;
  for (CellFacet& facet : cell.facets) start_with_least(facet);
  if (cut_surfaces(cell).empty())
    return BrokenLaw{"no choice of diagonals makes the facets a simplicial sphere"};
  return cell;
}

std::vector<VertexMap> symmetries(const Cell& cell) {
  const LeftFacets left(cell.facets);
  std::vector<VertexMap> result;
  for (const CellFacet& facet : cell.facets)
    for (std::size_t i = 0; i < facet.size; ++i)
      for (const bool mirror : {false, true}) {
        std::uint8_t a = facet.vertex[i];
        std::uint8_t b = vertex_after(facet, i, 1);
        if (mirror) std::swap(a, b);
        if (const auto map = symmetry(cell, left, a, b, mirror)) result.push_back(*map);
      }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<CutSurface> cut_surfaces(const Cell& cell) {
  std::vector<const CellFacet*> quads;
  CutSurface triangles_only;
  for (const CellFacet& facet : cell.facets) {
    if (facet.size == 4)
      quads.push_back(&facet);
    else
      triangles_only.triangles.push_back({facet.vertex[0], facet.vertex[1], facet.vertex[2]});
  }
  std::vector<CutSurface> result;
  for (std::uint32_t choice = 0; choice < (1U << quads.size()); ++choice) {
    CutSurface surface = triangles_only;
    surface.choice = choice;
    for (std::size_t q = 0; q < quads.size(); ++q) {
      const std::size_t start = (choice >> q) & 1U;
      const CellFacet& quad = *quads[q];
      for (const std::size_t corner : {start, start + 2})
        surface.triangles.push_back({vertex_after(quad, corner, 0), vertex_after(quad, corner, 1),
                                     vertex_after(quad, corner, 2)});
    }
    std::set<VertexSet> edges;
    for (const OrientedTriangle& t : surface.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        edges.insert(static_cast<VertexSet>(bit_of(t[i]) | bit_of(t[(i + 1) % 3])));
    // A sphere of triangles with b vertices has 3 b - 6 edges; simplicial if they are different.
    if (edges.size() == static_cast<std::size_t>(3 * cell.vertices - 6))
      result.push_back(std::move(surface));
  }
  return result;
}

}  // namespace hexatlas::complex
