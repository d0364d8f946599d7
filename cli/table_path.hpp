#pragma once
/// \file
/// Where tables lie, and what lies beside them.

#include <optional>
#include <string>
#include <vector>

#include "tables/build/census.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::cli {

/// Whether anything has this name, a folder too. Never throws: a name that is too long for a file,
/// or in a folder that cannot be searched, is that of nothing.
[[nodiscard]] bool is_there(const std::string& path);

/// The table to read: the one asked for, or the one that comes with the program, beside the
/// executable in tables/ or in ../share/hexatlas/tables/.
/// Throws InvalidInput if it was not asked for and is not there.
[[nodiscard]] std::string table_path(const std::string& asked_for);

/// Reads it; "-" is standard input. Throws as format::Table::open() does, too.
[[nodiscard]] format::Table open_table(const std::string& asked_for);

/// The table to read for a boundary of so many quads: the one asked for, or of those that come with
/// the program the first, or, if it does not claim to have all such boundaries, the larger one:
/// from more meshes a search makes smaller ones. Of boundaries too large for a search, the first.
/// Throws as open_table() does.
[[nodiscard]] format::Table table_for(const std::string& asked_for, std::size_t quads);

/// Each table that table_for() may read. Throws as table_path() does.
[[nodiscard]] std::vector<std::string> tables_to_read(const std::string& asked_for);

/// The same for the sectors of the linear construction.
[[nodiscard]] std::string sectors_path(const std::string& asked_for);

/// The catalogue of this name that comes with the program.
[[nodiscard]] std::string catalogue_path(const std::string& name);

/// The census beside the file of a table, if there is one. Throws InvalidInput if it is damaged or
/// the census of another table.
[[nodiscard]] std::optional<build::Census> census_beside(const format::Table& table);

}  // namespace hexatlas::cli
