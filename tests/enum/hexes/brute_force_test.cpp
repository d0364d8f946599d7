// Claim. The search finds each hexahedral mesh of at most 6 hexahedra of each boundary with at most
// 10 quads, once. Oracle. A search that knows of pairs of vertices only, puts any hexahedron on the
// first open quad, and judges what it has by sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/enum/hexes/found_meshes.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;
using hexes::SearchLimits;
using oracle::Cell;
using oracle::Face;
using support::Mesh;
using support::named;
using support::quads_of;

/// All meshes with a boundary: any hexahedron on the first open quad of which no pair of vertices
/// is of another kind before; what is found is then looked at by sets.
class BruteForce {
 public:
  BruteForce(const Quadrangulation& boundary, std::size_t max_hexahedra, std::uint32_t max_interior)
      : boundary_vertices_(static_cast<std::uint32_t>(boundary.vertices())),
        max_vertices_(boundary_vertices_ + max_interior),
        max_hexahedra_(max_hexahedra) {
    for (const auto& quad : boundary.list_of_quads()) {
      Cycle cycle{};
      std::copy(quad.begin(), quad.end(), cycle.begin());
      open_[Face(cycle.begin(), cycle.end())] = cycle;
      for (std::size_t i = 0; i < 4; ++i) {
        kind_[pair(cycle[i], cycle[(i + 1) % 4])] = 1;
        kind_[pair(cycle[i], cycle[(i + 2) % 4])] = 2;
      }
    }
    for (const auto& [quad, cycle] : open_) boundary_.insert(quad);
    search(boundary_vertices_);
  }
  [[nodiscard]] const std::set<Mesh>& meshes() const { return meshes_; }
  [[nodiscard]] std::size_t met() const { return met_; }

 private:
  using Cycle = std::array<std::uint32_t, 4>;
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  static Pair pair(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

  void search(std::uint32_t vertices) {
    if (open_.empty()) {
      if (!obeys_the_rules()) return;
      ++met_;
      meshes_.insert(named(cells_, boundary_vertices_));
    } else if (open_.size() <= 6 * (max_hexahedra_ - cells_.size())) {
      const Cycle bottom = open_.begin()->second;
      choose({bottom[0], bottom[1], bottom[3], bottom[2]}, 4, vertices);
    }
  }

  [[nodiscard]] bool obeys_the_rules() const {
    std::map<Face, int> uses;
    for (const Cell& cell : cells_)
      for (const auto& quad : quads_of(cell)) ++uses[Face(quad.begin(), quad.end())];
    for (const auto& [quad, count] : uses)
      if (count != (boundary_.contains(quad) ? 1 : 2)) return false;
    return oracle::obeys_strict_rule(cells_);
  }

  /// The corners of a cube from `corner` on; those before are chosen.
  void choose(Cell cell, unsigned corner, std::uint32_t vertices) {
    if (corner == 8) return put(cell, vertices);
    for (std::uint32_t v = 0; v <= vertices && v < max_vertices_; ++v) {
      bool fits = true;
      for (unsigned other = 0; other < corner && fits; ++other) {
        const auto known = kind_.find(pair(cell[other], v));
        const int kind = std::popcount(other ^ corner);
        fits = cell[other] != v && (known == kind_.end() || (known->second == kind && kind < 3));
      }
      if (!fits) continue;
      cell[corner] = v;
      choose(cell, corner + 1, std::max(vertices, v + 1));
    }
  }

  void put(const Cell& cell, std::uint32_t vertices) {
    const auto open = open_;
    const auto kind = kind_;
    for (const auto& cycle : oracle::outer_quads(cell)) {
      const Face quad(cycle.begin(), cycle.end());
      if (open_.erase(quad) == 0) open_[quad] = cycle;
    }
    for (unsigned a = 0; a < 8; ++a)
      for (unsigned b = 0; b < a; ++b) kind_[pair(cell[a], cell[b])] = std::popcount(a ^ b);
    cells_.push_back(cell);
    search(vertices);
    cells_.pop_back();
    open_ = open;
    kind_ = kind;
  }

  std::uint32_t boundary_vertices_, max_vertices_;
  std::size_t max_hexahedra_, met_ = 0;
  std::vector<Cell> cells_;
  std::map<Face, Cycle> open_;
  std::set<Face> boundary_;
  std::map<Pair, int> kind_;
  std::set<Mesh> meshes_;
};

TEST(HexSearch, FindsWhatTryingEverythingFinds) {
  for (const Quadrangulation& boundary : support::three_connected(10)) {
    const int hexahedra = 6;
    const SearchLimits limits = support::limits_for(boundary, hexahedra);
    const BruteForce brute(boundary, static_cast<std::size_t>(hexahedra),
                           static_cast<std::uint32_t>(limits.max_interior));
    const support::FoundMeshes found = support::search_all(boundary, limits);
    EXPECT_EQ(found.meshes, brute.meshes()) << boundary.quads();
    EXPECT_EQ(found.counts.solutions, brute.met()) << boundary.quads();
  }
}

}  // namespace
