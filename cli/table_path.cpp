#include "cli/table_path.hpp"

#include <filesystem>
#include <system_error>

#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"
#include "enum/flips/scars.hpp"

namespace hexatlas::cli {

namespace {

constexpr const char* kLarger = "hexatlas-22.hxt";

std::filesystem::path own_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::optional<std::string> shipped_if_there(const std::string& name) {
  for (const char* place : {"tables", "../share/hexatlas/tables"}) {
    std::string path = (own_folder() / place / name).lexically_normal().string();
    if (is_there(path)) return path;
  }
  return std::nullopt;
}

std::string shipped(const std::string& name, const std::string& advice) {
  if (auto path = shipped_if_there(name)) return *std::move(path);
  throw core::InvalidInput((own_folder() / "tables" / name).string(), advice);
}

}  // namespace

bool is_there(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

std::string table_path(const std::string& asked_for) {
  if (!asked_for.empty()) return asked_for;
  return shipped(
      "hexatlas.hxt",
      "the table that comes with the program is not there; name another one, as TABLE or with "
      "--table, or make one with `hexatlas table build`");
}

format::Table open_table(const std::string& asked_for) {
  const std::string path = table_path(asked_for);
  return path == "-" ? format::Table::from_bytes(core::read_file(path), "standard input")
                     : format::Table::open(path);
}

std::vector<std::string> tables_to_read(const std::string& asked_for) {
  std::vector<std::string> tables{table_path(asked_for)};
  if (asked_for.empty())
    if (auto larger = shipped_if_there(kLarger)) tables.push_back(*std::move(larger));
  return tables;
}

format::Table table_for(const std::string& asked_for, std::size_t quads) {
  format::Table table = open_table(asked_for);
  const auto has_all = [&](const format::Table& one) {
    return quads <= static_cast<std::size_t>(one.complete_through());
  };
  if (!asked_for.empty() || quads % 2 != 0 || quads > flips::kMaxSearchQuads || has_all(table))
    return table;
  const auto path = shipped_if_there(kLarger);
  return path ? format::Table::open(*path) : table;
}

std::string sectors_path(const std::string& asked_for) {
  if (!asked_for.empty()) return asked_for;
  return shipped("linear-bound.hxs",
                 "the sectors that come with the program are not there; name a file with "
                 "--sectors, or use --method table");
}

std::string catalogue_path(const std::string& name) {
  return shipped(name, "the catalogue that comes with the program is not there; install it again");
}

std::optional<build::Census> census_beside(const format::Table& table) {
  const std::string path = build::census_path(table.path());
  if (!is_there(path)) return std::nullopt;
  build::Census census = build::read_census(path);
  if (census.about.table_sha256 != table.sha256())
    throw core::InvalidInput(path, "is the census of another table than " + table.path() +
                                       "; remove it if a run that wrote both was cut off");
  return census;
}

}  // namespace hexatlas::cli
