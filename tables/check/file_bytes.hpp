#pragma once
/// \file
/// Internal to the judge: a whole file in memory.
///
/// Errors: Malformed with the reason of the system (no such file, a directory, no permission), or
/// if there is more than is allowed. Cost: linear; a pipe is read until its writers close it.

#include <cstdint>
#include <filesystem>
#include <string>

namespace hexatlas::check {

inline constexpr std::uint64_t kMostFileBytes = std::uint64_t{4} << 30;

/// How messages name what bytes_of_file reads: the path, or "standard input" for "-".
[[nodiscard]] std::string name_of_file(const std::filesystem::path& path);

/// The bytes of a file, pipe or device, or of standard input for "-".
[[nodiscard]] std::string bytes_of_file(const std::filesystem::path& path,
                                        std::uint64_t most = kMostFileBytes);

}  // namespace hexatlas::check
