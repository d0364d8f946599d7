#include "tables/build/bounds.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "enum/core/errors.hpp"
#include "enum/core/words.hpp"
#include "enum/hexes/hexmeshes.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/fill/filled.hpp"

namespace hexatlas::build {
namespace {

/// The search for balls with at most so many hexahedra, as far as it came: to its end, to the first
/// mesh that may be a ball, until it was stopped or its nodes were spent. nullopt: it is too large.
std::optional<hexes::HexFrontier> searched(const complex::Quadrangulation& boundary, int hexahedra,
                                           std::uint64_t nodes, const std::atomic<bool>* stop) {
  const int interior = hexes::most_interior_vertices(boundary.quads(), hexahedra);
  if (boundary.vertices() + interior > hexes::kMaxMeshVertices) return std::nullopt;
  const hexes::HexmeshProblem problem(
      boundary, {.max_hexahedra = hexahedra, .max_interior = interior, .ball = true});
  hexes::HexFrontier frontier = problem.begin();
  problem.go_on(frontier, {.threads = 1, .max_nodes = nodes, .stop = stop},
                [&] { return frontier.found.empty(); });
  return frontier;
}

bool is_ball(const hexes::Hexmesh& found) { return found.topology == hexes::Topology::ball; }

}  // namespace

void expect_not_refuted(const std::string& source, const canon::Code& code, int bound,
                        std::size_t hexahedra) {
  if (static_cast<std::size_t>(bound) > hexahedra)
    throw core::InvalidInput(
        source, "claims that " + canon::to_text(code) + " has no mesh with fewer than " +
                    core::counted(static_cast<std::size_t>(bound), "hexahedron", "hexahedra") +
                    "; one has " + std::to_string(hexahedra));
}

BoundOutcome raise_bound(format::TableRow& row, const BoundOptions& options) {
  const auto boundary = canon::decode(row.code);
  if (!boundary || !boundary->is_three_connected())
    throw core::InvalidInput("boundary " + canon::to_text(row.code),
                             "is not 3-connected; a table has no others");
  const int most = std::min(options.max_hexahedra, hexes::kMaxHexahedra);
  using Change = BoundOutcome::Change;
  BoundOutcome outcome;
  std::uint64_t nodes = options.max_nodes;
  while (row.lower_bound <= most && row.lower_bound < row.mesh.hexahedra.size()) {
    auto frontier = searched(*boundary, row.lower_bound, nodes, options.stop);
    if (!frontier) {
      outcome.is_cut = true;
      break;
    }
    if (const auto ball = std::find_if(frontier->found.begin(), frontier->found.end(), is_ball);
        ball != frontier->found.end()) {
      expect_not_refuted("the table", row.code, row.lower_bound, ball->mesh.hexahedra.size());
      row.mesh = std::move(ball->mesh);
      outcome.change = Change::replaced;
      return outcome;
    }
    outcome.is_cut = !frontier->found.empty() || !frontier->is_finished();
    if (outcome.is_cut) break;
    nodes -= std::min(nodes, frontier->counts.nodes);
    ++row.lower_bound;
    outcome.change = Change::raised;
  }
  return outcome;
}

std::vector<BoundOutcome> raise_bounds(std::span<format::TableRow* const> rows,
                                       const BoundOptions& options) {
  std::vector<BoundOutcome> outcomes(rows.size());
  parallel::parallel_for(options.threads, rows.size(),
                         [&](std::size_t i) { outcomes[i] = raise_bound(*rows[i], options); });
  return outcomes;
}

std::vector<format::TableRow> rows_of(const format::Table& table) {
  std::vector<format::TableRow> rows;
  rows.reserve(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const format::TableEntry entry = table.entry(i);
    rows.push_back({entry.code, fill::mesh_in(table, i, table.path()), entry.lower_bound});
    expect_not_refuted(table.path(), entry.code, entry.lower_bound, entry.hexahedra);
  }
  return rows;
}

}  // namespace hexatlas::build
