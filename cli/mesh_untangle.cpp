#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hexahedrize/placing.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/quality/report.hpp"

namespace hexatlas::cli {
namespace {

void expect_placeable(const mesh::HexMesh& mesh, const std::string& file) {
  for (std::size_t c = 0; c < mesh.hexahedra.size(); ++c) {
    auto cell = mesh.hexahedra[c];
    std::sort(cell.begin(), cell.end());
    if (std::adjacent_find(cell.begin(), cell.end()) != cell.end())
      throw core::InvalidInput(file, fmt::format("hexahedron {} has a vertex twice", c));
  }
}

nlohmann::ordered_json json_of(const quality::Report& report) {
  nlohmann::ordered_json json;
  add_quality(json, report);
  return json;
}

}  // namespace

ExitCode mesh_untangle(const MeshUntangleOptions& options) {
  const double start = seconds();
  if (is_same_file(options.input, options.output)) {
    say("MESH and --output are the same file. See `hexatlas mesh untangle --help`.");
    return ExitCode::usage;
  }
  expect_mesh_writable(options.output);
  mesh::HexMesh mesh = io::read_hexahedra(options.input);
  const std::string name = options.input == "-" ? "standard input" : options.input;
  expect_placeable(mesh, name);
  std::vector<std::uint8_t> is_free = options.free_boundary
                                          ? std::vector<std::uint8_t>(mesh.points.size(), 1)
                                          : hexahedrize::interior_points(mesh);
  const auto moved = std::count(is_free.begin(), is_free.end(), std::uint8_t{1});
  const quality::Report before = quality::report(mesh);
  hexahedrize::place(mesh, std::move(is_free),
                     {.effort = options.effort,
                      .threads = parallel::threads_or_all(options.threads),
                      .starts_as_given = !options.harmonic});
  write_mesh(options.output, mesh);
  const quality::Report report = quality::report(mesh);
  if (options.json) {
    nlohmann::ordered_json json;
    json["hexahedra"] = report.hexahedra;
    json["free_vertices"] = moved;
    json["before"] = json_of(before);
    json["after"] = json_of(report);
    json["seconds"] = seconds() - start;
    tell(options.output, to_line(json));
  } else {
    tell(options.output,
         fmt::format("{}: {}, {}\nbefore\n{}after\n{}", options.output,
                     counted(report.hexahedra, "hexahedron", "hexahedra"),
                     counted(static_cast<std::size_t>(moved), "free vertex", "free vertices"),
                     quality_text(before), quality_text(report)));
  }
  return answer_for(report, options.require_valid);
}

}  // namespace hexatlas::cli
