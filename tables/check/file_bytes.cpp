#include "tables/check/file_bytes.hpp"

#include <fstream>
#include <iterator>
#include <system_error>

#include "tables/check/malformed.hpp"

namespace hexatlas::check {

std::string bytes_of_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || error) {
    throw Malformed(path.string(), 0, "not a file that can be read");
  }
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in || in.bad()) throw Malformed(path.string(), 0, "cannot be read");
  return bytes;
}

}  // namespace hexatlas::check
