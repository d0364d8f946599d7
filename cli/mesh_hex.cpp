#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/mesh_hex_report.hpp"
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

std::vector<std::string> in_words(const hexahedrize::SurfaceNotes& notes) {
  std::vector<std::string> words;
  if (notes.unused_points > 0)
    words.push_back(fmt::format("{} in no quad, kept as points of the mesh",
                                counted(notes.unused_points, "point is", "points are")));
  if (notes.reversed_quads > 0)
    words.push_back(fmt::format("{} disagreed with the others in orientation, turned over",
                                counted(notes.reversed_quads, "quad", "quads")));
  if (notes.turned_outwards) words.emplace_back("the quads faced inwards; all were turned over");
  return words;
}

MeshFiles files_of(const MeshHexOptions& options) {
  return {.input = options.input,
          .output = options.output,
          .report = options.report,
          .table = options.table,
          .sectors = options.sectors};
}

const char* name_of(hexahedrize::Method method) {
  switch (method) {
    case hexahedrize::Method::table:
      return "table";
    case hexahedrize::Method::zones:
      return "zones";
    case hexahedrize::Method::flips:
      return "flips";
    case hexahedrize::Method::construction:
      return "construction";
  }
  throw core::InternalError("a method without a name");
}

const char* name_of(hexahedrize::Rest rest) {
  switch (rest) {
    case hexahedrize::Rest::table:
      return "table";
    case hexahedrize::Rest::layer:
      return "layer";
    case hexahedrize::Rest::sectors:
      return "sectors";
  }
  throw core::InternalError("a rest without a name");
}

std::string account_of(const hexahedrize::Hexahedrized& made) {
  switch (made.method) {
    case hexahedrize::Method::table:
      return "table entry " + made.code;
    case hexahedrize::Method::zones:
      return fmt::format("{} {}zone by zone, the rest of {} quads filled by {}",
                         counted(made.peeling->peeled, "hexahedron", "hexahedra"),
                         made.peeling->layers == 0
                             ? ""
                             : "in " + counted(made.peeling->layers, "layer", "layers") + " and ",
                         made.peeling->cavity, words_for(made.peeling->rest));
    case hexahedrize::Method::flips:
      return fmt::format("{} taken off in {} and by flips, the rest of {} quads filled by {}",
                         counted(made.peeling->peeled, "hexahedron", "hexahedra"),
                         counted(made.peeling->layers, "layer", "layers"), made.peeling->cavity,
                         words_for(made.peeling->rest));
    case hexahedrize::Method::construction:
      return "by the linear construction";
  }
  throw core::InternalError("a method without a name");
}

std::string json_line(const MeshHexAccount& account, const quality::Report& report,
                      double elapsed) {
  const hexahedrize::Hexahedrized& made = account.made;
  const std::size_t quads = account.surface.quads.size();
  nlohmann::ordered_json json;
  json["outcome"] = "meshed";
  json["quads"] = quads;
  json["hexahedra"] = report.cells;
  json["interior_vertices"] = made.interior_vertices;
  add_quality(json, report);
  json["method"] = name_of(made.method);
  json["hexahedra_per_quad"] = per_quad(report.cells, quads);
  for (const char* key : {"peeled", "layers", "cavity_quads", "cavity_filled_by"})
    json[key] = nullptr;
  if (made.peeling) {
    json["peeled"] = made.peeling->peeled;
    json["layers"] = made.peeling->layers;
    json["cavity_quads"] = made.peeling->cavity;
    json["cavity_filled_by"] = name_of(made.peeling->rest);
  }
  json["table_entry"] = nullptr;
  if (!made.code.empty()) json["table_entry"] = made.code;
  add_self_meeting(json, account.meeting);
  json["seconds"] = elapsed;
  return to_line(json);
}

/// For people whose mesh cannot be used as it is.
std::string advice(const MeshHexOptions& options, const quality::Report& report) {
  if (report.valid == report.cells) return "";
  std::string others = options.layers == 0 ? "`--layers 1`, " : "";
  if (options.method != "auto") others += "`--method auto`, ";
  return "not all hexahedra are valid; more may be with " + others +
         "a larger `--effort`, or smaller and more even quads\n";
}

std::string summary(const MeshHexAccount& account, const quality::Report& report,
                    const std::string& output) {
  const hexahedrize::Hexahedrized& made = account.made;
  const std::size_t quads = account.surface.quads.size();
  return fmt::format(
      "{}: {}, {}, boundary of {} quads\n"
      "{}; {:.2f} hexahedra per quad\n"
      "{}",
      output, counted(report.cells, "hexahedron", "hexahedra"),
      counted(made.interior_vertices, "interior vertex", "interior vertices"), quads,
      account_of(made), per_quad(report.cells, quads), quality_text(report));
}

/// Whatever the table or a theorem says, a mesh is written only if the judge accepts it. That it is
/// a ball the theorem may know better: the judge looks for a proof only so long.
check::Verdict expect_accepted(const hexahedrize::Hexahedrized& made,
                               const mesh::SurfaceMesh& surface,
                               const std::optional<format::Table>& table) {
  const check::Surface boundary = for_judge(surface);
  check::Verdict verdict = check::check_mesh(for_judge(made.mesh), &boundary);
  if (verdict.accepted) return verdict;
  const std::string fault = "a mesh that is not valid: " + verdict.reason;
  if (made.method == hexahedrize::Method::table)
    throw core::InvalidInput(table.value().path(), "holds " + fault);
  if (!verdict.undecided)
    throw core::InternalError(std::string(name_of(made.method)) + " made " + fault);
  say("note: " + verdict.reason);
  return verdict;
}

ExitCode deliver(const MeshHexOptions& options, const MeshHexAccount& account, double start) {
  const quality::Report report = quality::report(account.made.mesh);
  const double elapsed = seconds() - start;
  const MeshFiles files = files_of(options);
  write_with_report(files, account.made.mesh,
                    [&] { return report_of(options, account, report, elapsed); });
  tell(files, options.json ? json_line(account, report, elapsed)
                           : summary(account, report, options.output) + advice(options, report));
  return answer_for(report, options.require_valid);
}

/// What the method may use.
struct Sources {
  std::optional<format::Table> table;
  std::vector<format::Sector> sectors;
  std::optional<hexahedrize::Method> only;
};

Sources sources_of(const MeshHexOptions& options, std::size_t quads) {
  using hexahedrize::Method;
  Sources result;
  for (const Method method : {Method::table, Method::zones, Method::flips, Method::construction})
    if (options.method == name_of(method)) result.only = method;
  if (result.only != Method::construction) result.table = table_for(options.table, quads);
  if (result.only != Method::table && result.only != Method::zones) {
    const std::string path = sectors_path(options.sectors);
    result.sectors = format::read_sectors(core::read_file(path), path);
  }
  return result;
}

}  // namespace

ExitCode mesh_hex(const MeshHexOptions& options) {
  const double start = seconds();
  if (!are_distinct(files_of(options), "INPUT", "mesh hex")) return ExitCode::usage;
  if (options.layers > 0 && (options.method == "table" || options.method == "construction")) {
    say("--layers goes with --method zones and flips only. See `hexatlas mesh hex --help`.");
    return ExitCode::usage;
  }
  expect_outputs_writable(files_of(options));
  const std::string name = input_name(options.input);
  const mesh::SurfaceMesh surface = io::read_surface(options.input);
  const Sources sources = sources_of(options, surface.quads.size());
  const auto answer =
      hexahedrize::hexahedrize(surface,
                               {.table = sources.table ? &*sources.table : nullptr,
                                .sectors = sources.sectors,
                                .only = sources.only,
                                .peeling = {.tries = options.tries,
                                            .layers = options.layers,
                                            .threads = parallel::threads_or_all(options.threads)}},
                               name, {options.effort, parallel::threads_or_all(options.threads)});
  std::vector<std::string> notes = in_words(answer.notes);
  for (const std::string& note : notes) say("note: " + note);
  if (const auto* impossible = std::get_if<hexahedrize::Impossible>(&answer.outcome)) {
    tell(files_of(options), name,
         {"impossible", surface.quads.size(), "no hexahedral mesh exists: " + impossible->reason,
          ""},
         options.json);
    return ExitCode::no;
  }
  if (const auto* missing = std::get_if<hexahedrize::NotInTable>(&answer.outcome)) {
    const std::string reason = fmt::format(
        "{} {} quads{} is not in {}; `--method auto` meshes it all the same",
        sources.only == hexahedrize::Method::zones ? "what zones leave of the boundary of"
                                                   : "the boundary of",
        missing->quads, missing->code.empty() ? "" : ", canonical code " + missing->code + ",",
        sources.table.value().path());
    tell(files_of(options), name, {"not_in_table", missing->quads, reason, missing->code},
         options.json);
    return ExitCode::undecided;
  }
  const auto& made = std::get<hexahedrize::Hexahedrized>(answer.outcome);
  const check::Verdict verdict = expect_accepted(made, surface, sources.table);
  const auto meeting = quality::first_self_meeting(surface);
  if (meeting) {
    notes.push_back(in_words(surface, *meeting));
    say("note: " + notes.back());
  }
  return deliver(options, {surface, notes, made, verdict, meeting}, start);
}

}  // namespace hexatlas::cli
