#include "cli/table_by_quads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/mesh_output.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/files.hpp"
#include "tables/build/census.hpp"
#include "tables/sheet/distribution_chart.hpp"

namespace hexatlas::cli {
namespace {

struct LowerBounds {
  int least = 0;                    ///< of all
  std::size_t proven_smallest = 0;  ///< meshes
};

struct Statistics {
  std::string read_from;
  std::map<int, sheet::Distribution> by_quads;
  std::map<int, LowerBounds> bounds;
  std::map<int, std::map<std::string, std::size_t>> sources;  ///< from a census only

  void add(int quads, int hexahedra, int lower_bound) {
    by_quads[quads].quads = quads;
    ++by_quads[quads].meshes[hexahedra];
    LowerBounds& all = bounds.try_emplace(quads, LowerBounds{lower_bound, 0}).first->second;
    all.least = std::min(all.least, lower_bound);
    all.proven_smallest += static_cast<std::size_t>(lower_bound == hexahedra);
  }
};

Statistics statistics_of(const format::Table& table) {
  Statistics result;
  if (const auto census = census_beside(table)) {
    result.read_from = build::census_path(table.path());
    for (const build::CensusRow& row : census->rows) {
      result.add(row.quads, row.hexahedra, row.lower_bound);
      ++result.sources[row.quads][row.source];
    }
  } else {
    result.read_from = table.path();
    for (std::size_t i = 0; i < table.size(); ++i) {
      const format::TableEntry entry = table.entry(i);
      result.add(entry.code.quads, entry.hexahedra, entry.lower_bound);
    }
  }
  for (auto& [quads, distribution] : result.by_quads)
    distribution.is_complete = quads <= table.complete_through();
  return result;
}

double mean_of(const sheet::Distribution& d) {
  return static_cast<double>(d.hexahedra()) / static_cast<double>(d.entries());
}

std::string json_line(const format::Table& table, const Statistics& statistics) {
  nlohmann::ordered_json json;
  json["file"] = table.path();
  json["sha256"] = table.sha256();
  json["read_from"] = statistics.read_from;
  json["entries"] = table.size();
  json["complete_through"] = table.complete_through();
  json["by_quads"] = nlohmann::ordered_json::object();
  for (const auto& [quads, d] : statistics.by_quads) {
    auto& row = json["by_quads"][std::to_string(quads)];
    row["entries"] = d.entries();
    if (d.is_complete)
      row["of"] = d.entries();
    else
      row["of"] = nullptr;
    row["least"] = d.meshes.begin()->first;
    row["mean"] = mean_of(d);
    row["median"] = d.median();
    row["greatest"] = d.meshes.rbegin()->first;
    row["total"] = d.hexahedra();
    row["lower_bound"] = statistics.bounds.at(quads).least;
    row["proven_smallest"] = statistics.bounds.at(quads).proven_smallest;
    row["distribution"] = nlohmann::ordered_json::object();
    for (const auto& [hexahedra, count] : d.meshes)
      row["distribution"][std::to_string(hexahedra)] = count;
    if (const auto sources = statistics.sources.find(quads); sources != statistics.sources.end())
      row["sources"] = sources->second;
  }
  return to_line(json);
}

std::string distribution_lines(const Statistics& statistics) {
  std::string text = "\nhexahedra: quadrangulations with a smallest mesh of so many found\n";
  for (const auto& [quads, d] : statistics.by_quads) {
    std::string line = fmt::format("{:>5} quads ", quads);
    for (const auto& [hexahedra, count] : d.meshes) {
      const std::string item = fmt::format(" {}:{}", hexahedra, count);
      if (line.size() + item.size() > 100) {
        text += line + "\n";
        line = std::string(12, ' ');
      }
      line += item;
    }
    text += line + "\n";
  }
  return text;
}

std::string text_of(const format::Table& table, const Statistics& statistics) {
  std::string text = fmt::format(
      "{}: {} meshes, read from {}\n\n{:>5} {:>8} {:>8} {:>6} {:>8} {:>7} {:>6} {:>6} "
      "{:>7}\n",
      table.path(), table.size(), statistics.read_from, "quads", "meshes", "of", "least", "mean",
      "median", "most", "bound", "proven");
  for (const auto& [quads, d] : statistics.by_quads)
    text +=
        fmt::format("{:>5} {:>8} {:>8} {:>6} {:>8.2f} {:>7g} {:>6} {:>6} {:>7}\n", quads,
                    d.entries(), d.is_complete ? std::to_string(d.entries()) : "?",
                    d.meshes.begin()->first, mean_of(d), d.median(), d.meshes.rbegin()->first,
                    statistics.bounds.at(quads).least, statistics.bounds.at(quads).proven_smallest);
  text += table.complete_through() == 0
              ? "of: how many there are; the table makes no claim\n"
              : fmt::format(
                    "of: how many there are, as the table claims through {} quads; "
                    "`hexatlas table check` judges it\n",
                    table.complete_through());
  text +=
      "bound: no ball of any of them has fewer hexahedra, as the table claims; proven: meshes that "
      "have as few as their own bound\n";
  text += distribution_lines(statistics);
  if (statistics.sources.empty()) return text;
  text += "\nsource: meshes found so\n";
  for (const auto& [quads, sources] : statistics.sources) {
    text += fmt::format("{:>5} quads ", quads);
    for (const auto& [source, count] : sources) text += fmt::format(" {}:{}", source, count);
    text += "\n";
  }
  return text;
}

}  // namespace

void print_by_quads(const format::Table& table, const TableInfoOptions& options) {
  const Statistics statistics = statistics_of(table);
  if (!options.svg.empty()) {
    std::vector<sheet::Distribution> panels;
    for (const auto& [quads, distribution] : statistics.by_quads) panels.push_back(distribution);
    core::write_file(options.svg, sheet::distribution_chart(
                                      panels, "Hexahedral meshes of quadrangulated spheres"));
  }
  tell(options.svg, options.json ? json_line(table, statistics) : text_of(table, statistics));
}

}  // namespace hexatlas::cli
