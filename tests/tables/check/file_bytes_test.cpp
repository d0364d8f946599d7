// Claim. The judge reads files, pipes and standard input whole, up to a limit, and says why it
// cannot read.
// Oracle. Bytes written by the test; the messages of strerror.
#include "tables/check/file_bytes.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "tables/check/malformed.hpp"
#include "tables/check/mesh.hpp"

namespace hexatlas::check {
namespace {

constexpr const char* kQuadObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

class FileBytes : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "file-bytes-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

std::string refusal(const std::filesystem::path& path, std::uint64_t most = kMostFileBytes) {
  try {
    static_cast<void>(bytes_of_file(path, most));
  } catch (const Malformed& error) {
    return error.what();
  }
  return "read";
}

/// Standard input is this file while the object lives.
class StandardInputFrom {
 public:
  explicit StandardInputFrom(const std::filesystem::path& path) : before_(::dup(STDIN_FILENO)) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    ::dup2(file, STDIN_FILENO);
    ::close(file);
  }
  StandardInputFrom(const StandardInputFrom&) = delete;
  StandardInputFrom& operator=(const StandardInputFrom&) = delete;
  ~StandardInputFrom() {
    ::dup2(before_, STDIN_FILENO);
    ::close(before_);
  }

 private:
  int before_;
};

TEST_F(FileBytes, ReadsAllBytes) {
  std::string bytes(200'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  EXPECT_EQ(bytes_of_file(write("file", bytes)), bytes);
  EXPECT_EQ(bytes_of_file(write("empty", "")), "");
  EXPECT_EQ(bytes_of_file("/dev/null"), "");
}

TEST_F(FileBytes, ReadsPipes) {
  const std::filesystem::path pipe = folder_ / "pipe.obj";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string bytes = kQuadObj + std::string(300'000, '\n');
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << bytes; });
  const Surface surface = read_surface(pipe);
  writer.join();
  EXPECT_EQ(surface.points.size(), 4U);
  EXPECT_EQ(surface.quads, (std::vector<Quad>{{0, 1, 2, 3}}));
}

TEST_F(FileBytes, ReadsStandardInput) {
  const StandardInputFrom input(write("in", kQuadObj));
  EXPECT_EQ(read_surface("-").quads, (std::vector<Quad>{{0, 1, 2, 3}}));
}

TEST_F(FileBytes, NamesStandardInput) {
  const StandardInputFrom input(folder_);
  EXPECT_EQ(refusal("-"), "standard input: Is a directory");
}

TEST_F(FileBytes, SaysWhy) {
  EXPECT_EQ(refusal("/no/such/file.vtk"), "/no/such/file.vtk: No such file or directory");
  EXPECT_EQ(refusal(folder_), folder_.string() + ": Is a directory");
  const std::filesystem::path locked = write("locked", "x");
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (::geteuid() != 0) {  // no permission is withheld from the superuser
    EXPECT_EQ(refusal(locked), locked.string() + ": Permission denied");
  }
}

TEST_F(FileBytes, StopsAtTheLimit) {
  const std::filesystem::path path = write("ten", "0123456789");
  EXPECT_EQ(bytes_of_file(path, 10), "0123456789");
  EXPECT_EQ(refusal(path, 9), path.string() + ": is larger than 9 bytes");
  EXPECT_EQ(refusal("/dev/zero", 1'000'000), "/dev/zero: is larger than 1000000 bytes");
}

}  // namespace
}  // namespace hexatlas::check
