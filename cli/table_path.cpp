#include "cli/table_path.hpp"

#include <filesystem>
#include <system_error>

#include "enum/core/errors.hpp"

namespace hexatlas::cli {

bool is_there(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

std::string table_path(const std::string& asked_for) {
  if (!asked_for.empty()) return asked_for;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto folder = program.parent_path();
  for (const char* place : {"tables/hexatlas.hxt", "../share/hexatlas/tables/hexatlas.hxt"}) {
    std::string path = (folder / place).lexically_normal().string();
    if (is_there(path)) return path;
  }
  throw core::InvalidInput((folder / "tables/hexatlas.hxt").string(),
                           "the table that comes with the program is not there; name one "
                           "with --table, or make one with `hexatlas table build`");
}

std::optional<build::Census> census_beside(const format::Table& table) {
  const std::string path = build::census_path(table.path());
  if (!is_there(path)) return std::nullopt;
  build::Census census = build::read_census(path);
  if (census.about.table_sha256 != table.sha256())
    throw core::InvalidInput(path, "is the census of another table than " + table.path());
  return census;
}

}  // namespace hexatlas::cli
