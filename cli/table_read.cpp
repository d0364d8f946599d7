#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "tables/check/table_check.hpp"
#include "tables/format/manifest.hpp"

namespace hexatlas::cli {

ExitCode table_info(const TableInfoOptions& options) {
  const format::Table table = format::Table::open(table_path(options.table));
  if (options.json) {
    nlohmann::ordered_json json;
    json["file"] = table.path();
    json["bytes"] = table.bytes();
    json["sha256"] = table.sha256();
    json["entries"] = table.size();
    json["by_quads"] = nlohmann::ordered_json::object();
    for (const format::Tally& t : format::tally_of(table))
      json["by_quads"][std::to_string(t.quads)] = {
          {"entries", t.entries}, {"least", t.least}, {"greatest", t.greatest}, {"total", t.total}};
    json["names"] = nlohmann::ordered_json::object();
    for (const format::TableName& name : table.names())
      json["names"][name.name] = {{"code", canon::to_text(table.entry(name.ordinal).code)},
                                  {"hexahedra", table.entry(name.ordinal).hexahedra}};
    print(to_line(json));
    return ExitCode::yes;
  }
  std::string text = fmt::format(
      "{}: {} meshes, {} bytes, sha256 {}\n\n{:>5} {:>8} {:>6} {:>8} {:>6}\n", table.path(),
      table.size(), table.bytes(), table.sha256(), "quads", "meshes", "least", "mean", "most");
  for (const format::Tally& t : format::tally_of(table))
    text += fmt::format("{:>5} {:>8} {:>6} {:>8.2f} {:>6}\n", t.quads, t.entries, t.least,
                        static_cast<double>(t.total) / static_cast<double>(t.entries), t.greatest);
  text += "\n";
  for (const format::TableName& name : table.names()) {
    const format::TableEntry entry = table.entry(name.ordinal);
    text += fmt::format("{:<22} {:>3} quads {:>4} hexahedra  {}\n", name.name, entry.code.quads,
                        entry.hexahedra, canon::to_text(entry.code));
  }
  print(text);
  return ExitCode::yes;
}

namespace {

canon::Code code_of_name(const std::string& name, const format::Table& table) {
  if (const auto ordinal = table.find_name(name)) return table.entry(*ordinal).code;
  std::string known;
  for (const auto& other : table.names()) known += (known.empty() ? "" : ", ") + other.name;
  throw core::InvalidInput(name, "is no name in this table; known are " + known);
}

complex::Quadrangulation boundary_of(const std::string& word) {
  const auto code = canon::from_text(word);
  const auto boundary = code ? canon::decode(*code) : std::nullopt;
  if (!boundary)
    throw core::InvalidInput(word,
                             "is no code of a quadrangulation; `hexatlas code SURFACE` gives one");
  return *boundary;
}

/// As complex::reason_against_filling says it, for words whose graph need not be simple.
std::optional<std::string> reason_against_filling(const complex::Quadrangulation& boundary) {
  const std::vector<complex::QuadVertices> quads = boundary.list_of_quads();
  const bool is_even = quads.size() % 2 == 0;
  if (const auto law = complex::broken_law(quads); law && is_even)
    return "the boundary is not 3-connected: " + law->reason;
  complex::QuadSphere sphere;
  for (const auto& quad : quads) sphere.quads.push_back({quad[0], quad[1], quad[2], quad[3]});
  for (int v = 0; v < boundary.vertices(); ++v)
    sphere.point_of.push_back(static_cast<complex::VertexId>(v));
  return complex::reason_against_filling(sphere);
}

void expect_canonical(const std::string& word, const complex::Quadrangulation& boundary) {
  const std::string code = canon::to_text(canon::canonical_form(boundary).code);
  if (word != code)
    throw core::InvalidInput(word, "is not canonical; the code of this boundary is " + code);
}

}  // namespace

ExitCode table_get(const TableGetOptions& options) {
  const format::Table table = format::Table::open(table_path(options.table));
  if (options.name.empty()) {
    const complex::Quadrangulation boundary = boundary_of(options.code);
    if (const auto reason = reason_against_filling(boundary)) {
      say(fmt::format("{}: no hexahedral mesh exists: {}", options.code, *reason));
      return ExitCode::no;
    }
    expect_canonical(options.code, boundary);
  }
  const canon::Code code = options.name.empty() ? canon::from_text(options.code).value()
                                                : code_of_name(options.name, table);
  const auto ordinal = table.find(code);
  if (!ordinal) {
    say(fmt::format("{} ({} quads) is not in {}", canon::to_text(code), code.quads, table.path()));
    return ExitCode::undecided;
  }
  const format::TableEntry entry = table.entry(*ordinal);
  const complex::HexComplex mesh = table.mesh(*ordinal);
  nlohmann::ordered_json json;
  json["code"] = canon::to_text(code);
  json["quads"] = entry.code.quads;
  json["hexahedra"] = entry.hexahedra;
  json["interior_vertices"] = entry.interior_vertices;
  json["lower_bound"] = entry.lower_bound;
  json["boundary"] = canon::decode(code).value().list_of_quads();
  json["cells"] = mesh.hexahedra;
  core::write_file(options.output.empty() ? "-" : options.output, to_line(json));
  return ExitCode::yes;
}

ExitCode table_check(const TableCheckOptions& options) {
  const std::string path = table_path(options.table);
  const std::string bytes = core::read_file(path);
  const check::TableVerdict verdict = check::check_table_bytes(bytes);
  if (!verdict.accepted) {
    print(fmt::format("{}: rejected: {}\n", path, verdict.reason));
    return ExitCode::no;
  }
  const std::string manifest = format::manifest_path(path);
  std::string said = "no manifest beside it";
  std::error_code error;  // a name that is too long for a file is that of none
  if (std::filesystem::exists(manifest, error)) {
    const format::ManifestClaims claims = format::read_manifest(manifest);
    const format::Table table = format::Table::from_bytes(bytes, path);
    const std::string told =
        format::manifest_text(table, {claims.command, claims.seed, claims.program, claims.commit});
    if (core::read_file(manifest) != told) {
      print(fmt::format("{}: rejected: it is not as its manifest {} says\n", path, manifest));
      return ExitCode::no;
    }
    said = "as its manifest says";
  }
  std::uint64_t hexahedra = 0;
  for (const check::TableRow& row : verdict.by_quads) hexahedra += row.total_hexahedra;
  print(fmt::format("{}: accepted: {} meshes with {} hexahedra, {} names; {}\n", path,
                    verdict.entries, hexahedra, verdict.names, said));
  return ExitCode::yes;
}

}  // namespace hexatlas::cli
