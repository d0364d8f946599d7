#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "cli/boundary_input.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/long_work.hpp"
#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/hexes/hexmeshes.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/hexmesh_search.hpp"

namespace hexatlas::cli {
namespace {

using hexes::HexFrontier;
using hexes::Hexmesh;
using hexes::Topology;

struct Tally {
  std::uint64_t classes = 0, labelled = 0, balls = 0;
};

struct Result {
  const NamedBoundary& input;
  const build::HexmeshTask& task;
  int symmetries = 1;
  HexFrontier frontier{};
  bool any_interior = false;   ///< the limit of interior vertices excludes nothing
  bool is_first_only = false;  ///< others were found and left out

  /// Nothing that the part searched has is missing.
  [[nodiscard]] bool has_whole_part() const { return frontier.is_finished() && !is_first_only; }
  [[nodiscard]] bool is_exhaustive() const { return has_whole_part() && task.parts == 1; }
};

std::map<std::size_t, Tally> by_hexahedra(const Result& result) {
  std::map<std::size_t, Tally> tallies;
  for (const Hexmesh& found : result.frontier.found) {
    Tally& tally = tallies[found.mesh.hexahedra.size()];
    ++tally.classes;
    tally.labelled += static_cast<std::uint64_t>(result.symmetries / found.automorphisms);
    if (found.topology == Topology::ball) ++tally.balls;
  }
  return tallies;
}

std::size_t undecided(const Result& result) {
  return static_cast<std::size_t>(
      std::count_if(result.frontier.found.begin(), result.frontier.found.end(),
                    [](const Hexmesh& found) { return found.topology == Topology::undecided; }));
}

std::string shard_text(const build::HexmeshTask& task) {
  return fmt::format("{}/{}", task.part, task.parts);
}

/// What is searched.
nlohmann::ordered_json json_of_task(const Result& result) {
  nlohmann::ordered_json json;
  json["boundary"] = result.input.code;
  json["quads"] = result.input.boundary.quads();
  json["kind"] = result.task.limits.ball ? "ball" : "any";
  json["max_hexes"] = result.task.limits.max_hexahedra;
  json["max_interior"] = result.task.limits.max_interior;
  json["any_interior"] = result.any_interior;
  return json;
}

nlohmann::ordered_json json_of(const Result& result) {
  nlohmann::ordered_json json = json_of_task(result);
  json["shard"] = shard_text(result.task);
  Tally total;
  json["by_hexes"] = nlohmann::ordered_json::object();
  for (const auto& [hexahedra, tally] : by_hexahedra(result)) {
    json["by_hexes"][std::to_string(hexahedra)] = {
        {"classes", tally.classes}, {"labelled", tally.labelled}, {"balls", tally.balls}};
    total.classes += tally.classes;
    total.labelled += tally.labelled;
    total.balls += tally.balls;
  }
  json["classes"] = total.classes;
  json["labelled"] = total.labelled;
  json["balls"] = total.balls;
  json["symmetries"] = result.symmetries;
  json["nodes"] = result.frontier.counts.nodes;
  json["finished"] = result.has_whole_part();
  json["exhaustive"] = result.is_exhaustive();
  return json;
}

std::string limits_text(const Result& result) {
  const hexes::SearchLimits& limits = result.task.limits;
  std::string text = fmt::format(
      "at most {}",
      counted(static_cast<std::size_t>(limits.max_hexahedra), "hexahedron", "hexahedra"));
  if (!result.any_interior)
    text += fmt::format(" and {}", counted(static_cast<std::size_t>(limits.max_interior),
                                           "interior vertex", "interior vertices"));
  return text;
}

std::string report(const Result& result) {
  std::string text;
  const auto tallies = by_hexahedra(result);
  if (!tallies.empty())
    text = fmt::format("{:>9} {:>10} {:>12} {:>10}\n", "hexahedra", "classes", "labelled", "balls");
  for (const auto& [hexahedra, tally] : tallies)
    text += fmt::format("{:>9} {:>10} {:>12} {:>10}\n", hexahedra, tally.classes, tally.labelled,
                        tally.balls);
  const std::string end = result.is_exhaustive()    ? "; the search is exhaustive"
                          : result.has_whole_part() ? "; that part is exhausted"
                                                    : "";
  return text + fmt::format("{} ({} quads), {}, {}{}: {}{}; {} nodes{}\n", result.input.code,
                            result.input.boundary.quads(), limits_text(result),
                            result.task.limits.ball ? "balls" : "any complexes",
                            result.task.parts == 1 ? "" : ", part " + shard_text(result.task),
                            result.has_whole_part() ? "" : "at least ",
                            counted(result.frontier.found.size(), "class", "classes"),
                            result.frontier.counts.nodes, end);
}

std::string list_of(const Result& result) {
  static constexpr std::array<const char*, 3> kTopology{"ball", "no ball", "undecided"};
  std::string lines;
  for (const Hexmesh& found : result.frontier.found) {
    nlohmann::ordered_json json;
    json["code"] = result.input.code;
    json["quads"] = result.input.boundary.quads();
    json["hexahedra"] = found.mesh.hexahedra.size();
    json["interior_vertices"] =
        found.mesh.vertices - static_cast<std::uint32_t>(result.input.boundary.vertices());
    json["automorphisms"] = found.automorphisms;
    json["topology"] = kTopology[static_cast<std::size_t>(found.topology)];
    json["boundary"] = result.input.boundary.list_of_quads();
    json["cells"] = found.mesh.hexahedra;
    lines += to_line(json);
  }
  return lines;
}

ExitCode tell_estimate(const EnumHexmeshesOptions& options, const hexes::HexmeshProblem& problem) {
  const search::Estimate estimate =
      problem.estimate(options.probes, options.seed, parallel::threads_or_all(options.threads));
  if (options.json) {
    nlohmann::ordered_json json;
    json["nodes"] = estimate.nodes;
    json["standard_error"] = estimate.standard_error;
    json["probes"] = estimate.probes;
    json["exact"] = estimate.is_exact;
    print(to_line(json));
  } else if (estimate.is_exact) {
    print(fmt::format("{:.0f} nodes, exactly\n", estimate.nodes));
  } else {
    print(fmt::format("{:.3g} nodes, standard error {:.2g}, by {} probes\n", estimate.nodes,
                      estimate.standard_error, estimate.probes));
  }
  return ExitCode::yes;
}

ExitCode write_certificate(const EnumHexmeshesOptions& options, const hexes::SearchLimits& limits,
                           const Result& result) {
  ProgressLine progress;
  const hexes::BoundLog log =
      hexes::bound_log(result.input.boundary, limits,
                       {.threads = parallel::threads_or_all(options.threads),
                        .stop = &stop_requested(),
                        .progress = [&progress](std::size_t done, std::size_t all) {
                          progress.update("parts of the search", done, all);
                        }});
  if (log.has_found_a_mesh) {
    say(fmt::format("{}: there is a mesh with {}; nothing was written", result.input.code,
                    limits_text(result)));
    nlohmann::ordered_json json = json_of_task(result);
    json["outcome"] = "has_mesh";
    if (options.json) print(to_line(json));
    return ExitCode::no;
  }
  if (!log.is_complete) {
    say("the search did not end; nothing was written");
    return ExitCode::undecided;
  }
  const std::string bytes = build::bound_certificate(result.input.boundary, limits, log);
  core::write_file(options.certificate, bytes);
  std::string text;
  if (options.json) {
    nlohmann::ordered_json json = json_of_task(result);
    json["classes"] = 0;
    json["balls"] = 0;
    json["symmetries"] = result.symmetries;
    json["exhaustive"] = true;
    json["records"] = log.records;
    json["bytes"] = bytes.size();
    text = to_line(json);
  } else {
    text =
        fmt::format("{}: no {} with {}; {} records, {} bytes\n", options.certificate,
                    limits.ball ? "ball" : "mesh", limits_text(result), log.records, bytes.size());
  }
  tell(options.certificate, text);
  return ExitCode::yes;
}

/// The search goes on where the file says, or begins.
HexFrontier frontier_of(const EnumHexmeshesOptions& options, const hexes::HexmeshProblem& problem,
                        const build::HexmeshTask& task) {
  if (!options.state.empty() && is_there(options.state)) {
    heed_stops();
    return build::frontier_from(core::read_state(options.state), task, options.state);
  }
  return problem.begin(task.part, task.parts);
}

void search(const EnumHexmeshesOptions& options, const hexes::HexmeshProblem& problem,
            Result& result) {
  result.frontier = frontier_of(options, problem, result.task);
  ProgressLine progress;
  constexpr std::uint64_t kProbes = 5000;  // less than a second
  const double estimate = progress.is_watched() ? problem.estimate(kProbes, 1, 1).nodes : 0;
  const std::size_t expected = estimate < 0x1p63 ? static_cast<std::size_t>(estimate) : 0;
  const std::string phase = progress.is_watched() ? "nodes, of an estimate" : "nodes";
  const auto save = [&] {
    if (!options.state.empty())
      core::write_file(options.state, build::to_text(result.task, result.frontier));
  };
  PeriodicSave saved(options.save_every, save);
  if (!(options.first && !result.frontier.found.empty()))
    problem.go_on(result.frontier,
                  {.threads = parallel::threads_or_all(options.threads),
                   .max_nodes = options.max_nodes,
                   .stop = &stop_requested()},
                  [&] {
                    progress.update(phase, result.frontier.counts.nodes, expected);
                    saved.if_due();
                    return !(options.first && !result.frontier.found.empty());
                  });
  if (result.frontier.is_finished())
    saved.try_now();
  else
    save();
  std::sort(result.frontier.found.begin(), result.frontier.found.end(),
            [](const Hexmesh& a, const Hexmesh& b) {
              const auto& [cells, others] = std::tie(a.mesh.hexahedra, b.mesh.hexahedra);
              return cells.size() != others.size() ? cells.size() < others.size() : cells < others;
            });
  result.is_first_only = options.first && result.frontier.found.size() > 1;
  if (result.is_first_only) result.frontier.found.resize(1);
}

build::HexmeshTask task_of(const EnumHexmeshesOptions& options, const NamedBoundary& input) {
  build::HexmeshTask task{input.boundary, {}, 0, 1};
  if (const auto shard = shard_from(options.shard)) {
    task.part = shard->part;
    task.parts = shard->parts;
  }
  const int room = hexes::kMaxMeshVertices - input.boundary.vertices();
  const int most = hexes::most_interior_vertices(input.boundary.quads(), options.max_hexahedra);
  task.limits.max_hexahedra = options.max_hexahedra;
  task.limits.max_interior = options.max_interior < 0 ? most : std::min(most, options.max_interior);
  task.limits.ball = options.ball;
  if (task.limits.max_interior > room)
    throw core::InvalidInput(
        options.boundary,
        fmt::format(
            "{} hexahedra may have {} interior vertices; with those of the boundary at most "
            "{} are possible, so --max-interior must be at most {}",
            options.max_hexahedra, most, hexes::kMaxMeshVertices, room));
  return task;
}

}  // namespace

ExitCode enum_hexmeshes(const EnumHexmeshesOptions& options) {
  const auto known = boundary_from(options.boundary);
  if (const auto* none = std::get_if<Unfillable>(&known)) {
    tell(MeshFiles{}, options.boundary, {"impossible", none->quads, none->reason, ""},
         options.json);
    return ExitCode::no;
  }
  const auto& input = std::get<NamedBoundary>(known);
  for (const std::string& file : {options.output, options.certificate, options.state})
    if (!file.empty()) core::expect_writable(file);
  const build::HexmeshTask task = task_of(options, input);
  const hexes::HexmeshProblem problem(input.boundary, task.limits);
  if (options.probes != 0) return tell_estimate(options, problem);
  Result result{.input = input, .task = task, .symmetries = problem.symmetries()};
  result.any_interior =
      task.limits.max_interior ==
      hexes::most_interior_vertices(input.boundary.quads(), options.max_hexahedra);
  if (!options.certificate.empty()) return write_certificate(options, problem.limits(), result);
  search(options, problem, result);
  if (!options.output.empty()) core::write_file(options.output, list_of(result));
  const std::string text = options.json ? to_line(json_of(result)) : report(result);
  tell(options.output, text);
  if (result.frontier.is_finished() && (!task.limits.ball || undecided(result) == 0))
    return ExitCode::yes;
  if (options.first && !result.frontier.found.empty()) return ExitCode::yes;
  if (!result.frontier.is_finished())
    say("the search did not end; the numbers are lower bounds");
  else
    say(fmt::format("{} not known to be balls or not",
                    counted(undecided(result), "class is", "classes are")));
  return ExitCode::undecided;
}

}  // namespace hexatlas::cli
