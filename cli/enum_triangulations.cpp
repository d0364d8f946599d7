#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/cell_input.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/long_work.hpp"
#include "cli/output.hpp"
#include "enum/balls/spheres.hpp"
#include "enum/balls/spheres_cells.hpp"
#include "enum/balls/triangulations.hpp"
#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/catalogues.hpp"
#include "tables/format/frame.hpp"

namespace hexatlas::cli {
namespace {

std::string json_line(const std::string& cell, int interior, const balls::Census& census) {
  nlohmann::ordered_json json;
  json["cell"] = cell;
  json["interior"] = interior;
  json["classes"] = census.total().classes;
  json["labelled"] = census.total().labelled;
  json["by_tetrahedra"] = nlohmann::ordered_json::object();
  for (const auto& [size, counts] : census.by_tetrahedra)
    json["by_tetrahedra"][std::to_string(size)] = {{"classes", counts.classes},
                                                   {"labelled", counts.labelled}};
  json["symmetries"] = census.symmetries;
  json["nodes"] = census.nodes;
  json["exhaustive"] = census.exhaustive;
  return to_line(json);
}

std::string report(const std::string& cell, int interior, const balls::Census& census) {
  std::string text = fmt::format("{:>10} {:>12} {:>14}\n", "tetrahedra", "classes", "labelled");
  for (const auto& [size, counts] : census.by_tetrahedra)
    text += fmt::format("{:>10} {:>12} {:>14}\n", size, counts.classes, counts.labelled);
  const balls::ClassCounts total = census.total();
  const std::string bound = census.exhaustive ? "" : "at least ";
  text += fmt::format("{}{}: {}{}, {}{} labelled{}\n", cell,
                      interior == 0 ? ""
                                    : " with " + counted(static_cast<std::size_t>(interior),
                                                         "interior vertex", "interior vertices"),
                      bound, counted(total.classes, "class", "classes"), bound, total.labelled,
                      census.exhaustive ? "; the search is exhaustive" : "");
  return text;
}

balls::Census census_of(const complex::Cell& cell, balls::CensusOptions options) {
  ProgressLine progress;
  options.stop = &stop_requested();
  options.progress = [&progress](std::size_t done, std::size_t all) {
    progress.update("parts of the search", done, all);
  };
  return balls::triangulations(cell, options);
}

/// The second road, which shares no search with the first.
balls::Census census_through_spheres(const complex::Cell& cell,
                                     const balls::CensusOptions& options) {
  const balls::CellClasses found = balls::triangulations_from(
      spheres_with(cell.vertices + options.interior + 1, options.threads), cell,
      {options.boundary_tetrahedra}, options.threads);
  balls::Census census;
  census.symmetries = complex::symmetries(cell).size();
  for (const balls::CellClass& entry : found.classes) {
    census.by_tetrahedra[entry.triangulation.tetrahedra.size()] +=
        {1, census.symmetries / entry.automorphisms};
    census.classes.push_back({entry.triangulation, entry.automorphisms});
  }
  return census;
}

void write_completeness(const std::string& file, const format::Catalogue& catalogue) {
  const auto certificate = prove_completeness(catalogue);
  core::ensures(certificate.has_value(), "an exhaustive list is complete");
  core::write_file(file, format::compressed(*certificate));
}

void expect_few_enough(const EnumTriangulationsOptions& options, const NamedCell& input) {
  const int vertices = input.cell.vertices + options.interior;
  const int most =
      options.through_spheres ? balls::kMaxSphereVertices - 1 : complex::kMaxTriangulationVertices;
  if (vertices > most)
    throw core::InvalidInput(
        options.cell,
        fmt::format("has {} vertices in all, interior ones included; at most "
                    "{} are possible{}",
                    vertices, most, options.through_spheres ? " through spheres" : ""));
}

void expect_known_completeness(const EnumTriangulationsOptions& options, const NamedCell& input) {
  if (options.completeness.empty()) return;
  if (input.name != "hexahedron" || options.interior != 0 || options.boundary_tetrahedra ||
      options.through_spheres)
    throw core::InvalidInput(options.cell,
                             "--completeness is for the hexahedron without interior vertex and "
                             "without boundary tetrahedra, by the direct search");
}

}  // namespace

ExitCode enum_triangulations(const EnumTriangulationsOptions& options) {
  const NamedCell input = cell_from(options.cell);
  expect_few_enough(options, input);
  expect_known_completeness(options, input);
  for (const std::string& file : {options.output, options.completeness})
    if (!file.empty()) core::expect_writable(file);
  balls::CensusOptions census_options;
  census_options.interior = options.interior;
  census_options.boundary_tetrahedra = options.boundary_tetrahedra;
  census_options.keep_classes = !options.output.empty() || !options.completeness.empty();
  census_options.threads = parallel::threads_or_all(options.threads);
  census_options.max_nodes = options.max_nodes;
  const balls::Census census = options.through_spheres
                                   ? census_through_spheres(input.cell, census_options)
                                   : census_of(input.cell, census_options);
  if (census_options.keep_classes) {
    const format::Catalogue catalogue =
        build::catalogue_of(input.cell, input.name, census_options, census);
    if (!options.output.empty())
      core::write_file(options.output, format::catalogue_bytes(catalogue));
    if (!options.completeness.empty() && census.exhaustive)
      write_completeness(options.completeness, catalogue);
  }
  const std::string text = options.json ? json_line(input.name, options.interior, census)
                                        : report(input.name, options.interior, census);
  tell(options.completeness == "-" ? options.completeness : options.output, text);
  if (census.exhaustive) return ExitCode::yes;
  if (options.through_spheres)
    say("that no 3-sphere is missing from the list is not proven");
  else if (census.undecided != 0)
    say(fmt::format("{} are not known to be balls or not; the numbers are lower bounds",
                    counted(census.undecided, "class", "classes")));
  else
    say("the search did not end; the numbers are lower bounds");
  return ExitCode::undecided;
}

}  // namespace hexatlas::cli
