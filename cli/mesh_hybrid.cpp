#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <variant>

#include "cli/commands.hpp"
#include "cli/hybrid_text.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/classes.hpp"
#include "meshing/hybrid/conforming.hpp"
#include "meshing/hybrid/lattice.hpp"
#include "meshing/hybrid/selection.hpp"
#include "meshing/hybrid/tet_graph.hpp"
#include "meshing/io/mesh_files.hpp"
#include "tables/format/catalogue.hpp"

namespace hexatlas::cli {
namespace {

hybrid::TetGraph graph_of(const mesh::TetModel& model, const std::string& name) {
  auto graph = hybrid::TetGraph::of({model.mesh.points, model.mesh.tetrahedra},
                                    {model.regions, model.triangles, model.colours});
  if (const auto* fault = std::get_if<complex::BrokenLaw>(&graph))
    throw core::InvalidInput(name, fault->reason);
  return std::move(std::get<hybrid::TetGraph>(graph));
}

/// Whether there are coloured triangles inside, which a mesh that is written does not name.
bool has_surfaces_inside(const hybrid::TetGraph& graph) {
  for (hybrid::TetIndex t = 0; t < graph.size(); ++t)
    for (unsigned facet = 0; facet < 4; ++facet)
      if (graph.colour(t, facet) != 0 && graph.across(t, facet) != hybrid::TetGraph::kOutside)
        return true;
  return false;
}

/// How many vertices of tetrahedra no cell has: tetrahedra around them make up one cell.
std::size_t vertices_of_no_cell(const hybrid::TetGraph& graph, const mesh::HybridMesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.points.size(), 0);
  const auto use = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const mesh::Index v : cell) is_used[v] = 1;
  };
  use(mesh.tetrahedra);
  use(mesh.hexahedra);
  use(mesh.prisms);
  use(mesh.pyramids);
  std::size_t count = 0;
  for (mesh::Index v = 0; v < graph.points().size(); ++v)
    if (!graph.star(v).empty() && is_used[v] == 0) ++count;
  return count;
}

/// Whether the file tells parts of its surface apart, which a filling does not.
bool has_parts(const mesh::FacetMesh& surface) {
  return std::any_of(surface.facets.begin(), surface.facets.end(), [&](const mesh::Facet& facet) {
    return facet.colour != surface.facets.front().colour;
  });
}

/// The tetrahedra of the file, or those inside its surface.
mesh::TetModel model_of(const MeshHybridOptions& options, HybridAccount& account) {
  if (options.fill.empty()) return io::read_tet_model(options.input);
  const mesh::FacetMesh surface = io::read_facets(options.input);
  if (has_parts(surface))
    say("note: --fill keeps the surface, but not the parts (references or entities) that " +
        input_name(options.input) + " tells of it: quads may reach across their borders");
  hybrid::LatticeOptions lattice;
  lattice.spacing = options.spacing;
  lattice.keeps_diagonals = options.keep_diagonals;
  lattice.threads = account.threads;
  auto filled = hybrid::fill_with_lattice(surface, lattice);
  if (const auto* fault = std::get_if<complex::BrokenLaw>(&filled))
    throw core::InvalidInput(input_name(options.input), fault->reason);
  auto& inside = std::get<hybrid::Filled>(filled);
  account.lattice = {inside.lattice_points, inside.added_on_surface, inside.exchanged_diagonals,
                     inside.spacing};
  return std::move(inside.model);
}

/// Of one phase; the line outlives it.
hybrid::Progress shown_on(ProgressLine& line, const std::string& phase) {
  return [&line, phase](std::size_t done, std::size_t all) { line.update(phase, done, all); };
}

hybrid::Candidates candidates_of(const hybrid::TetGraph& graph, double quality, int threads) {
  ProgressLine line;
  return hybrid::candidates(graph, quality, threads, shown_on(line, "vertices searched"));
}

/// How many candidates there are of each class of subdivisions, from 1 on as listed by
/// `hexatlas enum triangulations hexahedron`.
std::vector<std::size_t> class_counts(const hybrid::TetGraph& graph,
                                      const hybrid::Candidates& candidates) {
  const std::string path = catalogue_path("hexahedron.hxc");
  const format::Catalogue catalogue = format::catalogue_from(core::read_file(path), path);
  std::vector<complex::Triangulation> classes;
  for (const format::CatalogueClass& c : catalogue.classes) classes.push_back(c.triangulation);
  return hybrid::HexahedronClasses(classes).counts(graph, candidates.hexahedra);
}

void make_mesh(const MeshHybridOptions& options, const hybrid::TetGraph& graph,
               const hybrid::Candidates& candidates, HybridAccount& account) {
  ProgressLine line;
  hybrid::SelectionOptions selection;
  selection.rounds = options.rounds;
  selection.progress = shown_on(line, "candidates tried, of at most");
  const std::vector<hybrid::Cell> cells = hybrid::selection(graph, candidates, selection);
  account.combined = options.conforming ? hybrid::conforming_mesh(graph, candidates, cells,
                                                                  shown_on(line, "cells closed"))
                                        : hybrid::plain_mesh(graph, candidates, cells);
  account.report = quality::report(account.combined->mesh);
  account.points_inside_cells = vertices_of_no_cell(graph, account.combined->mesh);
}

}  // namespace

ExitCode mesh_hybrid(const MeshHybridOptions& options) {
  const bool is_counted = options.count;
  if (is_counted == !options.output.empty()) {
    say("either --output or --count is needed. See `hexatlas mesh hybrid --help`.");
    return ExitCode::usage;
  }
  if (!are_distinct({options.input, options.output, options.candidates, "--candidates"}, "TETMESH",
                    "mesh hybrid"))
    return ExitCode::usage;
  if (!is_counted) expect_hybrid_writable(options.output);
  if (!options.candidates.empty()) core::expect_writable(options.candidates);
  HybridAccount account;
  account.quality = options.quality;
  account.threads = parallel::threads_or_all(options.threads);
  const mesh::TetModel model = model_of(options, account);
  const hybrid::TetGraph graph = graph_of(model, input_name(options.input));
  account.tetrahedra = graph.size();
  if (graph.is_turned_over())
    say("note: the tetrahedra of " + input_name(options.input) +
        " are inside out, all of them; they were turned over");
  if (const std::size_t ignored = graph.ignored_triangles(); ignored != 0)
    say(fmt::format("note: {} of {} {} no facet of a tetrahedron: ignored",
                    counted(ignored, "coloured triangle", "coloured triangles"),
                    input_name(options.input), ignored == 1 ? "is" : "are"));
  const double start = seconds();
  const hybrid::Candidates candidates = candidates_of(graph, options.quality, account.threads);
  account.search_seconds = seconds() - start;
  account.candidates = {candidates.hexahedra.cells.size(), candidates.prisms.cells.size(),
                        candidates.pyramids.cells.size()};
  account.undecided = candidates.undecided;
  account.classes = class_counts(graph, candidates);
  if (!options.candidates.empty())
    core::write_file(options.candidates, candidates_text(candidates, options.quality));
  if (!is_counted) make_mesh(options, graph, candidates, account);
  account.seconds = seconds() - start;
  if (!is_counted) write_hybrid(options.output, account.combined->mesh);
  if (!is_counted && has_surfaces_inside(graph))
    say("note: the coloured triangles inside " + input_name(options.input) +
        " are facets of cells, or halves of them; the output does not name their colours");
  const std::string& stream = options.candidates == "-" ? options.candidates : options.output;
  tell(stream, options.json ? json_line(account) : summary(account, options.output));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
