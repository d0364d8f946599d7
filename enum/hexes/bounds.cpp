#include "enum/hexes/bounds.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "enum/core/rank.hpp"

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
  const std::size_t facets = rows.size();
  return static_cast<int>(facets - core::rank_modulo_2(std::move(rows)));
}

/// The components of the open link of a vertex: the graph with an edge for each open facet at it,
/// between its two neighbours in the facet.
struct OpenLink {
  int vertices = 0, components = 0;
};

OpenLink open_link(const OpenFacets& open, Vertex v) {
  std::array<Vertex, kMaxMeshVertices> parent{};
  const auto root = [&](Vertex x) {
    while (parent[x] != x) x = parent[x];
    return x;
  };
  VertexSet ends = 0;
  OpenLink link;
  for (const OpenFacets::Corner& corner : open.at(v)) {
    const Facet& f = open.facet(corner.place);
    const std::array<Vertex, 2> pair{f[(corner.at + 1U) % 4], f[(corner.at + 3U) % 4]};
    for (const Vertex x : pair) {
      if ((ends & bit(x)) != 0) continue;
      ends |= bit(x);
      parent[x] = x;
      ++link.components;
    }
    if (root(pair[0]) == root(pair[1])) continue;
    parent[root(pair[0])] = root(pair[1]);
    --link.components;
  }
  link.vertices = std::popcount(ends);
  return link;
}

/// At least as many as the disjoint cycles that make up an open link: each has three edges, and
/// they are independent.
int most_cycles(const PartialMesh& mesh, const OpenFacets& open, Vertex v) {
  const int edges = mesh.open_at(v);
  if (edges < 6) return edges / 3;
  const OpenLink link = open_link(open, v);
  return std::min(edges / 3, edges - link.vertices + link.components);
}

/// Facets a and b with the edge of a from corner i, at which b has corner k.
bool fit_across(const OpenFacets& open, std::size_t a, std::size_t b, std::size_t i,
                std::size_t k) {
  const Facet& g = open.facet(b);
  const bool forward = g[(k + 1) % 4] == open.facet(a)[(i + 1) % 4];
  const Vertex over_first = g[(k + (forward ? 3 : 1)) % 4], over_second = g[(k + 2) % 4];
  return (open.above(a)[i] & bit(over_first)) != 0 &&
         (open.above(a)[(i + 1) % 4] & bit(over_second)) != 0;
}

bool fit_opposite(const OpenFacets& open, std::size_t a, std::size_t b) {
  const auto& above = open.above(a);
  const VertexSet set = open.vertices_of(b);
  for (const VertexSet tops : above)
    if ((tops & set) == 0) return false;
  const Facet& g = open.facet(b);
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

/// Whether open facets a and b may be facets of one hexahedron, as far as their vertices tell.
bool fit_one_hexahedron(const OpenFacets& open, std::size_t a, std::size_t b) {
  const VertexSet common = open.vertices_of(a) & open.vertices_of(b);
  if (common == 0) return fit_opposite(open, a, b);
  const Facet& f = open.facet(a);
  for (std::size_t i = 0; i < 4; ++i) {
    if (common != (bit(f[i]) | bit(f[(i + 1) % 4]))) continue;
    const Facet& g = open.facet(b);
    std::size_t k = 0;
    while (g[k] != f[i]) ++k;
    return fit_across(open, a, b, i, k);
  }
  return false;
}

template <class Visit>
void for_each(VertexSet set, Visit&& visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<Vertex>(std::countr_zero(set)));
}

/// For each vertex the *ears*: pairs of open facets with a common edge at it that one hexahedron
/// may have both.
class Ears {
 public:
  Ears(const PartialMesh& mesh, const OpenFacets& open) {
    for (std::size_t a = 0; a < open.size(); ++a)
      for (std::size_t i = 0; i < 4; ++i) look_across(mesh, open, a, i);
  }

  /// Edges whose two open facets cannot be of one hexahedron.
  [[nodiscard]] int unfit_edges() const { return unfit_edges_; }

  /// At most so many components of the hexahedra to come at v have two triangles less in the link
  /// of v than open edges: each takes two disjoint ears, or three between three facets.
  [[nodiscard]] int most_short_fans(Vertex v) const {
    const List& list = at_[v];
    if (list.count > kKept) return list.count;  // so many that it does not matter
    const auto disjoint = [](const Ear& p, const Ear& q) {
      return p[0] != q[0] && p[0] != q[1] && p[1] != q[0] && p[1] != q[1];
    };
    for (int p = 0; p < list.count; ++p)
      for (int q = 0; q < p; ++q)
        if (disjoint(list.ears[place(p)], list.ears[place(q)])) return list.count / 2;
    return list.count == 3 && is_triangle(list) ? 1 : 0;
  }

 private:
  static constexpr int kKept = 16;
  using Ear = std::array<std::uint16_t, 2>;
  struct List {
    int count = 0;
    std::array<Ear, kKept> ears{};
  };

  static std::size_t place(int i) { return static_cast<std::size_t>(i); }

  /// Three pairs, none of them disjoint, of three facets and not of four.
  static bool is_triangle(const List& list) {
    const auto& [p, q, r] = std::tie(list.ears[0], list.ears[1], list.ears[2]);
    const auto common = p[0] == q[0] || p[0] == q[1] ? p[0] : p[1];
    return r[0] != common && r[1] != common;
  }

  void add(Vertex v, const Ear& ear) {
    List& list = at_[v];
    if (list.count < kKept) list.ears[place(list.count)] = ear;
    ++list.count;
  }

  /// The edge of facet a from corner i, and the facets after a that have it too. No two vertices
  /// are an edge of one facet and a diagonal of another one.
  void look_across(const PartialMesh& mesh, const OpenFacets& open, std::size_t a, std::size_t i) {
    const Vertex u = open.facet(a)[i], w = open.facet(a)[(i + 1) % 4];
    for (const OpenFacets::Corner& corner : open.at(u)) {
      const std::size_t b = corner.place;
      if (b <= a || (open.vertices_of(b) & bit(w)) == 0) continue;
      if (fit_across(open, a, b, i, corner.at)) {
        const Ear ear{static_cast<std::uint16_t>(a), corner.place};
        add(u, ear);
        add(w, ear);
      } else if (mesh.open_at(u, w) == 2) {
        ++unfit_edges_;
      }
    }
  }

  std::array<List, kMaxMeshVertices> at_;
  int unfit_edges_ = 0;
};

}  // namespace

bool exceeds_face_budget(const PartialMesh& mesh, int left) {
  const int open = mesh.open_count();
  if (open == 0) return false;
  // A component to come has a closed surface of at least six of the open facets.
  const int most_components = std::min(left, open / 6);
  if (open > 4 * left + 2 * most_components) return true;
  return open > 4 * left + 2 && open > 4 * left + 2 * cycle_space(mesh);
}

void OpenFacets::list(const PartialMesh& mesh) {
  facet_.clear();
  set_.clear();
  above_.clear();
  std::array<std::uint16_t, kMaxMeshVertices> count{};
  mesh.open().for_each([&](int number) {
    const Facet& f = mesh.facet(number);
    facet_.push_back(f);
    set_.push_back(bit(f[0]) | bit(f[1]) | bit(f[2]) | bit(f[3]));
    above_.push_back({mesh.tops_over(number, 0), mesh.tops_over(number, 1),
                      mesh.tops_over(number, 2), mesh.tops_over(number, 3)});
    for (const Vertex v : f) ++count[v];
  });
  std::array<std::uint16_t, kMaxMeshVertices> next{};
  for (std::size_t v = 0; v < count.size(); ++v) {
    next[v] = begin_[v];
    begin_[v + 1] = static_cast<std::uint16_t>(begin_[v] + count[v]);
  }
  corners_.resize(4 * facet_.size());
  for (std::size_t place = 0; place < facet_.size(); ++place) {
    const Facet& f = facet_[place];
    for (std::size_t i = 0; i < 4; ++i)
      corners_[next[f[i]]++] = {static_cast<std::uint16_t>(place), static_cast<std::uint8_t>(i)};
  }
}

bool closes_badly(const PartialMesh& mesh) {
  for (const Vertex v : mesh.cells().back()) {
    const int discs = 2 - mesh.link_euler(v);
    if (mesh.open_at(v) == 0 ? discs != 0 : 3 * discs > mesh.open_at(v)) return true;
  }
  return false;
}

/// No component needs to save a corner, no edge to have two facets of one hexahedron.
bool is_ample(const PartialMesh& mesh, int left) noexcept {
  int due = 4 * mesh.new_vertices().all;
  for_each(mesh.open_vertices(), [&](Vertex v) {
    due += mesh.is_interior(v) ? std::max(mesh.open_at(v), 4 - mesh.cells_at(v)) : mesh.open_at(v);
  });
  const int most_edges = 2 * mesh.open_count();
  const int for_edges = 3 * (mesh.new_vertices().all + mesh.euler()) + mesh.open_count() / 2;
  return due <= 8 * left && (!mesh.is_for_balls() || for_edges + most_edges <= 6 * left);
}

int new_vertices_within(const PartialMesh& mesh, const OpenFacets& open, int left, bool ears) {
  const bool ball = mesh.is_for_balls();
  std::optional<Ears> found;
  if (ears) found.emplace(mesh, open);
  int due = 0;
  for_each(mesh.open_vertices(), [&](Vertex v) {
    int savings = ball ? 2 - mesh.link_euler(v) : most_cycles(mesh, open, v);
    if (found) savings = std::min(savings, found->most_short_fans(v));
    const int corners = mesh.open_at(v) - 2 * savings;
    due += mesh.is_interior(v) ? std::max(corners, 4 - mesh.cells_at(v)) : corners;
  });
  const int room = 8 * left - due;
  if (room < 0) return -1;
  if (!ball) return room / 4;
  const int for_edges =
      6 * left - mesh.open_count() / 2 - 3 * mesh.euler() - (found ? found->unfit_edges() : 0);
  return for_edges < 0 ? -1 : std::min(room / 4, for_edges / 3);
}

Tightest tightest(PartialMesh& mesh, const NewVertices& new_vertices) {
  struct Candidate {
    std::uint64_t combinations = 0;
    int facet = 0;
    bool operator<(const Candidate& other) const {
      return std::tie(combinations, facet) < std::tie(other.combinations, other.facet);
    }
  };
  std::array<Candidate, kMaxFacets> order;
  std::size_t count = 0;
  mesh.open().for_each([&](int number) {
    std::uint64_t combinations = 1;
    for (std::size_t i = 0; i < 4; ++i)
      combinations *= static_cast<std::uint64_t>(
          std::popcount(mesh.tops_over(number, i)) +
          static_cast<int>(mesh.may_be_new_over(mesh.facet(number)[i], new_vertices)));
    order[count++] = {combinations, number};
  });
  const std::size_t counted = std::min(kCounted, count);
  std::partial_sort(order.begin(), order.begin() + counted, order.begin() + count);
  Tightest result;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < counted && least > 0; ++i) {
    const int weight = mesh.weight_on(order[i].facet, new_vertices, least);
    if (weight >= least) continue;
    least = weight;
    result.facet = order[i].facet;
  }
  result.is_refuted = least == 0;
  return result;
}

std::vector<std::size_t> facets_apart(const OpenFacets& open, int left) {
  const std::size_t count = open.size();
  if (count <= static_cast<std::size_t>(left) || count > 64) return {};
  std::array<std::uint64_t, 64> apart{};
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      if (!fit_one_hexahedron(open, a, b)) {
        apart[a] |= std::uint64_t{1} << b;
        apart[b] |= std::uint64_t{1} << a;
      }
  std::vector<std::size_t> chosen;
  for (std::size_t first = 0; first < count; ++first) {
    chosen.assign(1, first);
    std::uint64_t candidates = apart[first];
    while (static_cast<int>(chosen.size()) <= left &&
           static_cast<int>(chosen.size()) + std::popcount(candidates) > left) {
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
      chosen.push_back(best);
      candidates &= apart[best];
    }
    if (static_cast<int>(chosen.size()) > left) return chosen;
  }
  return {};
}

}  // namespace hexatlas::hexes
