#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "enum/core/files.hpp"
#include "enum/hexes/shellings.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::cli {
namespace {

hexes::ShellingCensus census_of(const EnumShellingsOptions& options) {
  ProgressLine progress;
  hexes::ShellingOptions census_options;
  census_options.hexahedra = options.hexahedra;
  census_options.threads = parallel::threads_or_all(options.threads);
  census_options.max_bytes = static_cast<std::uint64_t>(options.memory_gib) << 30U;
  census_options.stop = &stop_requested();
  census_options.progress = [&progress](int hexahedra, std::size_t done, std::size_t all) {
    progress.update(fmt::format("balls of {} hexahedra, from those with one less", hexahedra), done,
                    all);
  };
  return hexes::shellable_balls(census_options);
}

/// What is asked for and not known is null.
std::string json_line(int hexahedra, const hexes::ShellingCensus& census) {
  nlohmann::ordered_json json;
  json["hexes"] = hexahedra;
  json["meshes"] = nullptr;
  json["boundaries"] = nullptr;
  json["by_hexes"] = nlohmann::ordered_json::array();
  for (const hexes::ShellingCounts& counts : census.by_hexahedra) {
    nlohmann::ordered_json row;
    row["hexes"] = counts.hexahedra;
    row["meshes"] = counts.meshes;
    row["boundaries"] = counts.boundaries;
    row["new_boundaries"] = counts.new_boundaries;
    json["by_hexes"].push_back(row);
  }
  if (census.exhaustive) {
    json["meshes"] = census.by_hexahedra.back().meshes;
    json["boundaries"] = census.by_hexahedra.back().boundaries;
  }
  json["exhaustive"] = census.exhaustive;
  return to_line(json);
}

std::string report(int hexahedra, const hexes::ShellingCensus& census) {
  std::string text =
      fmt::format("{:>9} {:>12} {:>12} {:>12}\n", "hexahedra", "meshes", "boundaries", "new");
  std::uint64_t unshellable = 0;
  for (const hexes::ShellingCounts& counts : census.by_hexahedra) {
    text += fmt::format("{:>9} {:>12} {:>12} {:>12}\n", counts.hexahedra, counts.meshes,
                        counts.boundaries, counts.new_boundaries);
    unshellable += counts.unshellable_rests;
  }
  text +=
      fmt::format("{} of the ways to take a hexahedron off leave a ball that is not shellable\n",
                  unshellable == 0 ? "none" : std::to_string(unshellable));
  if (census.exhaustive)
    text += fmt::format("shellable balls of {}: {}; the search is exhaustive\n",
                        counted(static_cast<std::size_t>(hexahedra), "hexahedron", "hexahedra"),
                        counted(census.by_hexahedra.back().meshes, "mesh", "meshes"));
  return text;
}

}  // namespace

ExitCode enum_shellings(const EnumShellingsOptions& options) {
  if (!options.output.empty()) core::expect_writable(options.output);
  const hexes::ShellingCensus census = census_of(options);
  if (census.exhaustive && !options.output.empty())
    core::write_file(options.output,
                     shellings_text(census, parallel::threads_or_all(options.threads)));
  const std::string text =
      options.json ? json_line(options.hexahedra, census) : report(options.hexahedra, census);
  tell(options.output, text);
  if (census.exhaustive) return ExitCode::yes;
  say(fmt::format("stopped; what is finished is complete up to {}{}",
                  counted(census.by_hexahedra.size(), "hexahedron", "hexahedra"),
                  options.output.empty() ? "" : "; no list is written"));
  return ExitCode::undecided;
}

}  // namespace hexatlas::cli
