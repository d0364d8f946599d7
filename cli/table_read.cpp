#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output.hpp"
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

canon::Code wanted_code(const TableGetOptions& options, const format::Table& table) {
  if (!options.name.empty()) {
    if (const auto ordinal = table.find_name(options.name)) return table.entry(*ordinal).code;
    std::string known;
    for (const auto& name : table.names()) known += (known.empty() ? "" : ", ") + name.name;
    throw core::InvalidInput(options.name, "is no name in this table; known are " + known);
  }
  const auto code = canon::from_text(options.code);
  if (!code || !canon::decode(*code))
    throw core::InvalidInput(options.code,
                             "is no code of a quadrangulation; `hexatlas code SURFACE` gives one");
  return canon::canonical_form(*canon::decode(*code)).code;
}

}  // namespace

ExitCode table_get(const TableGetOptions& options) {
  const format::Table table = format::Table::open(table_path(options.table));
  const canon::Code code = wanted_code(options, table);
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
  if (std::filesystem::exists(manifest)) {
    const format::ManifestClaims claims = format::read_manifest(manifest);
    const format::Table table = format::Table::from_bytes(bytes, path);
    if (claims.sha256 != table.sha256() || claims.bytes != table.bytes() ||
        claims.entries != table.size()) {
      print(fmt::format("{}: rejected: its manifest {} describes another file\n", path, manifest));
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
