#include "enum/core/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <vector>

#include "enum/core/errors.hpp"

namespace hexatlas::core {
namespace {

std::string system_message() { return std::strerror(errno); }

/// Owns a file descriptor; closes it at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ > STDERR_FILENO) ::close(value_);
  }
  [[nodiscard]] int get() const noexcept { return value_; }

 private:
  int value_;
};

/// `expected`: how many bytes there will be if nobody writes meanwhile; 0 if unknown.
std::string read_all(int fd, const std::string& name, std::uint64_t most,
                     std::uint64_t expected = 0) {
  const std::string too_large = "is larger than " + std::to_string(most >> 30U) + " GiB";
  if (expected > most) throw InvalidInput(name, too_large);
  std::string bytes;
  bytes.reserve(expected);
  std::vector<char> buffer(std::size_t{1} << 16U);
  while (true) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InvalidInput(name, "cannot be read: " + system_message());
    if (got == 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(got));
    if (bytes.size() > most) throw InvalidInput(name, too_large);
  }
}

void write_all(int fd, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) throw ResourceFailure(name + ": cannot be written: " + system_message());
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

void flush_folder(const std::filesystem::path& folder) {
  const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) ::fsync(fd.get());
}

/// The mode of a file that is replaced, or that of a new file.
mode_t mode_for(const std::filesystem::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// Whether the rights of this process allow it; errno says why not.
bool allows(const std::filesystem::path& path, int access) {
  return ::faccessat(AT_FDCWD, path.c_str(), access, AT_EACCESS) == 0;
}

/// Requires that nothing is there, which a link to nothing also looks like.
void expect_no_link(const std::string& path) {
  std::error_code unknown;  // then who creates the file finds out
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(path, unknown)))
    throw InvalidInput(path, "is a link to something that does not exist");
}

using Produce = std::function<void(const Sink&)>;

void write_parts(int fd, const Produce& produce, const std::string& name) {
  produce([&](std::string_view bytes) { write_all(fd, bytes, name); });
}

/// The name of the file with what is to take the place of `target`.
std::string file_beside(const std::filesystem::path& target, const Produce& produce) {
  std::string temporary = (folder_of(target) / ".hexatlas.XXXXXX").string();
  const Descriptor fd(::mkostemp(temporary.data(), O_CLOEXEC));
  if (fd.get() < 0) {
    const bool is_full = errno == ENOSPC || errno == EDQUOT || errno == EMFILE || errno == ENFILE;
    const std::string message = "cannot be created: " + system_message();
    if (is_full) throw ResourceFailure(target.string() + ": " + message);
    throw InvalidInput(target.string(), message);
  }
  try {
    write_parts(fd.get(), produce, target.string());
    if (::fchmod(fd.get(), mode_for(target)) != 0 || ::fsync(fd.get()) != 0)
      throw ResourceFailure(target.string() + ": cannot be written: " + system_message());
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  return temporary;
}

/// The file that renaming would replace; none if the bytes go to what is there.
std::optional<std::filesystem::path> to_replace(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    expect_no_link(path);
    return path;
  }
  if (S_ISDIR(status.st_mode)) throw InvalidInput(path, "is a directory");
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  if (!allows(path, W_OK)) throw InvalidInput(path, "cannot be written: " + system_message());
  std::error_code error;  // it may have gone since
  std::filesystem::path target = std::filesystem::canonical(path, error);
  if (error) throw InvalidInput(path, "cannot be replaced: " + error.message());
  return target;
}

enum class Devices : bool { no, yes };

std::string read_from(int fd, const std::string& name, std::uint64_t most, Devices devices) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) throw InvalidInput(name, "cannot be read: " + system_message());
  if (S_ISDIR(status.st_mode)) throw InvalidInput(name, "is a directory");
  if (devices == Devices::no && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)))
    throw InvalidInput(name, "is a device");
  const bool has_size = S_ISREG(status.st_mode) && status.st_size > 0;
  return read_all(fd, name, most, has_size ? static_cast<std::uint64_t>(status.st_size) : 0);
}

std::string read_from(const std::string& path, std::uint64_t most, Devices devices) {
  if (path == "-") return read_from(STDIN_FILENO, "standard input", most, devices);
  const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (fd.get() < 0) throw InvalidInput(path, "cannot be opened: " + system_message());
  return read_from(fd.get(), path, most, devices);
}

}  // namespace

std::string read_file(const std::string& path) {
  return read_from(path, kMaxFileBytes, Devices::yes);
}

std::string read_state(const std::string& path) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 44U;
  return read_from(path, kMost, Devices::no);
}

void write_file(const std::string& path, std::string_view bytes) {
  write_file_in_parts(path, [&](const Sink& sink) { sink(bytes); });
}

void write_file_in_parts(const std::string& path, const Produce& produce) {
  PendingFile(path, produce).place();
}

PendingFile::PendingFile(const std::string& path, const Produce& produce) {
  if (path == "-") {
    write_parts(STDOUT_FILENO, produce, "standard output");
    return;
  }
  if (const auto target = to_replace(path)) {
    target_ = target->string();
    temporary_ = file_beside(*target, produce);
    return;
  }
  const Descriptor fd(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (fd.get() < 0) throw InvalidInput(path, "cannot be opened: " + system_message());
  write_parts(fd.get(), produce, path);
}

PendingFile::PendingFile(const std::string& path, std::string_view bytes)
    : PendingFile(path, [&](const Sink& sink) { sink(bytes); }) {}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::place() {
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0)
    throw InvalidInput(target_, "cannot be replaced: " + system_message());
  temporary_.clear();
  flush_folder(folder_of(target_));
}

void expect_writable(const std::string& path) {
  if (path == "-") return;
  std::filesystem::path file(path);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::status_known(status))
    throw InvalidInput(path, "cannot be created: " + error.message());
  if (std::filesystem::is_directory(status)) throw InvalidInput(path, "is a directory");
  if (std::filesystem::exists(status)) {
    if (!allows(file, W_OK)) throw InvalidInput(path, "cannot be replaced: it is not writable");
    if (!std::filesystem::is_regular_file(status)) return;  // a device is written in place
    file = std::filesystem::canonical(file);
  } else {
    expect_no_link(path);
  }
  const std::filesystem::path folder = folder_of(file);
  if (!std::filesystem::is_directory(folder, error))
    throw InvalidInput(path, "cannot be created: there is no folder " + folder.string());
  if (!allows(folder, W_OK | X_OK))
    throw InvalidInput(path, "cannot be created: the folder is not writable");
}

}  // namespace hexatlas::core
