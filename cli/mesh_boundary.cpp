#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/boundary_input.hpp"
#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/mesh_report.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/canon/code.hpp"
#include "enum/core/errors.hpp"
#include "enum/flips/scars.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hexahedrize/placing.hpp"
#include "meshing/quality/report.hpp"
#include "tables/check/mesh_check.hpp"
#include "tables/fill/filled.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::cli {
namespace {

std::string json_line(const NamedBoundary& boundary, const mesh::HexMesh& mesh, bool free_boundary,
                      const quality::Report& report, double elapsed) {
  nlohmann::ordered_json json;
  json["outcome"] = "meshed";
  json["code"] = boundary.code;
  json["quads"] = boundary.boundary.quads();
  json["hexahedra"] = report.cells;
  json["interior_vertices"] =
      mesh.points.size() - static_cast<std::size_t>(boundary.boundary.vertices());
  json["free_boundary"] = free_boundary;
  add_quality(json, report);
  json["seconds"] = elapsed;
  return to_line(json);
}

std::string summary(const NamedBoundary& boundary, const mesh::HexMesh& mesh,
                    const quality::Report& report, const std::string& output) {
  const auto on_boundary = static_cast<std::size_t>(boundary.boundary.vertices());
  return fmt::format(
      "{}: {}, {}, boundary of {} quads\ntable entry {}\n{}", output,
      counted(report.cells, "hexahedron", "hexahedra"),
      counted(mesh.points.size() - on_boundary, "interior vertex", "interior vertices"),
      boundary.boundary.quads(), boundary.code, quality_text(report));
}

MeshReport report_of(const MeshBoundaryOptions& options, const NamedBoundary& boundary,
                     const check::Verdict& verdict, const quality::Report& report, double elapsed) {
  Account given{"What was given", {}};
  given.add("boundary", shown_name(options.boundary, "standard input"));
  given.add("quads", static_cast<std::size_t>(boundary.boundary.quads()));
  given.add("points", "none are used");
  Account done{"What was done", {}};
  done.add("method", "look-up in the table");
  done.add("table entry", boundary.code);
  done.add("boundary", options.free_boundary ? "moved as the interior is"
                                             : "a convex polyhedron whose edges touch a sphere");
  done.add("hexahedra", report.cells);
  done.add("interior vertices", verdict.interior_vertices);
  done.add("mesh written", shown_name(options.output, "standard output"));
  done.add_seconds(elapsed);
  return {shown_name(options.boundary, "standard input"),
          {given, done, judgement(verdict)},
          {{"Quality", report}}};
}

}  // namespace

ExitCode mesh_boundary(const MeshBoundaryOptions& options) {
  const double start = seconds();
  const MeshFiles files{.input = options.boundary,
                        .output = options.output,
                        .report = options.report,
                        .table = options.table};
  if (!are_distinct(files, "BOUNDARY", "mesh boundary")) return ExitCode::usage;
  expect_outputs_writable(files);
  const auto known = boundary_from(options.boundary);
  if (const auto* none = std::get_if<Unfillable>(&known)) {
    tell(files, options.boundary, {"impossible", none->quads, none->reason, ""}, options.json);
    return ExitCode::no;
  }
  const auto& boundary = std::get<NamedBoundary>(known);
  const format::Table table =
      table_for(options.table, static_cast<std::size_t>(boundary.boundary.quads()));
  const auto ordinal = table.find(canon::from_text(boundary.code).value());
  if (!ordinal) {
    const auto quads = static_cast<std::size_t>(boundary.boundary.quads());
    std::string reason = fmt::format("the boundary of {} quads is not in {}", quads, table.path());
    if (quads <= flips::kMaxSearchQuads && options.table.empty())
      reason +=
          fmt::format("; `hexatlas table get --code {} --search` looks for a mesh", boundary.code);
    tell(files, boundary.code, {"not_in_table", quads, reason, boundary.code}, options.json);
    return ExitCode::undecided;
  }
  using hexahedrize::Boundary;
  const mesh::HexMesh mesh = hexahedrize::placed(
      fill::mesh_in(table, *ordinal, table.path()), boundary.boundary,
      options.free_boundary ? Boundary::free : Boundary::convex,
      {.effort = options.effort, .threads = parallel::threads_or_all(options.threads)});
  const check::Verdict verdict = check::check_mesh(for_judge(mesh), nullptr);
  if (!verdict.accepted)
    throw core::InvalidInput(table.path(), "holds a mesh that is not valid: " + verdict.reason);
  const quality::Report report = quality::report(mesh);
  const double elapsed = seconds() - start;
  write_with_report(files, mesh,
                    [&] { return report_of(options, boundary, verdict, report, elapsed); });
  tell(files, options.json ? json_line(boundary, mesh, options.free_boundary, report, elapsed)
                           : summary(boundary, mesh, report, options.output));
  return answer_for(report, options.require_valid);
}

}  // namespace hexatlas::cli
