#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/quality/report.hpp"
#include "meshing/quality/self_meeting.hpp"
#include "tables/check/mesh_check.hpp"

namespace hexatlas::cli {
namespace {

void say_notes(const hexahedrize::SurfaceNotes& notes) {
  if (notes.unused_points > 0)
    say(fmt::format("note: {} in no quad, kept as points of the mesh",
                    counted(notes.unused_points, "point is", "points are")));
  if (notes.reversed_quads > 0)
    say(fmt::format("note: {} disagreed with the others in orientation, turned over",
                    counted(notes.reversed_quads, "quad", "quads")));
  if (notes.turned_outwards) say("note: the quads faced inwards; all were turned over");
}

const char* name_of(hexahedrize::Method method) {
  return method == hexahedrize::Method::table ? "table" : "construction";
}

double per_quad(const quality::Report& report, std::size_t quads) {
  return static_cast<double>(report.hexahedra) / static_cast<double>(quads);
}

std::string json_line(std::size_t quads, const hexahedrize::Hexahedrized& made,
                      const quality::Report& report,
                      const std::optional<quality::SelfMeeting>& meeting, double elapsed) {
  nlohmann::ordered_json json;
  json["outcome"] = "meshed";
  json["quads"] = quads;
  json["hexahedra"] = report.hexahedra;
  json["interior_vertices"] = made.interior_vertices;
  add_quality(json, report);
  json["method"] = name_of(made.method);
  json["hexahedra_per_quad"] = per_quad(report, quads);
  json["table_entry"] = nullptr;
  if (!made.code.empty()) json["table_entry"] = made.code;
  add_self_meeting(json, meeting);
  json["seconds"] = elapsed;
  return to_line(json);
}

std::string summary(std::size_t quads, const hexahedrize::Hexahedrized& made,
                    const quality::Report& report, const std::string& output) {
  return fmt::format(
      "{}: {}, {}, boundary of {} quads\n"
      "{}{}; {:.2f} hexahedra per quad\n"
      "{}",
      output, counted(report.hexahedra, "hexahedron", "hexahedra"),
      counted(made.interior_vertices, "interior vertex", "interior vertices"), quads,
      made.code.empty() ? "by the linear construction" : "table entry ", made.code,
      per_quad(report, quads), quality_text(report));
}

/// Whatever the table or a theorem says, a mesh is written only if the judge accepts it. That it is
/// a ball the theorem may know better: the judge looks for a proof only so long.
void expect_accepted(const hexahedrize::Hexahedrized& made, const mesh::SurfaceMesh& surface,
                     const std::optional<format::Table>& table) {
  const check::Surface boundary = for_judge(surface);
  const check::Verdict verdict = check::check_mesh(for_judge(made.mesh), &boundary);
  if (verdict.accepted) return;
  const std::string fault = "a mesh that is not valid: " + verdict.reason;
  if (made.method == hexahedrize::Method::table)
    throw core::InvalidInput(table.value().path(), "holds " + fault);
  if (!verdict.undecided) throw core::InternalError("the construction made " + fault);
  say("note: " + verdict.reason);
}

/// Why there is no mesh: a sentence, and with --json an object that holds it. An empty code is one
/// that was not computed.
void tell_without_mesh(const MeshHexOptions& options, const std::string& name,
                       const std::string& outcome, std::size_t quads, const std::string& reason,
                       const std::string& code) {
  say(fmt::format("{}: {}", name, reason));
  if (!options.json) return;
  nlohmann::ordered_json json;
  json["outcome"] = outcome;
  json["quads"] = quads;
  json["reason"] = reason;
  json["code"] = nullptr;
  if (!code.empty()) json["code"] = code;
  tell(options.output, to_line(json));
}

ExitCode deliver(const MeshHexOptions& options, const mesh::SurfaceMesh& surface,
                 const hexahedrize::Hexahedrized& made, double start) {
  const auto meeting = quality::first_self_meeting(surface);
  const quality::Report report = quality::report(made.mesh);
  write_mesh(options.output, made.mesh);  // last, so that no file is left if memory runs out
  say_self_meeting(surface, meeting);
  const std::size_t quads = surface.quads.size();
  tell(options.output, options.json ? json_line(quads, made, report, meeting, seconds() - start)
                                    : summary(quads, made, report, options.output));
  return answer_for(report, options.require_valid);
}

/// What the method may use.
struct Sources {
  std::optional<format::Table> table;
  std::vector<format::Sector> sectors;
};

Sources sources_of(const MeshHexOptions& options) {
  Sources result;
  if (options.method != "construction")
    result.table = format::Table::open(table_path(options.table));
  if (options.method != "table") {
    const std::string path = sectors_path(options.sectors);
    result.sectors = format::read_sectors(core::read_file(path), path);
  }
  return result;
}

hexahedrize::Placing placing_of(const MeshHexOptions& options) {
  hexahedrize::Placing result;
  for (untangle::Options* placing : {&result.small, &result.large}) {
    if (options.effort) placing->effort = *options.effort;
    placing->threads = parallel::threads_or_all(options.threads);
  }
  return result;
}

}  // namespace

ExitCode mesh_hex(const MeshHexOptions& options) {
  const double start = seconds();
  if (is_same_file(options.input, options.output)) {
    say("INPUT and --output are the same file. See `hexatlas mesh hex --help`.");
    return ExitCode::usage;
  }
  const std::string name = options.input == "-" ? "standard input" : options.input;
  const mesh::SurfaceMesh surface = io::read_surface(options.input);
  const Sources sources = sources_of(options);
  const auto answer = hexahedrize::hexahedrize(
      surface, {sources.table ? &*sources.table : nullptr, sources.sectors}, name,
      placing_of(options));
  say_notes(answer.notes);
  if (const auto* impossible = std::get_if<hexahedrize::Impossible>(&answer.outcome)) {
    tell_without_mesh(options, name, "impossible", surface.quads.size(),
                      "no hexahedral mesh exists: " + impossible->reason, "");
    return ExitCode::no;
  }
  if (const auto* missing = std::get_if<hexahedrize::NotInTable>(&answer.outcome)) {
    const std::string reason = fmt::format(
        "the boundary of {} quads{} is not in {}; `--method auto` meshes it all the same",
        missing->quads, missing->code.empty() ? "" : ", canonical code " + missing->code + ",",
        sources.table.value().path());
    tell_without_mesh(options, name, "not_in_table", missing->quads, reason, missing->code);
    return ExitCode::undecided;
  }
  const auto& made = std::get<hexahedrize::Hexahedrized>(answer.outcome);
  expect_accepted(made, surface, sources.table);
  return deliver(options, surface, made, start);
}

}  // namespace hexatlas::cli
