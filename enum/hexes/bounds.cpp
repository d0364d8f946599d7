#include "enum/hexes/bounds.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <utility>

namespace hexatlas::hexes {
namespace {

/// The dimension of the space of cycles of the open facets modulo 2: sets of them that meet each
/// edge an even number of times. Elimination, one row of edges per facet.
int cycle_space(const PartialMesh& mesh) {
  std::map<std::pair<Vertex, Vertex>, std::size_t> edges;
  std::vector<std::vector<std::size_t>> rows;
  mesh.open().for_each([&](int number) {
    const Facet& f = mesh.facet(number);
    std::vector<std::size_t> row;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ends = std::minmax(f[i], f[(i + 1) % 4]);
      row.push_back(edges.try_emplace({ends.first, ends.second}, edges.size()).first->second);
    }
    std::sort(row.begin(), row.end());
    rows.push_back(std::move(row));
  });
  std::map<std::size_t, std::vector<std::size_t>> with_pivot;
  int dependent = 0;
  for (std::vector<std::size_t>& row : rows) {
    while (!row.empty()) {
      const auto [place, is_new] = with_pivot.try_emplace(row.front(), row);
      if (is_new) break;
      std::vector<std::size_t> sum;
      std::set_symmetric_difference(row.begin(), row.end(), place->second.begin(),
                                    place->second.end(), std::back_inserter(sum));
      row = std::move(sum);
    }
    if (row.empty()) ++dependent;
  }
  return dependent;
}

/// The link of a vertex as far as it is open: an edge for each open facet, between its two
/// neighbours in the facet.
struct OpenLink {
  int edges = 0;
  VertexSet ends = 0;
};

int components(const PartialMesh& mesh, Vertex v) {
  std::array<Vertex, kMaxMeshVertices> parent{};
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = static_cast<Vertex>(i);
  const auto root = [&](Vertex x) {
    while (parent[x] != x) x = parent[x];
    return x;
  };
  VertexSet ends = 0;
  int joined = 0;
  mesh.open().for_each([&](int number) {
    const Facet& f = mesh.facet(number);
    for (std::size_t i = 0; i < 4; ++i) {
      if (f[i] != v) continue;
      const Vertex a = f[(i + 1) % 4], b = f[(i + 3) % 4];
      ends |= bit(a) | bit(b);
      if (root(a) == root(b)) continue;
      parent[root(a)] = root(b);
      ++joined;
    }
  });
  return std::popcount(ends) - joined;
}

/// At least as many as the disjoint cycles that make up an open link: each has three edges, and
/// they are independent.
int most_cycles(const PartialMesh& mesh, Vertex v, const OpenLink& link) {
  const int by_length = link.edges / 3;
  if (by_length <= 1) return by_length;
  return std::min(by_length, link.edges - std::popcount(link.ends) + components(mesh, v));
}

/// Whether a diagonal from one facet to another one at their common corner is none yet, or that of
/// an open facet around the corner.
bool may_be_diagonal(const PartialMesh& mesh, Vertex from, Vertex to, Vertex corner) {
  const int number = mesh.facet_at(from, to);
  if (number < 0) return true;
  const Facet& f = mesh.facet(number);
  return mesh.is_open(number) && std::find(f.begin(), f.end(), corner) != f.end();
}

/// Facets f and g with the edge of f from corner i; g continues at it as a, b, e, d or reversed.
bool fit_across(const PartialMesh& mesh, const OpenFacets& open, std::size_t a, std::size_t b,
                std::size_t i) {
  const Facet& f = mesh.facet(open.number[a]);
  const Facet& g = mesh.facet(open.number[b]);
  const Vertex u = f[i], v = f[(i + 1) % 4];
  std::size_t at = 0;
  while (g[at] != u) ++at;
  const bool forward = g[(at + 1) % 4] == v;
  const Vertex over_u = g[(at + (forward ? 3 : 1)) % 4], over_v = g[(at + 2) % 4];
  if ((open.above[a][i] & bit(over_u)) == 0 || (open.above[a][(i + 1) % 4] & bit(over_v)) == 0)
    return false;
  return may_be_diagonal(mesh, f[(i + 2) % 4], over_v, v) &&
         may_be_diagonal(mesh, f[(i + 3) % 4], over_u, u);
}

bool fit_opposite(const OpenFacets& open, std::size_t a, const Facet& g) {
  const auto& above = open.above[a];
  for (std::size_t turn = 0; turn < 4; ++turn) {
    bool forward = true, backward = true;
    for (std::size_t i = 0; i < 4; ++i) {
      forward = forward && (above[i] & bit(g[(turn + i) % 4])) != 0;
      backward = backward && (above[i] & bit(g[(turn + 4 - i) % 4])) != 0;
    }
    if (forward || backward) return true;
  }
  return false;
}

}  // namespace

bool exceeds_face_budget(const PartialMesh& mesh, int left) {
  const int open = mesh.open_count();
  if (open == 0) return false;
  // A component to come has a closed surface of at least six of the open facets.
  const int most_components = std::min(left, open / 6);
  if (open > 4 * left + 2 * most_components) return true;
  return open > 4 * left + 2 && open > 4 * left + 2 * cycle_space(mesh);
}

int new_vertices_within(const PartialMesh& mesh, int left) {
  std::array<OpenLink, kMaxMeshVertices> links{};
  VertexSet touched = 0;
  mesh.open().for_each([&](int number) {
    const Facet& f = mesh.facet(number);
    for (std::size_t i = 0; i < 4; ++i) {
      OpenLink& link = links[f[i]];
      ++link.edges;
      link.ends |= bit(f[(i + 1) % 4]) | bit(f[(i + 3) % 4]);
      touched |= bit(f[i]);
    }
  });
  int due = 0;
  for (VertexSet rest = touched; rest != 0; rest &= rest - 1) {
    const int v = std::countr_zero(rest);
    const OpenLink& link = links[static_cast<std::size_t>(v)];
    int corners = link.edges - 2 * most_cycles(mesh, static_cast<Vertex>(v), link);
    if (mesh.is_interior(v)) corners = std::max(corners, 4 - mesh.cells_at(v));
    due += corners;
  }
  const int room = 8 * left - due;
  return room < 0 ? -1 : room / 4;
}

void list_open_facets(const PartialMesh& mesh, bool new_vertices, OpenFacets& result) {
  result.number.clear();
  result.above.clear();
  result.is_refuted = false;
  std::uint64_t fewest = ~std::uint64_t{0};
  mesh.open().for_each([&](int number) {
    const Facet& f = mesh.facet(number);
    std::array<VertexSet, 4> above{};
    std::uint64_t combinations = 1;
    for (std::size_t i = 0; i < 4; ++i) {
      above[i] = mesh.above(f, i);
      combinations *= static_cast<std::uint64_t>(std::popcount(above[i])) + (new_vertices ? 1 : 0);
    }
    if (combinations == 0) result.is_refuted = true;
    if (combinations < fewest) {
      fewest = combinations;
      result.tightest = result.number.size();
    }
    result.number.push_back(number);
    result.above.push_back(above);
  });
}

bool fit_one_hexahedron(const PartialMesh& mesh, const OpenFacets& open, std::size_t a,
                        std::size_t b) {
  const Facet& f = mesh.facet(open.number[a]);
  const Facet& g = mesh.facet(open.number[b]);
  VertexSet in_g = 0;
  for (const Vertex v : g) in_g |= bit(v);
  unsigned common = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if ((in_g & bit(f[i])) != 0) common |= 1U << i;
  switch (common) {
    case 0:
      return fit_opposite(open, a, g);
    case 0b0011:
      return fit_across(mesh, open, a, b, 0);
    case 0b0110:
      return fit_across(mesh, open, a, b, 1);
    case 0b1100:
      return fit_across(mesh, open, a, b, 2);
    case 0b1001:
      return fit_across(mesh, open, a, b, 3);
    default:
      return false;  // one vertex, two opposite ones, or more
  }
}

bool exceeds_cover_bound(const PartialMesh& mesh, const OpenFacets& open, int left) {
  const std::size_t count = open.number.size();
  if (count <= static_cast<std::size_t>(left) || count > 64) return false;
  std::array<std::uint64_t, 64> apart{};
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      if (!fit_one_hexahedron(mesh, open, a, b)) {
        apart[a] |= std::uint64_t{1} << b;
        apart[b] |= std::uint64_t{1} << a;
      }
  for (std::size_t first = 0; first < count; ++first) {
    std::uint64_t candidates = apart[first];
    int size = 1;
    while (candidates != 0) {
      if (size + std::popcount(candidates) <= left) break;
      std::size_t best = 0;
      int most = -1;
      for (std::uint64_t rest = candidates; rest != 0; rest &= rest - 1) {
        const auto v = static_cast<std::size_t>(std::countr_zero(rest));
        const int next = std::popcount(apart[v] & candidates);
        if (next > most) {
          most = next;
          best = v;
        }
      }
      ++size;
      candidates &= apart[best];
    }
    if (size > left) return true;
  }
  return false;
}

}  // namespace hexatlas::hexes
