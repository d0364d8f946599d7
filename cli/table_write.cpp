#include "cli/table_write.hpp"

#include <fmt/chrono.h>

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string_view>
#include <system_error>

#include "cli/table_path.hpp"
#include "enum/core/errors.hpp"
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

bool would_lose_table(const std::string& asked_for, const NamedFile& output, const char* verb) {
  if (output.second.empty() || output.second == "-") return false;
  static constexpr std::array<const char*, 3> kWhat{"the table", "its manifest", "its census"};
  for (const std::string& table : tables_to_read(asked_for)) {
    const auto files = table_files(table);
    for (std::size_t i = 0; i < files.size(); ++i)
      if (const auto same = same_files({kWhat[i], files[i]}, {output})) {
        say(fmt::format("{}. See `hexatlas {} --help`.", *same, verb));
        return true;
      }
  }
  return false;
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
  core::PendingFile file(path, bytes);
  try {
    core::PendingFile manifest(
        format::manifest_path(path),
        format::manifest_text(
            table, {making.command, making.seed, "hexatlas " + version(), HEXATLAS_COMMIT}));
    const std::string census = build::census_path(path);
    core::PendingFile rows(census, build::census_bytes(census, census_of(table, making)));
    file.place();
    manifest.place();
    rows.place();
  } catch (const std::exception&) {
    file.place();  // unless it is there already
    say("the table " + path + " was written, its manifest or its census was not");
    throw;
  }
  return table;
}

std::string today() {
  std::time_t now = std::time(nullptr);
  if (const char* const epoch = std::getenv("SOURCE_DATE_EPOCH"); epoch != nullptr && *epoch != 0) {
    constexpr std::time_t kLast = 253'402'300'799;  // of the year 9999
    const std::string_view word(epoch);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), now);
    if (error != std::errc() || end != word.data() + word.size() || now < 0 || now > kLast)
      throw core::InvalidInput("SOURCE_DATE_EPOCH",
                               "is no number of seconds from 0 to " + std::to_string(kLast));
  }
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

}  // namespace hexatlas::cli
