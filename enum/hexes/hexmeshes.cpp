#include "enum/hexes/hexmeshes.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/core/rank.hpp"

namespace hexatlas::hexes {
namespace {

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

/// The first Betti number modulo 2 of a connected complex, which is 0 for balls: edges less the
/// ranks of the boundaries of edges, vertices - 1, and of quads.
std::size_t first_betti_number(const complex::HexComplex& mesh) {
  std::map<std::array<complex::VertexId, 2>, std::size_t> edges;
  std::vector<std::vector<std::size_t>> quads;  // those in two hexahedra twice
  for (const complex::Hexahedron& cell : mesh.hexahedra)
    for (const auto& facet : cells::kFacetVertices) {
      std::vector<std::size_t>& quad = quads.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) {
        const auto [from, to] = std::minmax(cell[facet[i]], cell[facet[(i + 1) % 4]]);
        quad.push_back(edges.try_emplace({from, to}, edges.size()).first->second);
      }
      std::sort(quad.begin(), quad.end());
    }
  return edges.size() + 1 - mesh.vertices - core::rank_modulo_2(std::move(quads));
}

}  // namespace

Topology topology_of(const complex::HexComplex& mesh) {
  if (complex::validate(mesh) || !has_two_colours(mesh)) return Topology::no_ball;
  if (complex::shelling_of(mesh)) return Topology::ball;
  return first_betti_number(mesh) > 0 ? Topology::no_ball : Topology::undecided;
}

HexmeshProblem::HexmeshProblem(const complex::Quadrangulation& boundary, const SearchLimits& limits)
    : boundary_(boundary),
      limits_{limits.max_hexahedra, limits.max_interior, limits.ball, true},
      start_(boundary, limits_),
      symmetries_(static_cast<int>(automorphisms_of(boundary).size())) {}

std::optional<Hexmesh> HexmeshProblem::collect(const HexSearch& found) const {
  Hexmesh result;
  result.automorphisms = found.automorphisms();
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
