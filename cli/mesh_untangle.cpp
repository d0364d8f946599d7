#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/mesh_report.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hexahedrize/placing.hpp"
#include "meshing/hexahedrize/sides.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/quality/report.hpp"

namespace hexatlas::cli {
namespace {

/// Whatever places the points of other cells, some would overlap.
void expect_placeable(const mesh::HexMesh& mesh, const std::string& file) {
  for (std::size_t c = 0; c < mesh.hexahedra.size(); ++c) {
    auto cell = mesh.hexahedra[c];
    std::sort(cell.begin(), cell.end());
    if (std::adjacent_find(cell.begin(), cell.end()) != cell.end())
      throw core::InvalidInput(file, fmt::format("hexahedron {} has a vertex twice", c));
  }
  if (const auto fault = hexahedrize::fault_of_sides(mesh)) throw core::InvalidInput(file, *fault);
}

nlohmann::ordered_json json_of(const quality::Report& report) {
  nlohmann::ordered_json json;
  add_quality(json, report);
  return json;
}

/// Vertices that may move, and those inside that may not, since they are on interfaces.
struct Vertices {
  std::size_t free = 0, kept = 0;
};

MeshReport report_of(const MeshUntangleOptions& options, const Vertices& vertices,
                     const quality::Report& before, const quality::Report& after, double elapsed) {
  Account given{"What was given", {}};
  given.add("mesh", shown_name(options.input, "standard input"));
  given.add("hexahedra", before.cells);
  Account done{"What was done", {}};
  done.add("method", options.harmonic ? "better places, from harmonic ones"
                                      : "better places, from those given");
  done.add("boundary", options.free_boundary ? "moved as the interior is" : "kept, bit for bit");
  done.add("free vertices", vertices.free);
  if (vertices.kept > 0) done.add("vertices on interfaces, kept", vertices.kept);
  done.add("mesh written", shown_name(options.output, "standard output"));
  done.add("judge", "not asked: which hexahedra share what is as it was");
  done.add_seconds(elapsed);
  return {shown_name(options.input, "standard input"),
          {given, done},
          {{"Quality before", before}, {"Quality after", after}}};
}

/// Points of interfaces stay as those of the boundary do; how many of them are inside.
std::size_t keep_interfaces(const mesh::HexModel& model, std::vector<std::uint8_t>& is_free) {
  const std::vector<std::uint8_t> is_on = hexahedrize::points_of_interfaces(model);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < is_free.size(); ++v) {
    kept += is_free[v] != 0 && is_on[v] != 0 ? 1 : 0;
    if (is_on[v] != 0) is_free[v] = 0;
  }
  return kept;
}

bool is_worse(const quality::Report& report, const quality::Report& than) {
  if (report.valid != than.valid) return report.valid < than.valid;
  if (report.inverted != than.inverted) return report.inverted > than.inverted;
  return report.min_scaled_jacobian < than.min_scaled_jacobian;
}

/// Places the free vertices; those given stay, bit for bit, if nothing is tried or all would
/// be worse.
quality::Report place(mesh::HexMesh& mesh, std::vector<std::uint8_t> is_free,
                      const MeshUntangleOptions& options, const quality::Report& before) {
  if (!options.harmonic && options.effort == 0) return before;
  std::vector<mesh::Point> given = mesh.points;
  hexahedrize::place(mesh, std::move(is_free),
                     {.effort = options.effort,
                      .threads = parallel::threads_or_all(options.threads),
                      .starts_as_given = !options.harmonic});
  quality::Report report = quality::report(mesh);
  if (options.harmonic || !is_worse(report, before)) return report;
  mesh.points = std::move(given);
  say("note: no better places were found; those given stay");
  return before;
}

}  // namespace

ExitCode mesh_untangle(const MeshUntangleOptions& options) {
  const double start = seconds();
  const MeshFiles files{options.input, options.output, options.report};
  if (!are_distinct(files, "MESH", "mesh untangle")) return ExitCode::usage;
  expect_outputs_writable(files);
  mesh::HexModel model = io::read_hex_model(options.input);
  mesh::HexMesh& mesh = model.mesh;
  const std::string name = input_name(options.input);
  expect_placeable(mesh, name);
  turn_over_what_is_inside_out(mesh, name);
  std::vector<std::uint8_t> is_free = options.free_boundary ? hexahedrize::points_of_cells(mesh)
                                                            : hexahedrize::interior_points(mesh);
  Vertices vertices;
  if (!options.free_boundary) vertices.kept = keep_interfaces(model, is_free);
  vertices.free =
      static_cast<std::size_t>(std::count(is_free.begin(), is_free.end(), std::uint8_t{1}));
  const quality::Report before = quality::report(mesh);
  const quality::Report report = place(mesh, std::move(is_free), options, before);
  const double elapsed = seconds() - start;
  write_with_report(files, mesh,
                    [&] { return report_of(options, vertices, before, report, elapsed); });
  if (options.json) {
    nlohmann::ordered_json json;
    json["hexahedra"] = report.cells;
    json["free_vertices"] = vertices.free;
    json["interface_vertices"] = vertices.kept;
    json["before"] = json_of(before);
    json["after"] = json_of(report);
    json["seconds"] = elapsed;
    tell(files, to_line(json));
  } else {
    tell(files, fmt::format(
                    "{}: {}, {}{}\nbefore\n{}after\n{}", options.output,
                    counted(report.cells, "hexahedron", "hexahedra"),
                    counted(vertices.free, "free vertex", "free vertices"),
                    vertices.kept == 0 ? "" : fmt::format(", {} on interfaces kept", vertices.kept),
                    quality_text(before), quality_text(report)));
  }
  return answer_for(report, options.require_valid);
}

}  // namespace hexatlas::cli
