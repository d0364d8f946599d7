#pragma once
/// \file
/// `table info --by quads`: how many hexahedra the meshes of a table have.

#include "cli/commands.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::cli {

/// Prints the tables, or JSON, and writes the chart if one is asked for. The numbers are those of
/// the census beside the table if there is one. Throws InvalidInput if that is of another table.
void print_by_quads(const format::Table& table, const TableInfoOptions& options);

}  // namespace hexatlas::cli
