#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/mesh_check.hpp"

namespace hexatlas::cli {
namespace {

std::string json_line(const check::Verdict& verdict) {
  nlohmann::ordered_json json;
  json["accepted"] = verdict.accepted;
  json["reason"] = verdict.reason;
  json["vertices"] = verdict.vertices;
  json["interior_vertices"] = verdict.interior_vertices;
  json["edges"] = verdict.edges;
  json["quads"] = verdict.quads;
  json["hexahedra"] = verdict.hexahedra;
  json["boundary_quads"] = verdict.boundary_quads;
  json["ball_proof"] = verdict.ball_proof;
  return to_line(json);
}

std::string sentence(const CheckOptions& options, const check::Verdict& verdict) {
  if (!verdict.accepted)
    return fmt::format("{}: {}: {}\n", options.mesh, verdict.undecided ? "undecided" : "rejected",
                       verdict.reason);
  return fmt::format(
      "{}: accepted: {}, {} vertices ({} interior), {} edges, {} quads, {} of them on "
      "the boundary; a ball by {}{}\n",
      options.mesh, counted(verdict.hexahedra, "hexahedron", "hexahedra"), verdict.vertices,
      verdict.interior_vertices, verdict.edges, verdict.quads, verdict.boundary_quads,
      verdict.ball_proof, options.boundary.empty() ? "" : "; its boundary is " + options.boundary);
}

}  // namespace

ExitCode check(const CheckOptions& options) {
  try {
    const check::Mesh mesh = check::read_mesh(options.mesh);
    std::optional<check::Surface> surface;
    if (!options.boundary.empty()) surface = check::read_surface(options.boundary);
    const check::Verdict verdict = check::check_mesh(mesh, surface ? &*surface : nullptr);
    print(options.json ? json_line(verdict) : sentence(options, verdict));
    if (verdict.accepted && verdict.boundary_reversed)
      say(fmt::format("note: the quads of {} face the other way than the boundary of the mesh",
                      options.boundary));
    if (verdict.accepted && verdict.boundary_unoriented)
      say(fmt::format(
          "note: the quads of {} disagree in orientation, which was left out of account",
          options.boundary));
    if (verdict.accepted) return ExitCode::yes;
    return verdict.undecided ? ExitCode::undecided : ExitCode::no;
  } catch (const check::Malformed& error) {
    say_fault(error.what());
    return ExitCode::invalid_input;
  }
}

}  // namespace hexatlas::cli
