#include "cli/hybrid_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"

namespace hexatlas::cli {
namespace {

nlohmann::ordered_json by_shape(const std::array<std::size_t, hybrid::kShapes>& counts) {
  nlohmann::ordered_json json;
  json["hexahedra"] = counts[0];
  json["prisms"] = counts[1];
  json["pyramids"] = counts[2];
  return json;
}

/// value(report) for the cells of each shape.
template <class Value>
nlohmann::ordered_json of_each(const quality::HybridReport& report, const Value& value) {
  nlohmann::ordered_json json;
  json["hexahedra"] = value(report.hexahedra);
  json["prisms"] = value(report.prisms);
  json["pyramids"] = value(report.pyramids);
  json["tetrahedra"] = value(report.tetrahedra);
  return json;
}

double volume_of(const quality::HybridReport& report) {
  return report.hexahedra.volume + report.prisms.volume + report.pyramids.volume +
         report.tetrahedra.volume;
}

void add_mesh(nlohmann::ordered_json& json, const HybridAccount& account) {
  const hybrid::Combined& combined = *account.combined;
  const double whole = volume_of(account.report);
  json["selected"] = of_each(account.report, [](const auto& r) { return r.cells; });
  json["volume_fraction"] =
      of_each(account.report, [&](const auto& r) { return r.volume / whole; });
  json["min_scaled_jacobian"] =
      of_each(account.report, [](const auto& r) -> nlohmann::ordered_json {
        if (r.cells == 0) return nullptr;
        return r.min_scaled_jacobian;
      });
  json["conforming"] = combined.quads_on_triangles == 0;
  json["quads_on_triangles"] = combined.quads_on_triangles;
  json["given_up"] = combined.given_up;
  json["inserted_pyramids"] = combined.inserted_pyramids;
  json["new_points"] = combined.new_points;
  json["points_inside_cells"] = account.points_inside_cells;
}

void add_lattice(nlohmann::ordered_json& json, const LatticeAccount& lattice) {
  json["lattice"] = {{"points", lattice.points},
                     {"spacing", lattice.spacing},
                     {"added_on_surface", lattice.added_on_surface},
                     {"exchanged_diagonals", lattice.exchanged_diagonals}};
}

std::string classes_line(const std::vector<std::size_t>& counts) {
  std::size_t classes = 0;
  std::size_t most = 0;
  std::size_t greatest = 0;
  for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
    if (counts[i] > 0) ++classes;
    if (counts[i] > most) {
      most = counts[i];
      greatest = i + 1;
    }
  }
  if (classes == 0) return "";
  return fmt::format("{} of the {} subdivisions of the hexahedron; most often class {}, {} times\n",
                     classes, counts.size() - 1, greatest, most);
}

template <std::size_t N>
void append(std::string& text, char letter, const hybrid::CandidateList<N>& list) {
  for (std::size_t i = 0; i < list.cells.size(); ++i) {
    const auto& cell = list.cells[i];
    text += letter;
    for (const auto v : cell.vertices) fmt::format_to(std::back_inserter(text), " {}", v);
    fmt::format_to(std::back_inserter(text), " {:.6f} {} {}", cell.quality, cell.inner, cell.flat);
    for (const auto t : list.all(i)) fmt::format_to(std::back_inserter(text), " {}", t);
    text += '\n';
  }
}

}  // namespace

std::string json_line(const HybridAccount& account) {
  nlohmann::ordered_json json;
  if (account.lattice) add_lattice(json, *account.lattice);
  json["tetrahedra"] = account.tetrahedra;
  json["quality"] = account.quality;
  json["candidates"] = by_shape(account.candidates);
  json["undecided"] = account.undecided;
  nlohmann::ordered_json classes = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i + 1 < account.classes.size(); ++i)
    if (account.classes[i] > 0) classes[std::to_string(i + 1)] = account.classes[i];
  json["classes"] = classes;
  json["without_class"] = account.classes.empty() ? 0 : account.classes.back();
  if (account.combined) add_mesh(json, account);
  json["search_seconds"] = account.search_seconds;
  json["seconds"] = account.seconds;
  json["threads"] = account.threads;
  return to_line(json);
}

/// What the tetrahedra are made of, and what was done to the surface given.
std::string lattice_line(const LatticeAccount& lattice) {
  return fmt::format(
      "lattice: {} inside, {:.4g} apart; the surface has {} more, and flat parts of it other "
      "diagonals, by {}\n",
      counted(lattice.points, "point", "points"), lattice.spacing,
      counted(lattice.added_on_surface, "point", "points"),
      counted(lattice.exchanged_diagonals, "exchange", "exchanges"));
}

/// Where tetrahedra around a vertex make up one cell, it has none.
std::string inside_line(std::size_t points) {
  if (points == 0) return "";
  return fmt::format("{} inside a cell, of no cell themselves\n",
                     counted(points, "point of the tetrahedra is", "points of the tetrahedra are"));
}

std::string summary(const HybridAccount& account, const std::string& output) {
  std::string text = account.lattice ? lattice_line(*account.lattice) : "";
  text += fmt::format("{} of {}: {}, {}, {} of quality above {}, in {:.2f} seconds with {}\n",
                      output.empty() ? "candidates" : output,
                      counted(account.tetrahedra, "tetrahedron", "tetrahedra"),
                      counted(account.candidates[0], "hexahedron", "hexahedra"),
                      counted(account.candidates[1], "prism", "prisms"),
                      counted(account.candidates[2], "pyramid", "pyramids"), account.quality,
                      account.search_seconds,
                      counted(static_cast<std::size_t>(account.threads), "thread", "threads"));
  if (account.undecided > 0)
    text += fmt::format("{} left out, not decided to be valid or not\n",
                        counted(account.undecided, "hexahedron", "hexahedra"));
  text += classes_line(account.classes);
  if (!account.combined) return text;
  const hybrid::Combined& combined = *account.combined;
  const quality::HybridReport& report = account.report;
  const double whole = volume_of(report) / 100;
  const auto line = [&](const quality::Report& r, const char* one, const char* many) {
    if (r.cells == 0) return fmt::format("no {}\n", many);
    const double percent = r.volume / whole;  // of coordinates near the limits not a number
    return fmt::format(
        "{}, {} of the volume, least scaled Jacobian {:.3f}\n", counted(r.cells, one, many),
        std::isfinite(percent) ? fmt::format("{:.1f} %", percent) : "an unknown part",
        r.min_scaled_jacobian);
  };
  text += line(report.hexahedra, "hexahedron", "hexahedra") +
          line(report.prisms, "prism", "prisms") + line(report.pyramids, "pyramid", "pyramids") +
          line(report.tetrahedra, "tetrahedron", "tetrahedra") +
          inside_line(account.points_inside_cells);
  if (combined.quads_on_triangles > 0)
    return text + fmt::format("not conforming: {} two triangles of tetrahedra\n",
                              counted(combined.quads_on_triangles, "quad meets", "quads meet"));
  return text + fmt::format("conforming; {} put between quads and tetrahedra, {}, {} given up\n",
                            counted(combined.inserted_pyramids, "pyramid", "pyramids"),
                            counted(combined.new_points, "new point", "new points"),
                            counted(combined.given_up, "cell", "cells"));
}

std::string candidates_text(const hybrid::Candidates& candidates, double quality) {
  std::string text =
      fmt::format("candidates 1 {} {} {} {}\n", quality, candidates.hexahedra.cells.size(),
                  candidates.prisms.cells.size(), candidates.pyramids.cells.size());
  append(text, 'h', candidates.hexahedra);
  append(text, 'p', candidates.prisms);
  append(text, 'y', candidates.pyramids);
  return text;
}

}  // namespace hexatlas::cli
