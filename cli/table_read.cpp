#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/boundary_input.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/table_by_quads.hpp"
#include "cli/table_path.hpp"
#include "cli/table_write.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/flips/scars.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tables/build/named.hpp"
#include "tables/fill/filled.hpp"
#include "tables/fill/query.hpp"
#include "tables/format/manifest.hpp"

namespace hexatlas::cli {

namespace {

/// What is published about a boundary, whatever the table calls it; null if nothing is known of it.
nlohmann::ordered_json literature(const canon::Code& code) {
  const build::NamedBoundary* const named = build::boundary_with_code(canon::to_text(code));
  if (named == nullptr) return nullptr;
  return {{"hexahedra", named->literature}, {"source", named->source}};
}

std::string names_text(const format::Table& table) {
  std::string text;
  if (!table.names().empty())
    text = fmt::format("\n{:<22} {:>5} {:>9} {:>10}\n", "name", "quads", "hexahedra", "literature");
  for (const format::TableName& name : table.names()) {
    const format::TableEntry entry = table.entry(name.ordinal);
    const std::string code = canon::to_text(entry.code);
    const build::NamedBoundary* const named = build::boundary_with_code(code);
    text += fmt::format("{:<22} {:>5} {:>9} {:>10}  {}  {}\n", name.name, entry.code.quads,
                        entry.hexahedra, named == nullptr ? "?" : std::to_string(named->literature),
                        code, named == nullptr ? "" : named->source);
  }
  return text;
}

}  // namespace

ExitCode table_info(const TableInfoOptions& options) {
  if (would_lose_table(options.table, {"--svg", options.svg}, "table info")) return ExitCode::usage;
  const format::Table table = open_table(options.table);
  if (options.by_quads) {
    print_by_quads(table, options);
    return ExitCode::yes;
  }
  if (options.json) {
    nlohmann::ordered_json json;
    json["file"] = table.path();
    json["bytes"] = table.bytes();
    json["sha256"] = table.sha256();
    json["entries"] = table.size();
    json["complete_through"] = table.complete_through();
    json["by_quads"] = nlohmann::ordered_json::object();
    for (const format::Tally& t : format::tally_of(table))
      json["by_quads"][std::to_string(t.quads)] = {
          {"entries", t.entries}, {"least", t.least}, {"greatest", t.greatest}, {"total", t.total}};
    json["names"] = nlohmann::ordered_json::object();
    for (const format::TableName& name : table.names())
      json["names"][name.name] = {{"code", canon::to_text(table.entry(name.ordinal).code)},
                                  {"hexahedra", table.entry(name.ordinal).hexahedra},
                                  {"literature", literature(table.entry(name.ordinal).code)}};
    print(to_line(json));
    return ExitCode::yes;
  }
  std::string text =
      fmt::format("{}: {}, {} bytes, sha256 {}\n\n{:>5} {:>8} {:>6} {:>8} {:>6}\n", table.path(),
                  counted(table.size(), "mesh", "meshes"), table.bytes(), table.sha256(), "quads",
                  "meshes", "least", "mean", "most");
  for (const format::Tally& t : format::tally_of(table))
    text += fmt::format("{:>5} {:>8} {:>6} {:>8.2f} {:>6}\n", t.quads, t.entries, t.least,
                        static_cast<double>(t.total) / static_cast<double>(t.entries), t.greatest);
  print(text + names_text(table));
  return ExitCode::yes;
}

namespace {

canon::Code code_of_name(const std::string& name, const format::Table& table) {
  if (const auto ordinal = table.find_name(name)) return table.entry(*ordinal).code;
  std::string known;
  for (const auto& other : table.names()) known += (known.empty() ? "" : ", ") + other.name;
  throw core::InvalidInput(name, "is no name in this table; known are " + known);
}

/// Why there is no mesh, and what to try.
std::string words_without_mesh(const canon::Code& code, const std::string& table,
                               bool is_searched_for) {
  std::string words =
      fmt::format("{} ({} quads) is not in {}", canon::to_text(code), code.quads, table);
  if (code.quads > flips::kMaxSearchQuads)
    words += fmt::format(
        ", and a search takes at most {}; `hexatlas mesh hex` meshes a surface "
        "with any number",
        flips::kMaxSearchQuads);
  else if (is_searched_for)
    words += ", and no way from it to a mesh there was found";
  else
    words += "; --search looks for a mesh";
  return words;
}

}  // namespace

ExitCode table_list(const TableListOptions& options) {
  if (would_lose_table(options.table, {"--output", options.output}, "table list"))
    return ExitCode::usage;
  const format::Table table =
      options.quads == 0 ? open_table(options.table)
                         : table_for(options.table, static_cast<std::size_t>(options.quads));
  const std::string header = "code\tquads\thexahedra\tinterior_vertices\tlower_bound\n";
  std::string text = header;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const format::TableEntry entry = table.entry(i);
    if (options.quads != 0 && entry.code.quads != options.quads) continue;
    if (entry.hexahedra < static_cast<std::size_t>(options.at_least)) continue;
    text += fmt::format("{}\t{}\t{}\t{}\t{}\n", canon::to_text(entry.code), entry.code.quads,
                        entry.hexahedra, entry.interior_vertices, entry.lower_bound);
  }
  core::write_file(options.output.empty() ? "-" : options.output, text);
  if (text == header) say("note: there is no such boundary in " + table.path());
  return ExitCode::yes;
}

ExitCode table_get(const TableGetOptions& options) {
  if (would_lose_table(options.table, {"--output", options.output}, "table get"))
    return ExitCode::usage;
  std::optional<canon::Code> wanted;
  if (options.name.empty()) {
    const auto boundary = fillable_boundary_of_code(options.code);
    if (!boundary) return ExitCode::no;
    wanted = canon::from_text(boundary->code);
  } else if (const auto* named = build::named_boundary(options.name)) {
    wanted = canon::from_text(named->code);
  }
  const format::Table table =
      wanted ? table_for(options.table, wanted->quads) : open_table(options.table);
  const canon::Code code = wanted ? *wanted : code_of_name(options.name, table);
  const auto ordinal = table.find(code);
  std::optional<complex::HexComplex> mesh;
  if (ordinal) mesh = fill::mesh_in(table, *ordinal, table.path());
  if (!ordinal && options.search && code.quads <= flips::kMaxSearchQuads)
    mesh = fill::fill_through(table, code, {.threads = parallel::available_threads()});
  if (!mesh) {
    say(words_without_mesh(code, table.path(), options.search));
    return ExitCode::undecided;
  }
  nlohmann::ordered_json json;
  json["code"] = canon::to_text(code);
  json["quads"] = code.quads;
  json["hexahedra"] = mesh->hexahedra.size();
  json["interior_vertices"] = mesh->vertices - code.quads - 2U;
  json["lower_bound"] = ordinal ? table.entry(*ordinal).lower_bound : 1;
  json["literature"] = literature(code);
  json["table"] = table.path();
  json["sha256"] = table.sha256();
  json["searched"] = !ordinal;
  json["boundary"] = canon::decode(code).value().list_of_quads();
  json["cells"] = mesh->hexahedra;
  core::write_file(options.output.empty() ? "-" : options.output, to_line(json));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
