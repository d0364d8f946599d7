#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/errors.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "meshing/hexahedrize/placing.hpp"
#include "meshing/hexahedrize/sides.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/quality/report.hpp"
#include "tables/check/mesh_check.hpp"

namespace hexatlas::cli {
namespace {

/// A mesh without coordinates, the vertices of its boundary first; and where these are.
struct Start {
  complex::HexComplex mesh;
  mesh::SurfaceMesh boundary;
};

Start start_of(const mesh::HexMesh& mesh) {
  complex::HexComplex given{static_cast<std::uint32_t>(mesh.points.size()), mesh.hexahedra};
  std::vector<complex::VertexId> outer;
  for (const complex::BoundaryQuad& quad : complex::boundary_of(given))
    outer.insert(outer.end(), quad.begin(), quad.end());
  std::sort(outer.begin(), outer.end());
  outer.erase(std::unique(outer.begin(), outer.end()), outer.end());
  Start start{complex::renumbered(std::move(given), outer), {}};
  start.boundary.quads = complex::boundary_of(start.mesh);
  for (const complex::VertexId v : outer) start.boundary.points.push_back(mesh.points[v]);
  return start;
}

/// The mesh in a file, of which regions and what is between them will be lost.
mesh::HexMesh with_lost_interfaces_told(const std::string& input, const std::string& name) {
  mesh::HexModel model = io::read_hex_model(input);
  const std::vector<std::uint8_t> is_on = hexahedrize::points_of_interfaces(model);
  const auto count = static_cast<std::size_t>(std::count(is_on.begin(), is_on.end(), 1));
  if (count > 0)
    say(
        fmt::format("note: {} has {} on interfaces, between regions or on quads that it lists; "
                    "these are not kept",
                    name, counted(count, "vertex", "vertices")));
  return std::move(model.mesh);
}

/// Leaves out points of no hexahedron, which are no vertices of the mesh; says so.
mesh::HexMesh without_unused_points(mesh::HexMesh mesh, const std::string& file) {
  const std::vector<std::uint8_t> is_used = hexahedrize::points_of_cells(mesh);
  std::vector<mesh::Index> number(mesh.points.size());
  std::vector<mesh::Point> points;
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[v] = static_cast<mesh::Index>(points.size());
    if (is_used[v] != 0) points.push_back(mesh.points[v]);
  }
  const std::size_t unused = mesh.points.size() - points.size();
  if (unused == 0) return mesh;
  for (auto& cell : mesh.hexahedra)
    for (mesh::Index& v : cell) v = number[v];
  mesh.points = std::move(points);
  say(fmt::format("note: {} of {} in no hexahedron, left out", counted(unused, "point", "points"),
                  file));
  return mesh;
}

/// Whether the judge shows the mesh to be a ball; it may be undecided about that. Throws
/// InvalidInput if it finds a fault.
bool is_shown_ball(const mesh::HexMesh& mesh, const std::string& file) {
  const check::Verdict verdict = check::check_mesh(for_judge(mesh), nullptr);
  if (!verdict.accepted && !verdict.undecided)
    throw core::InvalidInput(file, "is not a mesh of a ball: " + verdict.reason);
  return verdict.accepted;
}

/// The mesh made, its interior vertices placed, judged as a whole.
mesh::HexMesh placed(const complex::HexComplex& made, const mesh::SurfaceMesh& boundary,
                     int effort) {
  mesh::HexMesh mesh{boundary.points, made.hexahedra};
  mesh.points.resize(made.vertices);
  hexahedrize::place_in_a_frame(mesh, boundary.points.size(),
                                {.effort = effort, .threads = parallel::available_threads()});
  const check::Surface surface = for_judge(boundary);
  const check::Verdict verdict = check::check_mesh(for_judge(mesh), &surface);
  if (!verdict.accepted && !verdict.undecided)
    throw core::InternalError("simplify made a mesh that is not valid: " + verdict.reason);
  return mesh;
}

/// The meshes before and after.
struct Change {
  quality::Report before, after;
  std::size_t interior = 0, exchanges = 0;
};

std::size_t not_valid(const quality::Report& report) { return report.cells - report.valid; }

std::string json_line(const Change& change, double elapsed) {
  nlohmann::ordered_json json;
  json["before"] = change.before.cells;
  json["after"] = change.after.cells;
  json["interior_vertices"] = change.interior;
  json["exchanges"] = change.exchanges;
  json["seconds"] = elapsed;
  add_quality(json, change.after);
  add_quality(json["quality_before"], change.before);
  return to_line(json);
}

std::string summary(const Change& change, const std::string& output) {
  return fmt::format("{}: {}, {} before; {}; {}\nbefore\n{}after\n{}", output,
                     counted(change.after.cells, "hexahedron", "hexahedra"), change.before.cells,
                     counted(change.interior, "interior vertex", "interior vertices"),
                     counted(change.exchanges, "exchange", "exchanges"),
                     quality_text(change.before), quality_text(change.after));
}

struct Outcome {
  mesh::HexMesh mesh;  ///< the one given, as it was, if none was smaller
  quality::Report quality;
  std::size_t exchanges = 0;
  std::size_t taken_back = 0;
  std::size_t tries = 0;
  bool is_stopped = false;
};

/// Searches in stages, each from the least mesh so far, so that one can be taken back.
class Search {
 public:
  explicit Search(const SimplifyOptions& options) : options_(options) {
    if (!options.without_table) table_ = open_table(options.table);
  }

  Outcome run(const mesh::HexMesh& given, const quality::Report& before, Start start) {
    Outcome result{given, before};
    const std::size_t all = options_.search.tries;
    const std::size_t longest = options_.keep_valid ? std::max(all / kStages, kShortestStage) : all;
    std::size_t length = longest;
    for (std::uint64_t stage = 0; result.tries < all && result.taken_back < kMostTakenBack &&
                                  start.mesh.hexahedra.size() > 1 && !result.is_stopped;
         ++stage) {
      length = std::min(length, all - result.tries);
      simplify::Simplified made = stage_from(start.mesh, stage, result.tries, length);
      result.tries += made.tries;
      result.exchanges += made.exchanges;
      result.is_stopped = made.is_stopped;
      bool is_taken = true;
      if (made.mesh.hexahedra.size() < start.mesh.hexahedra.size()) {
        mesh::HexMesh mesh = placed(made.mesh, start.boundary, options_.effort);
        const quality::Report after = quality::report(mesh);
        is_taken = !options_.keep_valid || not_valid(after) <= not_valid(before);
        if (is_taken) {
          result.mesh = std::move(mesh);
          result.quality = after;
          start.mesh = std::move(made.mesh);
        }
      }
      result.taken_back += is_taken ? 0 : 1;
      length = is_taken ? std::min(2 * length, longest) : std::max(length / 2, kShortestStage);
    }
    return result;
  }

 private:
  static constexpr std::size_t kStages = 16;
  static constexpr std::size_t kShortestStage = 16;
  static constexpr std::size_t kMostTakenBack = 50;  ///< each takes all of the effort

  simplify::Simplified stage_from(const complex::HexComplex& mesh, std::uint64_t stage,
                                  std::size_t done, std::size_t tries) {
    simplify::Options search = options_.search;
    search.tries = tries;
    search.seed += stage * 0x9e3779b97f4a7c15;  // seeds in a row share no stage
    search.stop = &stop_requested();
    ProgressLine line;
    search.progress = [&](std::size_t now, std::size_t hexahedra) {
      line.update(fmt::format("{} hexahedra, least {}; tries", mesh.hexahedra.size(), hexahedra),
                  done + now, options_.search.tries);
    };
    return simplify::simplified(mesh, table_ ? &*table_ : nullptr, search);
  }

  const SimplifyOptions& options_;
  std::optional<format::Table> table_;
};

}  // namespace

ExitCode simplify_mesh(const SimplifyOptions& options) {
  const double begin = seconds();
  if (!are_distinct({.input = options.input, .output = options.output, .table = options.table},
                    "MESH", "simplify"))
    return ExitCode::usage;
  expect_mesh_writable(options.output);
  const std::string name = input_name(options.input);
  mesh::HexMesh given = without_unused_points(with_lost_interfaces_told(options.input, name), name);
  if (!is_shown_ball(given, name))
    say("note: that " + name + " is a ball was not shown; what is written is homeomorphic to it");
  turn_over_what_is_inside_out(given, name);
  Start start = start_of(given);
  const std::size_t on_boundary = start.boundary.points.size();
  const quality::Report before = quality::report(given);
  const Outcome made = Search(options).run(given, before, std::move(start));
  write_mesh(options.output, made.mesh);
  const Change change{before, made.quality, made.mesh.points.size() - on_boundary, made.exchanges};
  if (made.taken_back > 0)
    say(fmt::format(
        "note: {} taken back, since more hexahedra were not proven valid; {} of {} made",
        counted(made.taken_back, "change", "changes"), counted(made.tries, "try", "tries"),
        options.search.tries));
  tell(options.output,
       options.json ? json_line(change, seconds() - begin) : summary(change, options.output));
  if (!made.is_stopped) return answer_for(change.after, options.require_valid);
  say("stopped; the least mesh so far was written");
  return ExitCode::undecided;
}

}  // namespace hexatlas::cli
