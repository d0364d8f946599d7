#pragma once
/// \file
/// Internal to the judge: a whole file in memory.

#include <filesystem>
#include <string>

namespace hexatlas::check {

/// Errors: Malformed if the path is not a regular file that can be read.
[[nodiscard]] std::string bytes_of_file(const std::filesystem::path& path);

}  // namespace hexatlas::check
