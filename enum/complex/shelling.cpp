// Greedy shelling of a hexahedral complex, backwards: hexahedra are taken off one by one.
//
// A hexahedron may be taken off a ball if what it shares with the rest is a disc made of facets,
// so that its free facets form a patch. That is: shared and free facets are both discs, and
// every edge or vertex of the hexahedron that lies in the rest lies on a shared facet. The order
// matters a great deal: random orders get stuck, those with the fewest shared facets first seldom
// do (docs/theory/proofs/shelling.md says why an order found is a proof).

#include <algorithm>
#include <bit>
#include <queue>
#include <unordered_map>

#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/complex/hex_complex.hpp"

namespace hexatlas::complex {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Facet f = 2k + s lies on the corners whose bit k is s.
constexpr std::array<unsigned, cells::kCubeFacets> kCornersOfFacet{0x55, 0xAA, 0x33,
                                                                   0xCC, 0x0F, 0xF0};

/// Whether the facets (bit f is facet f) form a disc and the others do too: none or all, an
/// opposite pair alone and its complement do not.
bool is_patch(unsigned facets) noexcept {
  const int size = std::popcount(facets);
  const bool opposite_pair = (facets & (facets >> 1U) & 0b01'01'01U) != 0;
  if (size == 0 || size == 6) return false;
  if (size == 2) return !opposite_pair;
  const unsigned rest = ~facets & 0b11'11'11U;
  if (size == 4) return (rest & (rest >> 1U) & 0b01'01'01U) == 0;
  return true;
}

std::uint64_t mixed(std::uint64_t x) noexcept {
  x = (x ^ x >> 31U) * 0x9E3779B97F4A7C15ULL;
  x = (x ^ x >> 29U) * 0xBF58476D1CE4E5B9ULL;
  return x ^ x >> 32U;
}

class Peeler {
 public:
  explicit Peeler(const HexComplex& mesh)
      : mesh_(mesh), neighbour_(mesh.hexahedra.size()), cells_at_vertex_(mesh.vertices) {
    for (auto& row : neighbour_) row.fill(kNone);
    const std::vector<Facet> facets = sorted_facets(mesh);
    for (std::size_t i = 1; i < facets.size(); ++i)
      if (facets[i].key == facets[i - 1].key) {
        neighbour_[facets[i].cell][facets[i].facet] = facets[i - 1].cell;
        neighbour_[facets[i - 1].cell][facets[i - 1].facet] = facets[i].cell;
      }
    for (const Hexahedron& cell : mesh.hexahedra) {
      for (const VertexId v : cell) ++cells_at_vertex_[v];
      for_each_edge([&](unsigned a, unsigned b) { ++cells_at_edge_[edge(cell, a, b)]; });
    }
  }

  std::optional<std::vector<std::uint32_t>> peel(std::uint64_t seed) {
    const std::size_t cells = mesh_.hexahedra.size();
    removed_.assign(cells, false);
    auto vertices = cells_at_vertex_;
    auto edges = cells_at_edge_;
    using Entry = std::pair<std::uint64_t, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto push = [&](std::uint32_t c) {
      const auto rank = static_cast<std::uint64_t>(std::popcount(shared_facets(c)));
      queue.emplace(rank << 56U | mixed(seed ^ c) >> 8U, c);
    };
    for (std::uint32_t c = 0; c < cells; ++c) push(c);
    std::vector<std::uint32_t> order;
    while (!queue.empty() && order.size() + 1 < cells) {
      const auto [rank, c] = queue.top();
      queue.pop();
      if (removed_[c] || rank >> 56U != static_cast<unsigned>(std::popcount(shared_facets(c))) ||
          !is_removable(c, vertices, edges))
        continue;
      removed_[c] = true;
      order.push_back(c);
      const Hexahedron& cell = mesh_.hexahedra[c];
      for (const VertexId v : cell) --vertices[v];
      for_each_edge([&](unsigned a, unsigned b) { --edges[edge(cell, a, b)]; });
      touch_around(c, push);
    }
    if (order.size() + 1 != cells) return std::nullopt;
    order.push_back(static_cast<std::uint32_t>(std::find(removed_.begin(), removed_.end(), false) -
                                               removed_.begin()));
    return order;
  }

 private:
  using Counts = std::vector<std::uint32_t>;
  using EdgeCounts = std::unordered_map<std::uint64_t, std::uint32_t>;

  template <class Visit>
  static void for_each_edge(Visit&& visit) {
    for (unsigned a = 0; a < 8; ++a)
      for (unsigned axis = 1; axis < 8; axis <<= 1U)
        if ((a & axis) == 0) visit(a, a | axis);
  }
  static std::uint64_t edge(const Hexahedron& cell, unsigned a, unsigned b) noexcept {
    const auto [low, high] = std::minmax(cell[a], cell[b]);
    return std::uint64_t{high} << 32U | low;
  }
  [[nodiscard]] unsigned shared_facets(std::uint32_t c) const noexcept {
    unsigned shared = 0;
    for (unsigned f = 0; f < cells::kCubeFacets; ++f)
      if (neighbour_[c][f] != kNone && !removed_[neighbour_[c][f]]) shared |= 1U << f;
    return shared;
  }
  [[nodiscard]] bool is_removable(std::uint32_t c, const Counts& vertices,
                                  const EdgeCounts& edges) const {
    const unsigned shared = shared_facets(c);
    if (!is_patch(shared)) return false;
    const Hexahedron& cell = mesh_.hexahedra[c];
    unsigned on_shared = 0;  // corners
    for (unsigned f = 0; f < cells::kCubeFacets; ++f)
      if ((shared >> f & 1U) != 0) on_shared |= kCornersOfFacet[f];
    for (unsigned v = 0; v < 8; ++v)
      if ((on_shared >> v & 1U) == 0 && vertices[cell[v]] != 1) return false;
    bool fits = true;
    for_each_edge([&](unsigned a, unsigned b) {
      const unsigned ends = 1U << a | 1U << b;
      bool covered = false;
      for (unsigned f = 0; f < cells::kCubeFacets; ++f)
        covered = covered || ((shared >> f & 1U) != 0 && (kCornersOfFacet[f] & ends) == ends);
      fits = fits && (covered || edges.at(edge(cell, a, b)) == 1);
    });
    return fits;
  }
  /// What may have become removable shares a vertex with the removed hexahedron; such hexahedra are
  /// within three steps across facets, except at pinched places, where one is missed.
  template <class Push>
  void touch_around(std::uint32_t c, const Push& push) const {
    std::vector<std::uint32_t> near{c};
    for (std::size_t ring = 0, begin = 0; ring < 3; ++ring) {
      const std::size_t end = near.size();
      for (; begin < end; ++begin)
        for (const std::uint32_t n : neighbour_[near[begin]])
          if (n != kNone && !removed_[n] && std::find(near.begin(), near.end(), n) == near.end())
            near.push_back(n);
    }
    for (std::size_t i = 1; i < near.size(); ++i) push(near[i]);
  }

  const HexComplex& mesh_;
  std::vector<std::array<std::uint32_t, cells::kCubeFacets>> neighbour_;
  Counts cells_at_vertex_;
  EdgeCounts cells_at_edge_;
  std::vector<bool> removed_;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> shelling_of(const HexComplex& mesh, int tries) {
  if (mesh.hexahedra.empty()) return std::nullopt;
  Peeler peeler(mesh);
  for (int i = 0; i < tries; ++i)
    if (auto order = peeler.peel(static_cast<std::uint64_t>(i))) return order;
  return std::nullopt;
}

}  // namespace hexatlas::complex
