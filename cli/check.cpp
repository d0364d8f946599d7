#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "cli/check_hybrid.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/core/errors.hpp"
#include "tables/check/bound.hpp"
#include "tables/check/catalogue.hpp"
#include "tables/check/completeness.hpp"
#include "tables/check/delaunay_check.hpp"
#include "tables/check/file_bytes.hpp"
#include "tables/check/malformed.hpp"
#include "tables/check/mesh_check.hpp"
#include "tables/check/sectors.hpp"

namespace hexatlas::cli {
namespace {

std::string json_line(const check::Verdict& verdict, const check::ValidInSpace& in_space) {
  nlohmann::ordered_json json;
  json["accepted"] = verdict.accepted;
  json["undecided"] = verdict.undecided;
  json["reason"] = verdict.reason;
  json["vertices"] = verdict.vertices;
  json["interior_vertices"] = verdict.interior_vertices;
  json["edges"] = verdict.edges;
  json["quads"] = verdict.quads;
  json["hexahedra"] = verdict.hexahedra;
  json["boundary_quads"] = verdict.boundary_quads;
  json["ball_proof"] = verdict.ball_proof;
  json["valid_in_space"] = in_space.valid;
  json["undecided_in_space"] = in_space.undecided;
  return to_line(json);
}

std::string share_of(std::uint64_t some, std::uint64_t all) {
  if (some == all) return "all";
  return some == 0 ? "none" : fmt::format("only {}", some);
}

std::string sentence(const CheckOptions& options, const check::Verdict& verdict,
                     const check::ValidInSpace& in_space) {
  if (!verdict.accepted)
    return fmt::format("{}: {}: {}\n", options.mesh, verdict.undecided ? "undecided" : "rejected",
                       verdict.reason);
  return fmt::format(
      "{}: accepted: {}, {} vertices ({} interior), {} edges, {} quads, {} of them on "
      "the boundary; a ball by {}{}; {} of the hexahedra valid in space{}\n",
      options.mesh, counted(verdict.hexahedra, "hexahedron", "hexahedra"), verdict.vertices,
      verdict.interior_vertices, verdict.edges, verdict.quads, verdict.boundary_quads,
      verdict.ball_proof, options.boundary.empty() ? "" : "; its boundary is " + options.boundary,
      share_of(in_space.valid, verdict.hexahedra),
      in_space.undecided == 0 ? "" : fmt::format(", {} not decided", in_space.undecided));
}

struct NamedCounts {
  const char* condition = "";
  check::ConditionCounts counts{};
};
std::array<NamedCounts, 3> named_counts(const check::CatalogueVerdict& verdict) {
  return {{{"realizable", verdict.conditions[0]},
           {"in convex position", verdict.conditions[1]},
           {"with positive Jacobian", verdict.conditions[2]}}};
}

using Completeness = std::optional<check::CompletenessVerdict>;

bool is_accepted(const check::CatalogueVerdict& verdict, const Completeness& completeness) {
  return verdict.accepted && (!completeness || completeness->complete);
}

std::string json_line(const check::CatalogueVerdict& verdict, const Completeness& completeness) {
  nlohmann::ordered_json json;
  json["accepted"] = is_accepted(verdict, completeness);
  json["undecided"] = verdict.undecided;
  json["reason"] = completeness && verdict.accepted ? completeness->fault : verdict.reason;
  json["name"] = verdict.name;
  json["kind"] = verdict.is_cell ? "cell" : "balls";
  json["vertices"] = verdict.vertices;
  json["interior"] = verdict.interior;
  json["classes"] = verdict.classes;
  json["labelled"] = verdict.labelled;
  json["claims_exhaustive"] = verdict.claims_exhaustive;
  if (completeness) json["proven_complete"] = completeness->complete;
  for (std::size_t i = 0; i < verdict.conditions.size(); ++i)
    json[std::array{"embedded", "convex", "jacobian"}[i]] = {
        {"realizable", verdict.conditions[i].realizable},
        {"refuted", verdict.conditions[i].refuted},
        {"open", verdict.conditions[i].open}};
  return to_line(json);
}

std::string sentence(const std::string& file, const check::CatalogueVerdict& verdict) {
  if (!verdict.accepted)
    return fmt::format("{}: {}: {}\n", file, verdict.undecided ? "undecided" : "rejected",
                       verdict.reason);
  std::string text = fmt::format("{}: accepted: ", file);
  if (verdict.is_cell) {
    text += fmt::format("{} of {}", counted(verdict.classes, "class", "classes"), verdict.name);
    if (verdict.interior != 0)
      text += " with " + counted(static_cast<std::size_t>(verdict.interior), "interior vertex",
                                 "interior vertices");
    text += fmt::format(", {} labelled; {}", verdict.labelled,
                        verdict.claims_exhaustive ? "it claims that these are all"
                                                  : "it does not claim that these are all");
  } else {
    text += fmt::format("{} with {} vertices", counted(verdict.classes, "ball", "balls"),
                        verdict.vertices);
  }
  for (const auto& [condition, counts] : named_counts(verdict)) {
    if (counts.realizable + counts.refuted + counts.open == 0) continue;
    text += fmt::format("; {}: {} by coordinates, {} refuted", condition, counts.realizable,
                        counts.refuted);
    if (counts.open != 0) text += fmt::format(", {} open", counts.open);
  }
  return text + "\n";
}

template <class Verdict>
ExitCode exit_code(const Verdict& verdict) {
  if (verdict.accepted) return ExitCode::yes;
  return verdict.undecided ? ExitCode::undecided : ExitCode::no;
}

ExitCode check_one_catalogue(const CheckOptions& options, std::string_view bytes) {
  if (!options.boundary.empty()) {
    say("--boundary is for meshes; " + options.mesh + " is a catalogue");
    return ExitCode::usage;
  }
  const check::CatalogueVerdict verdict = check::check_catalogue_bytes(bytes, options.mesh);
  Completeness completeness;
  if (verdict.accepted && !options.completeness.empty())
    completeness = check::check_completeness_bytes(std::string(bytes), options.mesh,
                                                   check::bytes_of_file(options.completeness),
                                                   check::name_of_file(options.completeness));
  print(options.json ? json_line(verdict, completeness) : sentence(options.mesh, verdict));
  if (completeness && !options.json)
    print(completeness->complete
              ? fmt::format("{}: accepted: there are no other classes\n", options.completeness)
              : fmt::format("{}: rejected: {}\n", options.completeness, completeness->fault));
  return completeness && !completeness->complete ? ExitCode::no : exit_code(verdict);
}

std::string json_line(const check::BoundVerdict& verdict) {
  nlohmann::ordered_json json;
  json["accepted"] = verdict.accepted;
  json["reason"] = verdict.fault;
  json["boundary"] = verdict.code;
  json["kind"] = verdict.is_ball ? "ball" : "any";
  json["hexahedra"] = verdict.hexahedra;
  json["interior"] = verdict.interior;
  json["any_interior"] = verdict.any_interior;
  json["records"] = verdict.records;
  return to_line(json);
}

std::string sentence(const std::string& file, const check::BoundVerdict& verdict) {
  if (!verdict.accepted) return fmt::format("{}: rejected: {}\n", file, verdict.fault);
  const std::string interior =
      verdict.any_interior ? "any number of interior vertices"
                           : "at most " + counted(static_cast<std::size_t>(verdict.interior),
                                                  "interior vertex", "interior vertices");
  return fmt::format(
      "{}: accepted: {} has no {} of at most {} ({}); {}\n", file, verdict.code,
      verdict.is_ball ? "ball" : "mesh",
      counted(static_cast<std::size_t>(verdict.hexahedra), "hexahedron", "hexahedra"), interior,
      counted(verdict.records, "record", "records"));
}

/// Options that are for files of another kind; says so if there is one.
bool has_option_of_others(const CheckOptions& options, const char* kind) {
  if (options.boundary.empty() && options.completeness.empty()) return false;
  say(fmt::format("--boundary is for meshes, --completeness for catalogues; {} is {}", options.mesh,
                  kind));
  return true;
}

ExitCode check_one_bound(const CheckOptions& options, std::string_view bytes) {
  if (has_option_of_others(options, "a certificate of a lower bound")) return ExitCode::usage;
  const check::BoundVerdict verdict = check::check_bound_bytes(bytes, options.mesh);
  print(options.json ? json_line(verdict) : sentence(options.mesh, verdict));
  return verdict.accepted ? ExitCode::yes : ExitCode::no;
}

std::string json_line(const check::SectorsVerdict& verdict) {
  nlohmann::ordered_json json;
  json["accepted"] = verdict.accepted;
  json["undecided"] = verdict.undecided;
  json["reason"] = verdict.fault;
  json["sectors"] = verdict.sectors;
  json["least"] = verdict.least;
  json["least_without_scars"] = nullptr;
  json["hexahedra_per_quad"] = nullptr;
  if (verdict.accepted) {
    const std::size_t least = verdict.least_without_scars;
    json["least_without_scars"] = least;
    if (least % 2 == 0)
      json["hexahedra_per_quad"] = least / 2;
    else
      json["hexahedra_per_quad"] = static_cast<double>(least) / 2;
  }
  return to_line(json);
}

std::string sentence(const std::string& file, const check::SectorsVerdict& verdict) {
  if (!verdict.accepted)
    return fmt::format("{}: {}: {}\n", file, verdict.undecided ? "undecided" : "rejected",
                       verdict.fault);
  const std::size_t least = verdict.least_without_scars;
  std::string text = fmt::format(
      "{}: accepted: every 3-connected quadrangulation with an even number n of quads has a mesh "
      "of "
      "at most {}{} n hexahedra; {} of ",
      file, least / 2, least % 2 == 0 ? "" : ".5", counted(verdict.sectors, "sector", "sectors"));
  if (verdict.least != verdict.most) text += fmt::format("{} to ", verdict.least);
  return text + fmt::format("{} hexahedra\n", verdict.most);
}

ExitCode check_all_sectors(const CheckOptions& options, std::string_view bytes) {
  if (has_option_of_others(options, "a file of sectors")) return ExitCode::usage;
  const check::SectorsVerdict verdict = check::check_sectors_bytes(bytes, options.mesh);
  print(options.json ? json_line(verdict) : sentence(options.mesh, verdict));
  return exit_code(verdict);
}

std::string json_line(const check::DelaunayVerdict& verdict) {
  nlohmann::ordered_json json;
  json["accepted"] = verdict.accepted;
  json["law"] = check::name_of(verdict.broken);
  json["reason"] = verdict.reason;
  json["points"] = verdict.points;
  json["duplicates"] = verdict.duplicates;
  json["hidden"] = verdict.hidden;
  json["tetrahedra"] = verdict.tetrahedra;
  json["facets"] = verdict.facets;
  json["boundary_facets"] = verdict.boundary_facets;
  json["boundary_vertices"] = verdict.boundary_vertices;
  json["cospherical"] = verdict.cospherical;
  json["signs"] = {{"by_double", verdict.signs.by_double},
                   {"by_words", verdict.signs.by_words},
                   {"by_integers", verdict.signs.by_integers}};
  return to_line(json);
}

std::string sentence(const CheckOptions& options, const check::DelaunayVerdict& verdict) {
  if (!verdict.accepted)
    return fmt::format("{}: rejected: {}: {}\n", options.mesh, check::name_of(verdict.broken),
                       verdict.reason);
  return fmt::format(
      "{}: accepted: a {} triangulation, {}, {} points ({} of them duplicates{}), {} facets, {} "
      "of them on the boundary; {} interior facets between tetrahedra of one sphere{}\n",
      options.mesh, options.weights ? "regular" : "Delaunay",
      counted(verdict.tetrahedra, "tetrahedron", "tetrahedra"), verdict.points, verdict.duplicates,
      options.weights ? fmt::format(", {} hidden", verdict.hidden) : "", verdict.facets,
      verdict.boundary_facets, verdict.cospherical,
      options.points.empty() ? "" : "; its points are those of " + options.points);
}

ExitCode check_delaunay_mesh(const CheckOptions& options) {
  if (!options.boundary.empty() || !options.completeness.empty()) {
    say("--boundary and --completeness do not go with --delaunay");
    return ExitCode::usage;
  }
  const check::TetrahedralMesh mesh = check::read_tetrahedra(options.mesh);
  const auto judged = [&] {
    if (options.points.empty()) return check::check_delaunay(mesh, nullptr);
    if (options.weights)
      return check::check_regular(mesh, check::read_weighted_points(options.points));
    const std::vector<check::Point> points = check::read_points(options.points);
    return check::check_delaunay(mesh, &points);
  };
  const check::DelaunayVerdict verdict = judged();
  print(options.json ? json_line(verdict) : sentence(options, verdict));
  return verdict.accepted ? ExitCode::yes : ExitCode::no;
}

ExitCode check_one_mesh(const CheckOptions& options, std::string_view bytes) {
  if (!options.completeness.empty()) {
    say("--completeness is for catalogues; " + options.mesh + " is none");
    return ExitCode::usage;
  }
  const check::Mesh mesh = check::parse_mesh(check::name_of_file(options.mesh), bytes);
  std::optional<check::Surface> surface;
  if (!options.boundary.empty()) surface = check::read_surface(options.boundary);
  const check::Verdict verdict = check::check_mesh(mesh, surface ? &*surface : nullptr);
  const check::ValidInSpace in_space =
      verdict.accepted ? check::valid_in_space(mesh) : check::ValidInSpace{};
  print(options.json ? json_line(verdict, in_space) : sentence(options, verdict, in_space));
  if (verdict.accepted && verdict.boundary_reversed)
    say(fmt::format("note: the quads of {} face the other way than the boundary of the mesh",
                    options.boundary));
  if (verdict.accepted && verdict.boundary_unoriented)
    say(fmt::format("note: the quads of {} disagree in orientation, which was left out of account",
                    options.boundary));
  return exit_code(verdict);
}

/// What a file of the judge's is.
enum class Kind : std::uint8_t { mesh, bound, sectors, catalogue, completeness, table };

Kind kind_by_name(std::string file) {
  std::transform(file.begin(), file.end(), file.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [ending, kind] : {std::pair{".hxb", Kind::bound},
                                     {".hxs", Kind::sectors},
                                     {".hxc", Kind::catalogue},
                                     {".hxl", Kind::completeness},
                                     {".hxt", Kind::table}})
    if (file.ends_with(ending)) return kind;
  return Kind::mesh;
}

/// By the first words, whatever the name. A damaged file has lost these, so then by the name: its
/// judge knows best what is wrong with it.
Kind kind_of(const std::string& file, std::string_view bytes) {
  if (check::is_bound(bytes)) return Kind::bound;
  if (check::is_sectors(bytes)) return Kind::sectors;
  const Kind named = kind_by_name(file);
  // A frame may be a catalogue, or damaged: the name decides, if it says anything.
  const bool is_text = bytes.starts_with("hexatlas");
  if (check::is_catalogue(bytes) && (is_text || named == Kind::mesh)) return Kind::catalogue;
  return named;
}

ExitCode not_for(const std::string& option, const std::string& file) {
  say(option + " is for meshes; " + file + " is none by its name");
  return ExitCode::usage;
}

}  // namespace

ExitCode check(const CheckOptions& options) {
  try {
    if (options.delaunay || options.hybrid) {
      if (kind_by_name(options.mesh) != Kind::mesh)
        return not_for(options.hybrid ? "--hybrid" : "--delaunay", options.mesh);
      return options.hybrid ? check_hybrid_mesh(options) : check_delaunay_mesh(options);
    }
    const std::string bytes = check::bytes_of_file(options.mesh);
    switch (kind_of(options.mesh, bytes)) {
      case Kind::bound:
        return check_one_bound(options, bytes);
      case Kind::sectors:
        return check_all_sectors(options, bytes);
      case Kind::catalogue:
        return check_one_catalogue(options, bytes);
      case Kind::completeness:
        say(options.mesh +
            " is a proof of completeness: give it with --completeness, after its catalogue");
        return ExitCode::usage;
      case Kind::table:
        say(options.mesh + " is a table. See `hexatlas table check --help`.");
        return ExitCode::usage;
      case Kind::mesh:
        break;
    }
    return check_one_mesh(options, bytes);
  } catch (const check::Malformed& error) {
    say_fault(error.what());
    return ExitCode::invalid_input;
  }
}

}  // namespace hexatlas::cli
