#include "tables/check/file_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

#include "tables/check/malformed.hpp"

namespace hexatlas::check {

namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16;

/// An open file, closed at the end of the scope unless it is standard input.
class Input {
 public:
  explicit Input(const std::filesystem::path& path)
      : descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input() {
    if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

[[noreturn]] void fail_with_errno(const std::string& name) {
  throw Malformed(name, 0, std::generic_category().message(errno));
}

}  // namespace

std::string name_of_file(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

std::string bytes_of_file(const std::filesystem::path& path, std::uint64_t most) {
  const std::string name = name_of_file(path);
  const Input input(path);
  if (input.descriptor() < 0) fail_with_errno(name);
  std::string bytes;
  std::vector<char> chunk(kChunk);
  while (true) {
    const ssize_t count = ::read(input.descriptor(), chunk.data(), chunk.size());
    if (count == 0) return bytes;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_with_errno(name);
    bytes.append(chunk.data(), static_cast<std::size_t>(count));
    if (bytes.size() > most) {
      throw Malformed(name, 0, "is larger than " + std::to_string(most) + " bytes");
    }
  }
}

}  // namespace hexatlas::check
