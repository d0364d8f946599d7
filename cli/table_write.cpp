#include "cli/table_write.hpp"

#include <fmt/chrono.h>

#include <cstdlib>
#include <ctime>
#include <exception>

#include "cli/output.hpp"
#include "cli/table_path.hpp"
#include "enum/core/files.hpp"
#include "tables/format/manifest.hpp"

namespace hexatlas::cli {
namespace {

build::Census census_of(const format::Table& table, const Making& making) {
  build::Census census{{table.sha256(), "hexatlas " + version(), HEXATLAS_COMMIT}, {}};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const format::TableEntry entry = table.entry(i);
    const Found& found = making.found.at(entry.code);
    census.rows.push_back(build::census_row(entry, found.source, found.date));
  }
  return census;
}

}  // namespace

std::array<std::string, 3> table_files(const std::string& path) {
  return {path, format::manifest_path(path), build::census_path(path)};
}

void expect_table_writable(const std::string& path) {
  for (const std::string& file : table_files(path)) core::expect_writable(file);
}

std::map<canon::Code, Found> found_in_census(const format::Table& table) {
  std::map<canon::Code, Found> result;
  if (const auto census = census_beside(table))
    for (const build::CensusRow& row : census->rows)
      if (const auto code = canon::from_text(row.code)) result[*code] = {row.source, row.found};
  return result;
}

format::Table write_table(const std::string& path, const NewTable& made, const Making& making) {
  const std::string bytes = format::table_bytes(made.rows, made.names, made.complete_through);
  format::Table table = format::Table::from_bytes(bytes, path);
  core::write_file(path, bytes);
  try {
    core::write_file(format::manifest_path(path),
                     format::manifest_text(table, {making.command, making.seed,
                                                   "hexatlas " + version(), HEXATLAS_COMMIT}));
    build::write_census(build::census_path(path), census_of(table, making));
  } catch (const std::exception&) {
    say("the table " + path + " was written, its manifest or its census was not");
    throw;
  }
  return table;
}

std::string today() {
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) now = std::atoll(epoch);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

}  // namespace hexatlas::cli
