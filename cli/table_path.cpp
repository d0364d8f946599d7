#include <filesystem>

#include "cli/commands.hpp"
#include "enum/core/errors.hpp"

namespace hexatlas::cli {

std::string table_path(const std::string& asked_for) {
  if (!asked_for.empty()) return asked_for;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto folder = program.parent_path();
  for (const char* place : {"tables/hexatlas.hxt", "../share/hexatlas/tables/hexatlas.hxt"}) {
    const auto path = (folder / place).lexically_normal();
    if (std::filesystem::exists(path, error)) return path.string();
  }
  throw core::InvalidInput((folder / "tables/hexatlas.hxt").string(),
                           "the table that comes with the program is not there; name one "
                           "with --table, or make one with `hexatlas table build`");
}

}  // namespace hexatlas::cli
