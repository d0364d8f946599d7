#include "enum/complex/hex_complex.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/complex/union_find.hpp"

namespace hexatlas::complex {
namespace {

std::string name(std::span<const VertexId> vertices) {
  std::string result;
  for (const VertexId v : vertices) result += (result.empty() ? "" : "-") + std::to_string(v);
  return result;
}

/// Two vertices of one hexahedron. `kind` tells how they lie in it: 1 an edge, 3 a body
/// diagonal; a facet diagonal has as kind the other diagonal of its facet, shifted by 2.
struct Pair {
  VertexId low = 0, high = 0;
  std::uint64_t kind = 0;
  std::uint32_t cell = 0;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

constexpr std::uint64_t kEdge = 1;
constexpr std::uint64_t kBodyDiagonal = 3;

/// The corners a ^ m and b ^ m complete the facet of the diagonal a, b = a ^ x ^ y, where m = x.
std::uint64_t facet_diagonal_kind(const Hexahedron& cell, unsigned a, unsigned b) {
  const unsigned axes = a ^ b;
  const unsigned one = axes & (~axes + 1U);
  const auto [low, high] = std::minmax(cell[a ^ one], cell[b ^ one]);
  return (std::uint64_t{high} << 32U | low) << 2U;
}

std::vector<Pair> all_pairs(const HexComplex& mesh) {
  std::vector<Pair> pairs;
  pairs.reserve(28 * mesh.hexahedra.size());
  for (std::uint32_t c = 0; c < mesh.hexahedra.size(); ++c) {
    const Hexahedron& cell = mesh.hexahedra[c];
    for (unsigned a = 0; a < 8; ++a)
      for (unsigned b = a + 1; b < 8; ++b) {
        const int distance = std::popcount(a ^ b);
        const std::uint64_t kind = distance == 1   ? kEdge
                                   : distance == 3 ? kBodyDiagonal
                                                   : facet_diagonal_kind(cell, a, b);
        const auto [low, high] = std::minmax(cell[a], cell[b]);
        pairs.push_back({low, high, kind, c});
      }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::optional<BrokenLaw> cells_law(const HexComplex& mesh) {
  std::vector<bool> used(mesh.vertices, false);
  for (std::size_t c = 0; c < mesh.hexahedra.size(); ++c) {
    Hexahedron cell = mesh.hexahedra[c];
    for (const VertexId v : cell) {
      if (v >= mesh.vertices)
        return BrokenLaw{"vertex " + std::to_string(v) + " does not exist", c};
      used[v] = true;
    }
    std::sort(cell.begin(), cell.end());
    const auto repeated = std::adjacent_find(cell.begin(), cell.end());
    if (repeated != cell.end())
      return BrokenLaw{"vertex " + std::to_string(*repeated) + " is repeated in a hexahedron", c};
  }
  if (mesh.hexahedra.empty()) return BrokenLaw{"there is no hexahedron"};
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end())
    return BrokenLaw{"vertex " + std::to_string(unused - used.begin()) + " is in no hexahedron"};
  return std::nullopt;
}

std::optional<BrokenLaw> strict_law(const HexComplex& mesh) {
  const std::vector<Pair> pairs = all_pairs(mesh);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const Pair& a = pairs[i - 1];
    const Pair& b = pairs[i];
    if (a.low != b.low || a.high != b.high) continue;
    if (a.kind == b.kind && a.kind != kBodyDiagonal) continue;
    const std::array<VertexId, 2> ends{a.low, a.high};
    return BrokenLaw{"hexahedra " + std::to_string(a.cell) + " and " + std::to_string(b.cell) +
                         " both contain vertices " + name(ends) +
                         " but no common edge or quad that does",
                     b.cell};
  }
  return std::nullopt;
}

std::optional<BrokenLaw> facets_law(const std::vector<Facet>& facets) {
  for (std::size_t i = 0; i < facets.size();) {
    std::size_t end = i + 1;
    while (end < facets.size() && facets[end].key == facets[i].key) ++end;
    if (end - i > 2)
      return BrokenLaw{
          "quad " + name(facets[i].key) + " is in " + std::to_string(end - i) + " hexahedra",
          facets[i + 2].cell};
    if (end - i == 2 && !are_opposite(facets[i].cycle, facets[i + 1].cycle))
      return BrokenLaw{"hexahedra " + std::to_string(facets[i].cell) + " and " +
                           std::to_string(facets[i + 1].cell) + " are oriented differently",
                       facets[i + 1].cell};
    i = end;
  }
  return std::nullopt;
}

std::optional<BrokenLaw> connected_law(const HexComplex& mesh) {
  UnionFind components(mesh.vertices);
  for (const Hexahedron& cell : mesh.hexahedra)
    for (const VertexId v : cell) components.unite(cell[0], v);
  if (components.count() != 1)
    return BrokenLaw{"the complex has " + std::to_string(components.count()) + " components"};
  return std::nullopt;
}

/// A triangle of the link of a vertex: the three neighbours in one hexahedron.
struct LinkTriangle {
  VertexId vertex = 0;
  std::array<VertexId, 3> neighbours{};
};

/// The link as a surface: connected, every point of it in a fan, Euler characteristic 1 or 2.
std::optional<std::string> link_fault(std::span<const LinkTriangle> link) {
  std::vector<std::array<VertexId, 2>> edges;
  std::vector<VertexId> points;
  for (const LinkTriangle& t : link)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t.neighbours[i], t.neighbours[(i + 1) % 3]);
      edges.push_back({low, high});
      points.push_back(t.neighbours[i]);
    }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::sort(edges.begin(), edges.end());
  const auto sides = static_cast<std::ptrdiff_t>(edges.size());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto distinct = static_cast<std::ptrdiff_t>(edges.size());
  const std::ptrdiff_t rim = 2 * distinct - sides;  // each edge is in one or two triangles

  UnionFind whole(link.size());
  for (const VertexId p : points) {
    UnionFind fan(link.size());
    std::vector<std::size_t> around;
    for (std::size_t t = 0; t < link.size(); ++t)
      if (std::find(link[t].neighbours.begin(), link[t].neighbours.end(), p) !=
          link[t].neighbours.end())
        around.push_back(t);
    std::size_t pieces = around.size();
    for (const std::size_t s : around)
      for (const std::size_t t : around) {
        if (s >= t) continue;
        whole.unite(s, t);
        int common = 0;
        for (const VertexId q : link[s].neighbours)
          common +=
              static_cast<int>(std::count(link[t].neighbours.begin(), link[t].neighbours.end(), q));
        if (common >= 2 && fan.unite(s, t)) --pieces;
      }
    if (pieces != 1) return "is pinched at vertex " + std::to_string(p);
  }
  if (whole.count() != 1) return "is not connected";
  const std::ptrdiff_t euler = static_cast<std::ptrdiff_t>(points.size()) - distinct +
                               static_cast<std::ptrdiff_t>(link.size());
  if (euler != (rim == 0 ? 2 : 1)) return "is neither a sphere nor a disc";
  return std::nullopt;
}

std::optional<BrokenLaw> links_law(const HexComplex& mesh) {
  std::vector<LinkTriangle> triangles;
  triangles.reserve(8 * mesh.hexahedra.size());
  for (const Hexahedron& cell : mesh.hexahedra)
    for (unsigned v = 0; v < 8; ++v)
      triangles.push_back({cell[v], {cell[v ^ 1U], cell[v ^ 2U], cell[v ^ 4U]}});
  std::stable_sort(
      triangles.begin(), triangles.end(),
      [](const LinkTriangle& a, const LinkTriangle& b) { return a.vertex < b.vertex; });
  for (std::size_t i = 0; i < triangles.size();) {
    std::size_t end = i;
    while (end < triangles.size() && triangles[end].vertex == triangles[i].vertex) ++end;
    if (const auto fault = link_fault(std::span(triangles).subspan(i, end - i)))
      return BrokenLaw{"the link of vertex " + std::to_string(triangles[i].vertex) + " " + *fault};
    i = end;
  }
  return std::nullopt;
}

/// Since vertex links are spheres and discs, the boundary is a closed surface.
std::optional<BrokenLaw> boundary_law(const HexComplex& mesh) {
  const std::vector<BoundaryQuad> quads = boundary_of(mesh);
  if (quads.empty()) return BrokenLaw{"there is no boundary"};
  UnionFind parts(mesh.vertices);
  std::vector<bool> on_boundary(mesh.vertices, false);
  std::size_t joined = 0;
  for (const BoundaryQuad& quad : quads)
    for (const VertexId v : quad) {
      on_boundary[v] = true;
      if (parts.unite(quad[0], v)) ++joined;
    }
  const auto vertices =
      static_cast<std::size_t>(std::count(on_boundary.begin(), on_boundary.end(), true));
  if (vertices - joined != 1)
    return BrokenLaw{"the boundary has " + std::to_string(vertices - joined) + " components"};
  if (vertices != quads.size() + 2)  // V - E + F = V - 2F + F
    return BrokenLaw{"the Euler characteristic of the boundary is " +
                     std::to_string(static_cast<std::ptrdiff_t>(vertices) -
                                    static_cast<std::ptrdiff_t>(quads.size())) +
                     ", a sphere has 2"};
  return std::nullopt;
}

}  // namespace

std::vector<BoundaryQuad> boundary_of(const HexComplex& mesh) {
  const std::vector<Facet> facets = sorted_facets(mesh);
  std::vector<Facet> once;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const bool same_before = i > 0 && facets[i - 1].key == facets[i].key;
    const bool same_after = i + 1 < facets.size() && facets[i + 1].key == facets[i].key;
    if (!same_before && !same_after) once.push_back(facets[i]);
  }
  std::sort(once.begin(), once.end(), [](const Facet& a, const Facet& b) {
    return std::pair(a.cell, a.facet) < std::pair(b.cell, b.facet);
  });
  std::vector<BoundaryQuad> result;
  result.reserve(once.size());
  for (const Facet& facet : once) result.push_back(facet.cycle);
  return result;
}

HexComplex renumbered(HexComplex mesh, std::span<const VertexId> first) {
  constexpr VertexId kUnset = 0xFFFFFFFF;
  std::vector<VertexId> number(mesh.vertices, kUnset);
  VertexId next = 0;
  for (const VertexId v : first) number[v] = next++;
  for (Hexahedron& cell : mesh.hexahedra)
    for (VertexId& v : cell) {
      if (number[v] == kUnset) number[v] = next++;
      v = number[v];
    }
  mesh.vertices = next;
  return mesh;
}

HexComplex mirrored(HexComplex mesh) {
  for (Hexahedron& cell : mesh.hexahedra) cells::exchange_axes(cell);
  return mesh;
}

HexComplex compacted(HexComplex mesh, int kept) {
  std::vector<VertexId> first(static_cast<std::size_t>(kept));
  std::iota(first.begin(), first.end(), VertexId{0});
  return renumbered(std::move(mesh), first);
}

bool has_boundary(const HexComplex& mesh, std::vector<BoundaryQuad> quads) {
  std::vector<BoundaryQuad> own = boundary_of(mesh);
  for (auto* list : {&own, &quads}) {
    std::transform(list->begin(), list->end(), list->begin(), from_least);
    std::sort(list->begin(), list->end());
  }
  return own == quads;
}

std::optional<BrokenLaw> validate(const HexComplex& mesh) {
  if (auto law = cells_law(mesh)) return law;
  if (auto law = strict_law(mesh)) return law;
  if (auto law = facets_law(sorted_facets(mesh))) return law;
  if (auto law = connected_law(mesh)) return law;
  if (auto law = links_law(mesh)) return law;
  return boundary_law(mesh);
}

}  // namespace hexatlas::complex
