#pragma once
/// \file
/// What lies beside a table, or under the name of a file.

#include <string>

namespace hexatlas::cli {

/// Whether anything has this name, a folder too. Never throws: a name that is too long for a file,
/// or in a folder that cannot be searched, is that of nothing.
[[nodiscard]] bool is_there(const std::string& path);

}  // namespace hexatlas::cli
