#include "cli/check_hybrid.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/output.hpp"
#include "tables/check/hybrid_check.hpp"
#include "tables/check/mesh.hpp"

namespace hexatlas::cli {
namespace {

std::string json_line(const check::HybridVerdict& verdict) {
  nlohmann::ordered_json json;
  json["accepted"] = verdict.accepted;
  json["undecided"] = verdict.undecided;
  json["law"] = check::name_of(verdict.broken);
  json["reason"] = verdict.reason;
  json["points"] = verdict.points;
  json["unused_points"] = verdict.unused_points;
  json["tetrahedra"] = verdict.tetrahedra;
  json["hexahedra"] = verdict.hexahedra;
  json["prisms"] = verdict.prisms;
  json["pyramids"] = verdict.pyramids;
  json["boundary_triangles"] = verdict.boundary_triangles;
  json["boundary_quads"] = verdict.boundary_quads;
  json["warped_boundary_quads"] = verdict.warped_boundary_quads;
  json["singular_boundary_edges"] = verdict.singular_boundary_edges;
  return to_line(json);
}

std::string sentence(const CheckOptions& options, const check::HybridVerdict& verdict) {
  if (!verdict.accepted)
    return fmt::format("{}: {}: {}: {}\n", options.mesh,
                       verdict.undecided ? "undecided" : "rejected", check::name_of(verdict.broken),
                       verdict.reason);
  std::string text = fmt::format(
      "{}: accepted: {}, {}, {}, {}, all valid, facet to facet; {} points ({} in no cell); on the "
      "boundary {} and {} ({} of them warped), {}",
      options.mesh, counted(verdict.tetrahedra, "tetrahedron", "tetrahedra"),
      counted(verdict.hexahedra, "hexahedron", "hexahedra"),
      counted(verdict.prisms, "prism", "prisms"), counted(verdict.pyramids, "pyramid", "pyramids"),
      verdict.points, verdict.unused_points,
      counted(verdict.boundary_triangles, "triangle", "triangles"),
      counted(verdict.boundary_quads, "quad", "quads"), verdict.warped_boundary_quads,
      counted(verdict.singular_boundary_edges, "singular edge", "singular edges"));
  if (!options.boundary.empty()) text += "; its boundary is that of " + options.boundary;
  return text + "\n";
}

}  // namespace

ExitCode check_hybrid_mesh(const CheckOptions& options) {
  if (!options.completeness.empty()) {
    say("--completeness does not go with --hybrid");
    return ExitCode::usage;
  }
  const check::HybridMesh mesh = check::read_hybrid(options.mesh);
  std::optional<check::TetrahedralMesh> given;
  if (!options.boundary.empty()) given = check::read_tetrahedra(options.boundary);
  const check::HybridVerdict verdict = check::check_hybrid(mesh, given ? &*given : nullptr);
  print(options.json ? json_line(verdict) : sentence(options, verdict));
  if (verdict.accepted) return ExitCode::yes;
  return verdict.undecided ? ExitCode::undecided : ExitCode::no;
}

}  // namespace hexatlas::cli
