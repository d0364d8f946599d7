#pragma once
/// \file
/// A table on its way to a file, with what lies beside it: the manifest and the census.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::cli {

/// The table and what lies beside it: its manifest and its census.
[[nodiscard]] std::array<std::string, 3> table_files(const std::string& path);

/// Whether the output would take the place of a table to read (tables_to_read() of `asked_for`) or
/// of what lies beside it; says so.
[[nodiscard]] bool would_lose_table(const std::string& asked_for, const NamedFile& output,
                                    const char* verb);

/// Before long work: throws what writing one of the three files would throw.
void expect_table_writable(const std::string& path);

/// The rows of a table that is to be written. `names` and `complete_through` as for
/// format::table_bytes().
struct NewTable {
  std::vector<format::TableRow> rows;
  std::vector<format::TableRowName> names;
  int complete_through = 0;
};
/// How a mesh was found, and when.
struct Found {
  std::string source, date;
};
struct Making {
  std::string command;  ///< that makes the table
  std::uint64_t seed = 0;
  std::map<canon::Code, Found> found;  ///< of each row
};

/// How the meshes of a table were found, according to the census beside it, if there is one.
[[nodiscard]] std::map<canon::Code, Found> found_in_census(const format::Table& table);

/// Writes the three files, of which none takes its place before all are on disk, so that a kill
/// hardly ever parts them. The table took the time: it stays where the others cannot be written.
format::Table write_table(const std::string& path, const NewTable& made, const Making& making);

/// The date of what is found now: that of SOURCE_DATE_EPOCH, for builds that are to be the same on
/// any day, or today. Throws InvalidInput if that is no such number; to be asked before long work.
[[nodiscard]] std::string today();

}  // namespace hexatlas::cli
