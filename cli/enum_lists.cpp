// Spheres, balls and polyhedra with a given number of vertices.

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/long_work.hpp"
#include "cli/output.hpp"
#include "enum/balls/polyhedra.hpp"
#include "enum/balls/spheres.hpp"
#include "enum/balls/triangulations.hpp"
#include "enum/core/files.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/catalogues.hpp"
#include "tables/format/frame.hpp"

namespace hexatlas::cli {
namespace {

template <class List, class SizeOf>
std::map<std::size_t, std::uint64_t> histogram(const List& list, SizeOf&& size_of) {
  std::map<std::size_t, std::uint64_t> result;
  for (const auto& item : list) ++result[size_of(item)];
  return result;
}

void print_list(const EnumVerticesOptions& options, const char* kind, std::size_t number,
                const std::map<std::size_t, std::uint64_t>& by_tetrahedra) {
  if (options.json) {
    nlohmann::ordered_json json;
    json["vertices"] = options.vertices;
    json[kind] = number;
    json["by_tetrahedra"] = nlohmann::ordered_json::object();
    for (const auto& [size, count] : by_tetrahedra)
      json["by_tetrahedra"][std::to_string(size)] = count;
    json["exhaustive"] = false;
    tell(options.output, to_line(json));
    return;
  }
  std::string text = fmt::format("{:>10} {:>12}\n", "tetrahedra", kind);
  for (const auto& [size, count] : by_tetrahedra)
    text += fmt::format("{:>10} {:>12}\n", size, count);
  tell(options.output,
       text + fmt::format("{} {} with {} vertices found by flips; that none is missing is not "
                          "proven\n",
                          number, kind, options.vertices));
}

}  // namespace

ExitCode enum_spheres(const EnumVerticesOptions& options) {
  const balls::Spheres list =
      spheres_with(options.vertices, parallel::threads_or_all(options.threads));
  print_list(options, "spheres", list.found.size(),
             histogram(list.found, [](const auto& sphere) { return sphere.tetrahedra.size(); }));
  return ExitCode::yes;
}

ExitCode enum_balls(const EnumVerticesOptions& options) {
  if (!options.output.empty()) core::expect_writable(options.output);
  const int threads = parallel::threads_or_all(options.threads);
  const std::vector<balls::Ball> list =
      balls::balls(spheres_with(options.vertices + 1, threads), threads);
  if (!options.output.empty())
    core::write_file(
        options.output,
        format::compressed(format::catalogue_bytes(build::catalogue_of(list, options.vertices))));
  print_list(options, "balls", list.size(), histogram(list, [](const balls::Ball& ball) {
               return ball.triangulation.tetrahedra.size();
             }));
  return ExitCode::yes;
}

ExitCode enum_polyhedra(const EnumVerticesOptions& options) {
  nlohmann::ordered_json json;
  json["vertices"] = options.vertices;
  json["polyhedra"] = nlohmann::ordered_json::array();
  std::string text = fmt::format("{:>6} {:>5} {:>10} {:>8} {:>9}  {}\n", "number", "quads",
                                 "symmetries", "classes", "labelled", "facets");
  std::size_t number = 0;
  balls::ClassCounts sum;
  bool all_exhaustive = true;
  const int threads = parallel::threads_or_all(options.threads);
  for (const complex::Cell& cell : balls::polyhedra(options.vertices)) {
    const balls::Census census = balls::triangulations(
        cell, {.keep_classes = false, .threads = threads, .stop = &stop_requested()});
    const balls::ClassCounts total = census.total();
    sum += total;
    all_exhaustive = all_exhaustive && census.exhaustive;
    std::string facets;
    std::size_t quads = 0;
    for (const complex::CellFacet& facet : cell.facets) {
      quads += facet.size == 4 ? 1 : 0;
      facets += facets.empty() ? "" : " ";
      for (std::size_t i = 0; i < facet.size; ++i) facets += std::to_string(facet.vertex[i]);
    }
    text += fmt::format("{:>6} {:>5} {:>10} {:>8} {:>9}  {}\n", ++number, quads, census.symmetries,
                        total.classes, total.labelled, facets);
    json["polyhedra"].push_back({{"facets", facets},
                                 {"quads", quads},
                                 {"symmetries", census.symmetries},
                                 {"classes", total.classes},
                                 {"labelled", total.labelled},
                                 {"exhaustive", census.exhaustive}});
  }
  json["classes"] = sum.classes;
  json["exhaustive"] = all_exhaustive;
  print(options.json ? to_line(json)
                     : text + fmt::format("{} polyhedra with {} vertices, {}{} classes of "
                                          "triangulations{}\n",
                                          number, options.vertices,
                                          all_exhaustive ? "" : "at least ", sum.classes,
                                          all_exhaustive ? "; the searches are exhaustive" : ""));
  return all_exhaustive ? ExitCode::yes : ExitCode::undecided;
}

}  // namespace hexatlas::cli
