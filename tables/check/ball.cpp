#include "tables/check/ball.hpp"

#include <algorithm>
#include <bit>
#include <queue>
#include <tuple>

#include "tables/check/disjoint_sets.hpp"

namespace hexatlas::check {

namespace {

constexpr unsigned kShellingOrders = 6;
constexpr unsigned kCollapseOrders = 24;

/// A fixed scramble of 64 bits (the finalizer of SplitMix64): the same order on every machine.
std::uint64_t scramble(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

bool quads_touch(unsigned p, unsigned q) {
  for (const unsigned a : kQuadCorners[p]) {
    for (const unsigned b : kQuadCorners[q]) {
      if (a == b) return true;
    }
  }
  return false;
}

/// Whether the quads in `set` (bits) are connected through edges. Quads of a cube that touch share
/// an edge.
bool connected_quads(unsigned set) {
  if (set == 0) return false;
  unsigned reached = set & (~set + 1);
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (unsigned p = 0; p < 6; ++p) {
      for (unsigned q = 0; q < 6; ++q) {
        if ((reached >> p & 1) != 0 && (set >> q & 1) != 0 && quads_touch(p, q)) reached |= 1U << q;
      }
    }
  }
  return reached == set;
}

/// A set of quads of a hexahedron with the edges and vertices in them.
struct Patch {
  bool is_disc = false;  ///< the set and its complement are connected
  unsigned edges = 0;
  unsigned vertices = 0;
};

std::array<Patch, 64> make_patches() {
  std::array<Patch, 64> patches;
  for (unsigned set = 0; set < 64; ++set) {
    Patch& patch = patches[set];
    patch.is_disc = connected_quads(set) && connected_quads(63 & ~set);
    for (unsigned q = 0; q < 6; ++q) {
      if ((set >> q & 1) == 0) continue;
      for (const unsigned corner : kQuadCorners[q]) patch.vertices |= 1U << corner;
      for (unsigned e = 0; e < 12; ++e) {
        const auto& quad = kQuadCorners[q];
        const bool in_quad = std::count(quad.begin(), quad.end(), kEdgeCorners[e][0]) == 1 &&
                             std::count(quad.begin(), quad.end(), kEdgeCorners[e][1]) == 1;
        if (in_quad) patch.edges |= 1U << e;
      }
    }
  }
  return patches;
}

const Patch& patch_of(unsigned set) {
  static const std::array<Patch, 64> kPatches = make_patches();
  return kPatches[set];
}

/// The hexahedra of the rest around a face: how many, and which one if it is one.
struct Around {
  std::uint32_t count = 0;
  std::uint32_t parity = 0;  ///< their numbers, added bitwise without carry
};

/// A mesh from which hexahedra are taken off. Counts in how many of the rest each face lies.
class Remainder {
 public:
  explicit Remainder(const Incidence& incidence)
      : incidence_(incidence),
        present_(incidence.cells.size(), true),
        at_vertex_(incidence.vertex_count),
        at_edge_(incidence.edges.size()),
        at_facet_(incidence.facets.size()) {
    for (std::uint32_t c = 0; c < incidence.cells.size(); ++c) count(c, 1);
  }

  [[nodiscard]] bool present(std::uint32_t c) const { return present_[c]; }

  /// The number of quads in which `c` meets the rest if these are a disc and all that they share,
  /// else 0.
  [[nodiscard]] unsigned quads_of_disc(std::uint32_t c) const {
    unsigned set = 0;
    unsigned edges = 0;
    unsigned vertices = 0;
    for (unsigned q = 0; q < 6; ++q) {
      if (at_facet_[incidence_.facet_of[c][q]].count > 1) set |= 1U << q;
    }
    const Patch& patch = patch_of(set);
    if (!patch.is_disc) return 0;
    for (unsigned e = 0; e < 12; ++e) {
      if (at_edge_[incidence_.edge_of[c][e]].count > 1) edges |= 1U << e;
    }
    for (unsigned v = 0; v < 8; ++v) {
      if (at_vertex_[incidence_.cells[c][v]].count > 1) vertices |= 1U << v;
    }
    if (edges != patch.edges || vertices != patch.vertices) return 0;
    return static_cast<unsigned>(std::popcount(set));
  }

  void remove(std::uint32_t c) {
    present_[c] = false;
    count(c, static_cast<std::uint32_t>(-1));
  }

  /// Calls visit(d) for each hexahedron d of the rest that shares less with the others since c was
  /// removed: it is now the only one at some face of c. A hexahedron may be visited repeatedly.
  template <class Visit>
  void for_each_freed_by(std::uint32_t c, Visit&& visit) const {
    const auto visit_last = [&](const Around& around) {
      if (around.count == 1) visit(around.parity);
    };
    for (const std::uint32_t vertex : incidence_.cells[c]) visit_last(at_vertex_[vertex]);
    for (const std::uint32_t edge : incidence_.edge_of[c]) visit_last(at_edge_[edge]);
    for (const std::uint32_t facet : incidence_.facet_of[c]) visit_last(at_facet_[facet]);
  }

 private:
  void count(std::uint32_t c, std::uint32_t change) {
    const auto note = [&](Around& around) {
      around.count += change;
      around.parity ^= c;
    };
    for (const std::uint32_t vertex : incidence_.cells[c]) note(at_vertex_[vertex]);
    for (const std::uint32_t edge : incidence_.edge_of[c]) note(at_edge_[edge]);
    for (const std::uint32_t facet : incidence_.facet_of[c]) note(at_facet_[facet]);
  }

  const Incidence& incidence_;
  std::vector<bool> present_;
  std::vector<Around> at_vertex_;
  std::vector<Around> at_edge_;
  std::vector<Around> at_facet_;
};

/// Greedy shelling backwards. Order 0 takes off a hexahedron with the fewest shared quads first,
/// order 1 one with the most, ties by number; of the others, even ones prefer the fewest, odd ones
/// the most, with scrambled ties.
class ShellingSearch {
 public:
  ShellingSearch(const Incidence& incidence, unsigned order)
      : incidence_(incidence),
        rest_(incidence),
        order_(order),
        queued_(incidence.cells.size(), 0) {}

  bool succeeds() {
    for (std::uint32_t c = 0; c < incidence_.cells.size(); ++c) offer(c);
    std::size_t left = incidence_.cells.size();
    while (left > 1 && !queue_.empty()) {
      const auto [rank, c] = queue_.top();
      queue_.pop();
      if (!rest_.present(c) || queued_[c] == 0 || rank != priority(c, queued_[c])) continue;
      rest_.remove(c);
      --left;
      rest_.for_each_freed_by(c, [this](std::uint32_t d) { offer(d); });
    }
    return left == 1;
  }

 private:
  using Entry = std::pair<std::uint64_t, std::uint32_t>;

  [[nodiscard]] std::uint64_t priority(std::uint32_t c, unsigned quads) const {
    const std::uint64_t first = order_ % 2 == 0 ? quads : 6 - quads;
    const std::uint64_t tie = order_ < 2 ? c : scramble(scramble(order_) + c) >> 8;
    return first << 56 | tie;
  }

  /// Keeps queued_[c] equal to what c shares with the rest; entries with another rank are stale.
  void offer(std::uint32_t c) {
    if (!rest_.present(c)) return;
    const unsigned quads = rest_.quads_of_disc(c);
    if (quads == queued_[c]) return;
    queued_[c] = quads;
    if (quads != 0) queue_.emplace(priority(c, quads), c);
  }

  const Incidence& incidence_;
  Remainder rest_;
  unsigned order_;
  std::vector<unsigned> queued_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// Greedy collapse. Hexahedra collapse from free quads in an order that varies; what is left of
/// the quads collapses from free edges in any order, since for dimension 2 the order is
/// irrelevant; what is left then must be a tree.
class CollapseSearch {
 public:
  CollapseSearch(const Incidence& incidence, unsigned order)
      : incidence_(incidence), order_(order) {}

  bool succeeds() { return collapse_hexahedra() && collapse_quads() && rest_is_tree(); }

 private:
  using Entry = std::pair<std::uint64_t, std::uint32_t>;

  /// Order 0: first come, first served. Order 1: last come, first served. Else scrambled.
  std::uint64_t priority(std::uint32_t facet) {
    ++clock_;
    if (order_ < 2) return order_ == 0 ? clock_ : ~clock_;
    return scramble(scramble(order_) + facet);
  }

  bool collapse_hexahedra() {
    std::vector<bool> cell_present(incidence_.cells.size(), true);
    facet_present_.assign(incidence_.facets.size(), true);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> free_facets;
    for (std::uint32_t f = 0; f < incidence_.facets.size(); ++f) {
      if (incidence_.facets[f].uses == 1) free_facets.emplace(priority(f), f);
    }
    std::size_t left = incidence_.cells.size();
    while (!free_facets.empty()) {
      const std::uint32_t f = free_facets.top().second;
      free_facets.pop();
      const Facet& facet = incidence_.facets[f];
      for (std::uint32_t use = 0; use < facet.uses; ++use) {
        const std::uint32_t c = facet.place[use] / 6;
        if (!cell_present[c]) continue;
        cell_present[c] = false;
        facet_present_[f] = false;
        --left;
        for (const std::uint32_t other : incidence_.facet_of[c]) {
          if (other != f && incidence_.facets[other].uses == 2) {
            free_facets.emplace(priority(other), other);
          }
        }
        break;
      }
    }
    return left == 0;
  }

  /// Edges of a facet, by the edges of a hexahedron that has it.
  [[nodiscard]] std::array<std::uint32_t, 4> edges_of(std::uint32_t f) const {
    const std::uint32_t place = incidence_.facets[f].place[0];
    const unsigned mask = patch_of(1U << (place % 6)).edges;
    std::array<std::uint32_t, 4> edges{};
    std::size_t found = 0;
    for (unsigned e = 0; e < 12; ++e) {
      if ((mask >> e & 1) != 0) edges[found++] = incidence_.edge_of[place / 6][e];
    }
    return edges;
  }

  bool collapse_quads() {
    std::vector<std::uint32_t> uses(incidence_.edges.size(), 0);
    std::vector<std::vector<std::uint32_t>> facets_at(incidence_.edges.size());
    std::size_t left = 0;
    for (std::uint32_t f = 0; f < incidence_.facets.size(); ++f) {
      if (!facet_present_[f]) continue;
      ++left;
      for (const std::uint32_t edge : edges_of(f)) {
        ++uses[edge];
        facets_at[edge].push_back(f);
      }
    }
    edge_present_.assign(incidence_.edges.size(), true);
    std::vector<std::uint32_t> free_edges;
    for (std::uint32_t edge = 0; edge < uses.size(); ++edge) {
      if (uses[edge] == 1) free_edges.push_back(edge);
    }
    while (!free_edges.empty()) {
      const std::uint32_t edge = free_edges.back();
      free_edges.pop_back();
      if (uses[edge] != 1) continue;
      edge_present_[edge] = false;
      --left;
      const auto f = *std::find_if(facets_at[edge].begin(), facets_at[edge].end(),
                                   [this](std::uint32_t g) { return facet_present_[g]; });
      facet_present_[f] = false;
      for (const std::uint32_t other : edges_of(f)) {
        if (--uses[other] == 1) free_edges.push_back(other);
      }
    }
    return left == 0;
  }

  [[nodiscard]] bool rest_is_tree() const {
    std::size_t vertices = 0;
    for (std::size_t v = 0; v < incidence_.vertex_count; ++v) {
      if (!incidence_.cells_at[v].empty()) ++vertices;
    }
    DisjointSets components(incidence_.vertex_count);
    std::size_t joined = 1;
    for (std::uint32_t edge = 0; edge < edge_present_.size(); ++edge) {
      if (!edge_present_[edge]) continue;
      const auto& ends = incidence_.edges[edge];
      if (!components.unite(ends[0], ends[1])) return false;
      ++joined;
    }
    return joined == vertices;
  }

  const Incidence& incidence_;
  unsigned order_;
  std::uint64_t clock_ = 0;
  std::vector<bool> facet_present_;
  std::vector<bool> edge_present_;
};

}  // namespace

bool is_removal_order(const Incidence& incidence, std::span<const std::uint32_t> order) {
  if (order.size() != incidence.cells.size()) return false;
  Remainder rest(incidence);
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (order[i] >= order.size() || !rest.present(order[i])) return false;
    if (rest.quads_of_disc(order[i]) == 0) return false;
    rest.remove(order[i]);
  }
  return order.back() < order.size() && rest.present(order.back());
}

std::uint32_t listed_removals(const Incidence& incidence) {
  Remainder rest(incidence);
  std::uint32_t c = 0;
  while (c + 1 < incidence.cells.size() && rest.quads_of_disc(c) != 0) rest.remove(c++);
  return c;
}

bool find_shelling(const Incidence& incidence) {
  for (unsigned order = 0; order < kShellingOrders; ++order) {
    if (ShellingSearch(incidence, order).succeeds()) return true;
  }
  return false;
}

bool find_collapse(const Incidence& incidence) {
  for (unsigned order = 0; order < kCollapseOrders; ++order) {
    if (CollapseSearch(incidence, order).succeeds()) return true;
  }
  return false;
}

}  // namespace hexatlas::check
