#include "enum/hexes/bounds.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
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

/// The components of the open link of a vertex: the graph with an edge for each open facet at it,
/// between its two neighbours in the facet.
struct OpenLink {
  int vertices = 0, components = 0;
};

OpenLink open_link(const PartialMesh& mesh, const OpenFacets& open, Vertex v) {
  std::array<Vertex, kMaxMeshVertices> parent{};
  const auto root = [&](Vertex x) {
    while (parent[x] != x) x = parent[x];
    return x;
  };
  VertexSet ends = 0;
  OpenLink link;
  for (const OpenFacets::Corner& corner : open.at(v)) {
    const Facet& f = mesh.facet(open.number(corner.place));
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
  const OpenLink link = open_link(mesh, open, v);
  return std::min(edges / 3, edges - link.vertices + link.components);
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
  const Facet& f = mesh.facet(open.number(a));
  const Facet& g = mesh.facet(open.number(b));
  const Vertex u = f[i], v = f[(i + 1) % 4];
  std::size_t at = 0;
  while (g[at] != u) ++at;
  const bool forward = g[(at + 1) % 4] == v;
  const Vertex over_u = g[(at + (forward ? 3 : 1)) % 4], over_v = g[(at + 2) % 4];
  if ((open.above(a)[i] & bit(over_u)) == 0 || (open.above(a)[(i + 1) % 4] & bit(over_v)) == 0)
    return false;
  return may_be_diagonal(mesh, f[(i + 2) % 4], over_v, v) &&
         may_be_diagonal(mesh, f[(i + 3) % 4], over_u, u);
}

bool fit_opposite(const OpenFacets& open, std::size_t a, const Facet& g) {
  const auto& above = open.above(a);
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

template <class Visit>
void for_each(VertexSet set, Visit&& visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<Vertex>(std::countr_zero(set)));
}

/// For each vertex the *ears*: pairs of open facets with a common edge at it that one hexahedron
/// may have both.
class Ears {
 public:
  Ears(const PartialMesh& mesh, const OpenFacets& open) {
    for_each(open.vertices(), [&](Vertex u) {
      const auto corners = open.at(u);
      for (std::size_t x = 0; x < corners.size(); ++x)
        for (std::size_t y = x + 1; y < corners.size(); ++y)
          look(mesh, open, u, corners[x], corners[y]);
    });
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

  /// Each edge is looked at from its lesser end.
  void look(const PartialMesh& mesh, const OpenFacets& open, Vertex u, OpenFacets::Corner x,
            OpenFacets::Corner y) {
    const Facet& f = mesh.facet(open.number(x.place));
    const Facet& g = mesh.facet(open.number(y.place));
    for (const std::size_t turn : {std::size_t{1}, std::size_t{3}}) {
      const Vertex w = f[(x.at + turn) % 4];
      if (w < u || (g[(y.at + 1U) % 4] != w && g[(y.at + 3U) % 4] != w)) continue;
      const std::size_t side = turn == 1 ? x.at : (x.at + 3U) % 4;
      if (fit_across(mesh, open, x.place, y.place, side)) {
        add(u, {x.place, y.place});
        add(w, {x.place, y.place});
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
  number_.clear();
  above_.clear();
  std::array<std::uint16_t, kMaxMeshVertices> count{};
  mesh.open().for_each([&](int number) {
    const Facet& f = mesh.facet(number);
    number_.push_back(number);
    above_.push_back({mesh.tops_over(number, 0), mesh.tops_over(number, 1),
                      mesh.tops_over(number, 2), mesh.tops_over(number, 3)});
    for (const Vertex v : f) ++count[v];
  });
  vertices_ = 0;
  std::array<std::uint16_t, kMaxMeshVertices> next{};
  for (std::size_t v = 0; v < count.size(); ++v) {
    next[v] = begin_[v];
    begin_[v + 1] = static_cast<std::uint16_t>(begin_[v] + count[v]);
    if (count[v] != 0) vertices_ |= bit(v);
  }
  corners_.resize(4 * number_.size());
  for (std::size_t place = 0; place < number_.size(); ++place) {
    const Facet& f = mesh.facet(number_[place]);
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

bool fit_one_hexahedron(const PartialMesh& mesh, const OpenFacets& open, std::size_t a,
                        std::size_t b) {
  const Facet& f = mesh.facet(open.number(a));
  const Facet& g = mesh.facet(open.number(b));
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

std::vector<std::size_t> facets_apart(const PartialMesh& mesh, const OpenFacets& open, int left) {
  const std::size_t count = open.size();
  if (count <= static_cast<std::size_t>(left) || count > 64) return {};
  std::array<std::uint64_t, 64> apart{};
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      if (!fit_one_hexahedron(mesh, open, a, b)) {
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
