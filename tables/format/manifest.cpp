#include "tables/format/manifest.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"

namespace hexatlas::format {

std::vector<Tally> tally_of(const Table& table) {
  std::vector<Tally> result;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const TableEntry entry = table.entry(i);
    if (result.empty() || result.back().quads != entry.code.quads)
      result.push_back({entry.code.quads, 0, entry.hexahedra, entry.hexahedra, 0});
    Tally& tally = result.back();
    ++tally.entries;
    tally.least = std::min<std::size_t>(tally.least, entry.hexahedra);
    tally.greatest = std::max<std::size_t>(tally.greatest, entry.hexahedra);
    tally.total += entry.hexahedra;
  }
  return result;
}

std::string manifest_path(const std::string& table_path) {
  return std::filesystem::path(table_path).replace_extension(".manifest.json").string();
}

std::string manifest_text(const Table& table, const Provenance& provenance) {
  nlohmann::ordered_json json;
  json["format"] = "hexatlas table " + std::to_string(kTableVersion);
  json["file"] = std::filesystem::path(table.path()).filename().string();
  json["bytes"] = table.bytes();
  json["sha256"] = table.sha256();
  json["entries"] = table.size();
  json["complete_through"] = table.complete_through();
  json["by_quads"] = nlohmann::ordered_json::object();
  for (const Tally& tally : tally_of(table))
    json["by_quads"][std::to_string(tally.quads)] = {{"entries", tally.entries},
                                                     {"least", tally.least},
                                                     {"greatest", tally.greatest},
                                                     {"total", tally.total}};
  json["names"] = nlohmann::ordered_json::object();
  for (const TableName& name : table.names())
    json["names"][name.name] = canon::to_text(table.entry(name.ordinal).code);
  json["command"] = provenance.command;
  json["seed"] = provenance.seed;
  json["program"] = provenance.program;
  json["commit"] = provenance.commit;
  // A command line may hold bytes that are not UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

ManifestClaims read_manifest(const std::string& path) {
  const auto json = nlohmann::json::parse(core::read_file(path), nullptr, false);
  try {
    if (!json.is_discarded())
      return {json.at("sha256"), json.at("bytes"),   json.at("entries"), json.at("command"),
              json.at("seed"),   json.at("program"), json.at("commit")};
  } catch (const nlohmann::json::exception&) {
    throw core::InvalidInput(path, "is not a manifest: a key is missing or of another type");
  }
  throw core::InvalidInput(path, "is not a manifest: it is not JSON");
}

}  // namespace hexatlas::format
