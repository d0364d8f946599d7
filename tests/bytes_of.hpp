#pragma once
/// \file
/// What is in a file, read in one piece.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace hexatlas::support {

[[nodiscard]] inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

}  // namespace hexatlas::support
