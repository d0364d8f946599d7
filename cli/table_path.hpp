#pragma once
/// \file
/// Where tables lie, and whether a file is there.

#include <string>

namespace hexatlas::cli {

/// Whether anything has this name, a folder too. Never throws: a name that is too long for a file,
/// or in a folder that cannot be searched, is that of nothing.
[[nodiscard]] bool is_there(const std::string& path);

/// The table to read: the one asked for, or the one that comes with the program, beside the
/// executable in tables/ or in ../share/hexatlas/tables/.
/// Throws InvalidInput if it was not asked for and is not there.
[[nodiscard]] std::string table_path(const std::string& asked_for);

}  // namespace hexatlas::cli
