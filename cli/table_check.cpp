#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "tables/build/census.hpp"
#include "tables/build/named.hpp"
#include "tables/check/table_check.hpp"
#include "tables/format/manifest.hpp"

namespace hexatlas::cli {
namespace {

/// What was found, and the first reason to reject the table.
struct Findings {
  check::TableVerdict verdict;
  std::string reason;
  bool has_manifest = false, has_census = false;
};

std::string fault_of_manifest(const format::Table& table, const std::string& path) {
  const format::ManifestClaims claims = format::read_manifest(path);
  const std::string told =
      format::manifest_text(table, {claims.command, claims.seed, claims.program, claims.commit});
  return core::read_file(path) == told ? "" : "it is not as its manifest " + path + " says";
}

/// `source` and `found` are only claimed; all else follows from the entries.
std::string fault_of_census(const format::Table& table, const std::string& path) {
  const build::Census census = build::read_census(path);
  const std::string fault = "it is not as its census " + path + " says: ";
  if (census.about.table_sha256 != table.sha256()) return fault + "that has another SHA-256";
  if (census.rows.size() != table.size())
    return fault + "that has " + counted(census.rows.size(), "row", "rows");
  for (const build::CensusRow& row : census.rows) {
    const auto code = canon::from_text(row.code);
    const auto ordinal = code ? table.find(*code) : std::nullopt;
    if (!ordinal) return fault + row.code + " is not in the table";
    if (build::census_row(table.entry(*ordinal), row.source, row.found) != row)
      return fault + "entry " + std::to_string(*ordinal) + " has other numbers";
  }
  return "";
}

/// The names that everybody knows are those of their boundaries.
std::string fault_of_names(const format::Table& table) {
  for (const format::TableName& name : table.names()) {
    const build::NamedBoundary* const named = build::named_boundary(name.name);
    const std::string code = canon::to_text(table.entry(name.ordinal).code);
    if (named != nullptr && named->code != code)
      return fmt::format("{} is the name of {}, not of {}", name.name, named->code, code);
  }
  return "";
}

std::string fault_of_completeness(const check::TableVerdict& verdict, int asked_for) {
  const auto wanted = static_cast<std::uint32_t>(asked_for - asked_for % 2);
  if (wanted <= verdict.complete_through) return "";
  if (verdict.complete_through == 0)
    return "it is not complete through " + std::to_string(wanted) + " quads";
  return fmt::format("it is complete through {} quads, not {}", verdict.complete_through, wanted);
}

Findings findings_of(const std::string& path, const TableCheckOptions& options) {
  const std::string bytes = core::read_file(path);
  const quads::Shard shard = shard_from(options.shard).value_or(quads::Shard{});
  Findings found;
  found.verdict = check::check_table_bytes(bytes, {shard.part, shard.parts});
  found.reason = found.verdict.reason;
  if (!found.reason.empty()) return found;
  const format::Table table = format::Table::from_bytes(bytes, path);
  const std::string manifest = format::manifest_path(path);
  const std::string census = build::census_path(path);
  found.has_manifest = is_there(manifest);
  found.has_census = is_there(census);
  found.reason = fault_of_names(table);
  try {
    if (found.has_manifest && found.reason.empty())
      found.reason = fault_of_manifest(table, manifest);
    if (found.has_census && found.reason.empty()) found.reason = fault_of_census(table, census);
  } catch (const core::InvalidInput& damaged) {
    found.reason = std::string("beside it, ") + damaged.what();
  }
  if (found.reason.empty())
    found.reason = fault_of_completeness(found.verdict, options.complete_through);
  return found;
}

std::uint64_t hexahedra_of(const check::TableVerdict& verdict) {
  std::uint64_t sum = 0;
  for (const check::TableRow& row : verdict.by_quads) sum += row.total_hexahedra;
  return sum;
}

/// "6, 8, 10", or with more than five numbers "6, 8, ..., 20".
std::string listed_even(std::uint32_t last) {
  std::string text;
  for (std::uint32_t n = 6; n <= last; n += 2) {
    const bool left_out = last > 14 && n > 8 && n < last;
    if (left_out && n > 10) continue;
    text += (n > 6 ? ", " : "") + (left_out ? "..." : std::to_string(n));
  }
  return text;
}

std::string text_of_files_beside(const Findings& found) {
  return std::string(found.has_manifest ? "; as its manifest says" : "; no manifest beside it") +
         (found.has_census ? "; as its census says" : "; no census beside it");
}

std::string completeness_text(const check::TableVerdict& verdict) {
  std::string text;
  if (verdict.complete_through > 0)
    text += "complete: all 3-connected quadrangulations with " +
            listed_even(verdict.complete_through) + " quads\n";
  for (const check::TableRow& row : verdict.by_quads) {
    if (row.quads <= verdict.complete_through) continue;
    text += fmt::format("{} quads: {}", row.quads, counted(row.entries, "entry", "entries"));
    if (row.rooted_all > 0)
      text += fmt::format(", rooted sum {} of {}, {}", row.rooted_sum, row.rooted_all,
                          row.is_complete() ? "complete" : "not complete");
    text += "\n";
  }
  if (verdict.claimed_bounds > 0)
    text += fmt::format("{}: a claim that nothing here proves\n",
                        counted(verdict.claimed_bounds, "lower bound", "lower bounds"));
  return text + (verdict.claimed_through == 0
                     ? "it makes no claim to be complete\n"
                     : fmt::format("it claims to be complete through {} quads\n",
                                   verdict.claimed_through));
}

std::string accepted_text(const check::TableVerdict& verdict, const std::string& shard) {
  if (shard.empty()) return "accepted";
  return fmt::format("share {} accepted, {} of {} meshes judged", shard, verdict.judged_meshes,
                     verdict.entries);
}

std::string json_line(const std::string& path, const std::string& shard, const Findings& found) {
  nlohmann::ordered_json json;
  json["file"] = path;
  json["accepted"] = found.reason.empty();
  json["reason"] = found.reason;
  if (!shard.empty()) json["shard"] = shard;
  json["entries"] = found.verdict.entries;
  json["judged_meshes"] = found.verdict.judged_meshes;
  json["hexahedra"] = hexahedra_of(found.verdict);
  json["names"] = found.verdict.names;
  json["claimed_through"] = found.verdict.claimed_through;
  json["complete_through"] = found.verdict.complete_through;
  json["claimed_bounds"] = found.verdict.claimed_bounds;
  json["by_quads"] = nlohmann::ordered_json::object();
  for (const check::TableRow& row : found.verdict.by_quads)
    json["by_quads"][std::to_string(row.quads)] = {{"entries", row.entries},
                                                   {"least", row.least_hexahedra},
                                                   {"greatest", row.greatest_hexahedra},
                                                   {"total", row.total_hexahedra},
                                                   {"rooted_sum", row.rooted_sum},
                                                   {"rooted_all", row.rooted_all},
                                                   {"complete", row.is_complete()}};
  json["manifest"] = found.has_manifest;
  json["census"] = found.has_census;
  return to_line(json);
}

}  // namespace

ExitCode table_check(const TableCheckOptions& options) {
  const std::string path = table_path(options.table);
  const Findings found = findings_of(path, options);
  const bool accepted = found.reason.empty();
  if (options.json) {
    print(json_line(path, options.shard, found));
  } else if (!accepted) {
    print(fmt::format("{}: rejected: {}\n", path, found.reason));
  } else {
    print(fmt::format(
        "{}: {}: {} with {}, {}{}\n{}", path, accepted_text(found.verdict, options.shard),
        counted(found.verdict.entries, "mesh", "meshes"),
        counted(hexahedra_of(found.verdict), "hexahedron", "hexahedra"),
        counted(found.verdict.names, "name", "names"),
        path == "-" ? "" : text_of_files_beside(found), completeness_text(found.verdict)));
  }
  return accepted ? ExitCode::yes : ExitCode::no;
}

}  // namespace hexatlas::cli
