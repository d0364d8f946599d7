#include "enum/hexes/hexmeshes.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"

namespace hexatlas::hexes {
namespace {

using Walk = std::vector<std::uint16_t>;

/// The hexahedra of a mesh by their facets, and the walks through it.
class Walker {
 public:
  Walker(const std::vector<Cell>& cells, const complex::Quadrangulation& boundary, int first)
      : cells_(cells), boundary_(boundary), first_(first) {
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (const TurnedFacet& turned : kTurnedFacets) at_[key(cells[c], turned.facet)].push_back(c);
  }

  /// The walk through the image of the mesh under a map of the boundary. It determines the image.
  Walk walk(const BoundarySymmetry::Map& map) {
    const auto vertices = static_cast<std::size_t>(boundary_.vertices());
    std::array<Vertex, complex::kMaxVertices> back{};
    for (std::size_t v = 0; v < vertices; ++v) back[map[v]] = static_cast<Vertex>(v);
    image_.fill(BoundarySymmetry::kInterior);
    std::copy_n(map.begin(), vertices, image_.begin());
    next_ = static_cast<Vertex>(vertices);
    visited_.assign(cells_.size(), false);
    walk_.clear();
    for (int k = 0; k < boundary_.quads(); ++k) {
      Facet quad = boundary_.vertices_of(k == 0 ? first_ : k <= first_ ? k - 1 : k);
      for (Vertex& v : quad) v = back[v];
      visit(quad);
    }
    for (; !facets_.empty(); facets_.pop_front()) visit(facets_.front());
    return walk_;
  }

 private:
  using Key = std::array<Vertex, 4>;
  static Key key(const Cell& cell, const std::array<std::uint8_t, 4>& places) {
    Key result{};
    for (std::size_t i = 0; i < 4; ++i) result[i] = cell[places[i]];
    std::sort(result.begin(), result.end());
    return result;
  }

  void visit(const Facet& facet) {
    Key sorted = facet;
    std::sort(sorted.begin(), sorted.end());
    for (const std::size_t c : at_.at(sorted)) {
      if (visited_[c]) continue;
      visited_[c] = true;
      take(c, facet);
    }
  }

  /// The first four letters are the type of boundary_symmetry.hpp, so the least walk is that of an
  /// image that the search keeps.
  void take(std::size_t c, const Facet& facet) {
    const Facet tops = tops_over(cells_[c], facet);
    if (walk_.empty())
      for (const Vertex top : tops) walk_.push_back(image_[top]);
    for (const Vertex top : tops) {
      if (image_[top] == BoundarySymmetry::kInterior) image_[top] = next_++;
      walk_.push_back(image_[top]);
    }
    facets_.push_back(tops);
    for (std::size_t i = 0; i < 4; ++i)
      facets_.push_back({facet[i], facet[(i + 1) % 4], tops[(i + 1) % 4], tops[i]});
  }

  const std::vector<Cell>& cells_;
  const complex::Quadrangulation& boundary_;
  int first_;
  std::map<Key, std::vector<std::size_t>> at_;
  std::array<Vertex, 256> image_{};
  Vertex next_ = 0;
  std::vector<bool> visited_;
  Walk walk_;
  std::deque<Facet> facets_;
};

/// Every ball has two colours; they go from vertex to vertex.
bool has_two_colours(const complex::HexComplex& mesh) {
  std::vector<int> colour(mesh.vertices, -1);
  colour[mesh.hexahedra.front().front()] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const complex::Hexahedron& cell : mesh.hexahedra)
      for (std::size_t v = 0; v < 8; ++v)
        for (const std::size_t axis : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
          const int from = colour[cell[v]];
          int& to = colour[cell[v ^ axis]];
          if (from < 0) continue;
          if (to == from) return false;
          changed = changed || to < 0;
          to = 1 - from;
        }
  }
  return true;
}

}  // namespace

Topology topology_of(const complex::HexComplex& mesh) {
  if (complex::validate(mesh) || !has_two_colours(mesh)) return Topology::no_ball;
  return complex::shelling_of(mesh) ? Topology::ball : Topology::undecided;
}

HexmeshProblem::HexmeshProblem(const complex::Quadrangulation& boundary, const SearchLimits& limits)
    : boundary_(boundary),
      limits_{limits.max_hexahedra, limits.max_interior, limits.ball, true},
      start_(boundary, limits_),
      symmetry_(boundary, std::max(0, start_.first_quad())) {}

int HexmeshProblem::symmetries() const noexcept {
  return static_cast<int>(symmetry_.maps().size());
}

std::optional<Hexmesh> HexmeshProblem::collect(const HexSearch& found) const {
  Walker walker(found.mesh().cells(), boundary_, symmetry_.first());
  BoundarySymmetry::Map identity{};
  for (std::size_t v = 0; v < identity.size(); ++v) identity[v] = static_cast<Vertex>(v);
  const Walk own = walker.walk(identity);
  Hexmesh result;
  result.automorphisms = 0;
  for (const BoundarySymmetry::Map& map : symmetry_.maps()) {
    const Walk other = walker.walk(map);
    if (other < own) return std::nullopt;
    if (other == own) ++result.automorphisms;
  }
  result.mesh = complex_of(found.mesh());
  result.topology = topology_of(result.mesh);
  if (limits_.ball && result.topology == Topology::no_ball) return std::nullopt;
  return result;
}

HexFrontier HexmeshProblem::begin(std::size_t index, std::size_t parts) const {
  return search::shard<Hexmesh>(
      index, parts, [&] { return start_; }, [&](const HexSearch& found) { return collect(found); });
}

void HexmeshProblem::go_on(HexFrontier& frontier, const search::PoolOptions& options,
                           const std::function<bool()>& after_round) const {
  search::explore_pending(
      frontier, options, [&] { return start_; },
      [&](const HexSearch& found) { return collect(found); }, after_round);
}

search::Estimate HexmeshProblem::estimate(std::uint64_t probes, std::uint64_t seed,
                                          int threads) const {
  return search::estimate_nodes([&] { return start_; }, probes, seed, threads);
}

}  // namespace hexatlas::hexes
