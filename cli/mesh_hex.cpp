#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "meshing/hexahedrize/hexahedrize.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/quality/report.hpp"

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

std::string json_line(std::size_t quads, const hexahedrize::Hexahedrized& made,
                      const quality::Report& report, double elapsed) {
  nlohmann::ordered_json json;
  json["quads"] = quads;
  json["hexahedra"] = report.hexahedra;
  json["interior_vertices"] = made.interior_vertices;
  json["min_scaled_jacobian"] = report.min_scaled_jacobian;
  json["mean_scaled_jacobian"] = report.mean_scaled_jacobian;
  json["inverted"] = report.inverted;
  json["valid"] = report.valid;
  json["table_entry"] = made.code;
  json["seconds"] = elapsed;
  return to_line(json);
}

std::string summary(std::size_t quads, const hexahedrize::Hexahedrized& made,
                    const quality::Report& report, const std::string& output) {
  return fmt::format(
      "{}: {}, {}, boundary of {} quads\n"
      "table entry {}\n"
      "scaled Jacobian: minimum {:.4f}, mean {:.4f}; {} of {} proven valid, {} inverted\n",
      output, counted(report.hexahedra, "hexahedron", "hexahedra"),
      counted(made.interior_vertices, "interior vertex", "interior vertices"), quads, made.code,
      report.min_scaled_jacobian, report.mean_scaled_jacobian, report.valid,
      counted(report.hexahedra, "hexahedron", "hexahedra"), report.inverted);
}

ExitCode deliver(const MeshHexOptions& options, std::size_t quads,
                 const hexahedrize::Hexahedrized& made, double start) {
  io::write_hexahedra(options.output, made.mesh,
                      options.output == "-" ? std::optional(io::FileFormat::vtk) : std::nullopt);
  const quality::Report report = quality::report(made.mesh);
  // With the mesh on standard output, words about it go to standard error.
  const std::string text = options.json ? json_line(quads, made, report, seconds() - start)
                                        : summary(quads, made, report, options.output);
  if (options.output == "-")
    say_text(text);
  else
    print(text);
  if (!options.require_valid || report.valid == report.hexahedra) return ExitCode::yes;
  say(fmt::format("{} not proven valid, of {}; the mesh was written all the same",
                  counted(report.hexahedra - report.valid, "hexahedron is", "hexahedra are"),
                  report.hexahedra));
  return ExitCode::undecided;
}

}  // namespace

ExitCode mesh_hex(const MeshHexOptions& options) {
  const double start = seconds();
  const std::string name = options.input == "-" ? "standard input" : options.input;
  const mesh::SurfaceMesh surface = io::read_surface(options.input);
  const format::Table table = format::Table::open(table_path(options.table));
  const auto answer = hexahedrize::hexahedrize(surface, table, name);
  say_notes(answer.notes);
  if (const auto* impossible = std::get_if<hexahedrize::Impossible>(&answer.outcome)) {
    say(fmt::format("{}: no hexahedral mesh exists: {}", name, impossible->reason));
    return ExitCode::no;
  }
  if (const auto* missing = std::get_if<hexahedrize::NotInTable>(&answer.outcome)) {
    say(fmt::format("{}: the boundary of {} quads{} is not in {}; a larger table may have it", name,
                    missing->quads,
                    missing->code.empty() ? "" : ", canonical code " + missing->code + ",",
                    table.path()));
    return ExitCode::undecided;
  }
  return deliver(options, surface.quads.size(), std::get<hexahedrize::Hexahedrized>(answer.outcome),
                 start);
}

}  // namespace hexatlas::cli
