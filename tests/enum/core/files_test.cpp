// Claim. write_file() replaces a file wholly or leaves what was there, leaves no temporary file,
// and names the party to blame; read_file() and read_state() return the bytes; expect_writable()
// refuses what write_file() refuses and changes nothing. Oracle. The file system itself, read with
// std::ifstream and listed with std::filesystem; for expect_writable(), write_file().
#include "enum/core/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "enum/core/errors.hpp"
#include "tests/bytes_of.hpp"

namespace {

using namespace hexatlas;
namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "hexatlas-files-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override {
    if (was_root_) {
      ASSERT_EQ(::seteuid(0), 0);
    }
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator{});
  }
  /// The superuser may write everywhere, so another user goes on.
  void drop_privileges() {
    constexpr unsigned kNobody = 65534;
    if (::geteuid() != 0) return;
    if (::chown(folder_.c_str(), kNobody, kNobody) != 0 || ::seteuid(kNobody) != 0)
      GTEST_SKIP() << "privileges cannot be dropped here";
    was_root_ = true;
  }
  template <class Error>
  static std::string message_of(const std::function<void()>& action) {
    try {
      action();
    } catch (const Error& error) {
      return error.what();
    }
    return "no such error";
  }
  fs::path folder_;
  bool was_root_ = false;
};

using core::InvalidInput;
using core::ResourceFailure;

TEST_F(Files, AreWrittenWholeAndReadBack) {
  std::string bytes;
  for (int i = 0; i < 300'000; ++i) bytes += static_cast<char>(i * 7 % 256);
  core::write_file(path("a"), bytes);
  EXPECT_EQ(support::bytes_of(path("a")), bytes);
  EXPECT_EQ(core::read_file(path("a")), bytes);
  core::write_file(path("a"), "");
  EXPECT_EQ(support::bytes_of(path("a")), "");
  EXPECT_EQ(core::read_file(path("a")), "");
  EXPECT_EQ(entries(), 1) << "a temporary file was left";
}

TEST_F(Files, AreWrittenInParts) {
  std::string expected;
  core::write_file_in_parts(path("a"), [&](const core::Sink& sink) {
    for (const std::size_t size : {1, 0, 300'000, 7, 65'536}) {
      const std::string part(size, static_cast<char>('a' + size % 26));
      sink(part);
      expected += part;
      EXPECT_FALSE(fs::exists(path("a"))) << "a part of the file can be seen";
    }
  });
  EXPECT_TRUE(support::bytes_of(path("a")) == expected);
  core::write_file_in_parts(path("a"), [](const core::Sink&) {});
  EXPECT_EQ(support::bytes_of(path("a")), "");
  EXPECT_EQ(entries(), 1) << "a temporary file was left";
}

TEST_F(Files, WhatWasThereStaysIfAPartIsMissing) {
  core::write_file(path("a"), "old");
  const auto fail = [](const core::Sink& sink) {
    sink("new");
    throw InvalidInput("f", "no more");
  };
  for (const char* name : {"a", "b"})
    EXPECT_EQ(message_of<InvalidInput>([&] { core::write_file_in_parts(path(name), fail); }),
              "f: no more");
  EXPECT_EQ(support::bytes_of(path("a")), "old");
  EXPECT_EQ(entries(), 1) << "a file was left";
}

TEST_F(Files, PendingOnesTakeTheirPlaceWhenTold) {
  core::write_file(path("a"), "old");
  {
    core::PendingFile a(path("a"), "new"), b(path("b"), "new");
    EXPECT_EQ(entries(), 3);
    EXPECT_EQ(support::bytes_of(path("a")), "old");
    b.place();
    b.place();
    EXPECT_EQ(support::bytes_of(path("b")), "new");
    EXPECT_EQ(entries(), 3);
  }
  EXPECT_EQ(support::bytes_of(path("a")), "old");
  EXPECT_EQ(entries(), 2) << "a file was left";
  core::PendingFile a(path("a"), "new");
  a.place();
  EXPECT_EQ(support::bytes_of(path("a")), "new");
}

TEST_F(Files, AFileLargerThanTheLimitIsRefusedBeforeItIsRead) {
  { std::ofstream(path("a")) << "x"; }
  std::error_code error;
  fs::resize_file(path("a"), core::kMaxFileBytes + 1, error);  // a hole, no blocks
  if (error) GTEST_SKIP() << "no files of this size here";
  EXPECT_EQ(message_of<InvalidInput>([&] { static_cast<void>(core::read_file(path("a"))); }),
            path("a") + ": is larger than 4 GiB");
}

TEST_F(Files, AStateIsReadOfNoDevice) {
  { std::ofstream(path("a")) << "x"; }
  EXPECT_EQ(core::read_state(path("a")), "x");
  EXPECT_EQ(message_of<InvalidInput>([] { static_cast<void>(core::read_state("/dev/null")); }),
            "/dev/null: is a device");
}

TEST_F(Files, NewOnesHaveTheUsualPermissions) {
  core::write_file(path("a"), "x");
  struct stat status {};
  ASSERT_EQ(::stat(path("a").c_str(), &status), 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(status.st_mode & 0777U, 0666U & ~mask);
}

TEST_F(Files, ALinkIsFollowed) {
  core::write_file(path("target"), "old");
  fs::create_symlink(path("target"), path("link"));
  core::write_file(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(support::bytes_of(path("target")), "new");
}

TEST_F(Files, WhatWasThereStaysInAReadOnlyFolder) {
  drop_privileges();
  if (IsSkipped()) return;
  core::write_file(path("a"), "old");
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(core::write_file(path("a"), "new"), InvalidInput);
  EXPECT_THROW(core::write_file(path("b"), "new"), InvalidInput);
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(support::bytes_of(path("a")), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, WhatWasThereStaysIfItIsReadOnly) {
  drop_privileges();
  if (IsSkipped()) return;
  core::write_file(path("a"), "old");
  fs::permissions(path("a"), fs::perms::owner_read);
  EXPECT_THROW(core::write_file(path("a"), "new"), InvalidInput);
  EXPECT_EQ(support::bytes_of(path("a")), "old");
}

TEST_F(Files, AFileWithALongNameIsReplaced) {
  // 250 characters are a legal name, but no longer one with anything added to it.
  const std::string name(250, 'n');
  { std::ofstream(path(name)) << "old"; }
  core::write_file(path(name), "new");
  EXPECT_EQ(support::bytes_of(path(name)), "new");
  EXPECT_THROW(core::write_file(path(std::string(300, 'n')), "new"), InvalidInput);
  EXPECT_EQ(entries(), 1) << "a temporary file was left";
}

TEST_F(Files, ALinkIsFollowedAndALinkToNothingIsRefused) {
  { std::ofstream(path("target")) << "old"; }
  fs::create_symlink(path("target"), path("link"));
  core::write_file(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(support::bytes_of(path("target")), "new");
  fs::create_symlink(path("nothing"), path("dangling"));
  EXPECT_THROW(core::write_file(path("dangling"), "new"), InvalidInput);
  EXPECT_TRUE(fs::is_symlink(path("dangling")));
  EXPECT_EQ(entries(), 3);
}

TEST_F(Files, AFullDeviceIsAResourceFailure) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const std::string message =
      message_of<ResourceFailure>([] { core::write_file("/dev/full", "x"); });
  EXPECT_NE(message.find("/dev/full"), std::string::npos) << message;
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device was replaced";
}

TEST_F(Files, DirectoriesAndMissingOnesAreTheUsersFault) {
  const std::string here = folder_.string();
  EXPECT_EQ(message_of<InvalidInput>([&] { core::write_file(here, "x"); }),
            here + ": is a directory");
  EXPECT_EQ(message_of<InvalidInput>([&] { (void)core::read_file(here); }),
            here + ": is a directory");
  EXPECT_NE(
      message_of<InvalidInput>([&] { (void)core::read_file(path("no")); }).find("No such file"),
      std::string::npos);
  EXPECT_NE(message_of<InvalidInput>([&] {
              core::write_file(path("no/file"), "x");
            }).find("No such file"),
            std::string::npos);
  EXPECT_EQ(entries(), 0);
}

TEST_F(Files, WhatCanBeWrittenIsToldBeforeAsItIsAtTheEnd) {
  drop_privileges();
  if (IsSkipped()) return;
  { std::ofstream(path("file")) << "old"; }
  { std::ofstream(path("fixed")) << "old"; }
  fs::permissions(path("fixed"), fs::perms::owner_read);
  fs::create_directory(path("folder"));
  fs::create_directory(path("closed"));
  { std::ofstream(path("closed/file")) << "old"; }
  fs::permissions(path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  fs::create_symlink(path("file"), path("link"));
  fs::create_symlink(path("closed/file"), path("link to closed"));
  fs::create_symlink(path("nothing"), path("dangling"));
  const auto refuses = [](const std::function<void()>& action) {
    return message_of<InvalidInput>(action) != "no such error";
  };
  int refused = 0;
  for (const std::string name :
       {"file", "fixed", "folder", "closed/file", "closed/new", "link", "link to closed",
        "dangling", "new", "new/", "no/new", "file/new", "folder/new"}) {
    const std::ptrdiff_t before = entries();
    const bool told = refuses([&] { core::expect_writable(path(name)); });
    EXPECT_EQ(entries(), before) << name;
    EXPECT_EQ(told, refuses([&] { core::write_file(path(name), "new"); })) << name;
    refused += told ? 1 : 0;
  }
  EXPECT_EQ(refused, 9);
  fs::permissions(path("closed"), fs::perms::owner_all);  // so that it can be removed
  EXPECT_FALSE(refuses([] { core::expect_writable("-"); }));
  EXPECT_FALSE(refuses([] { core::expect_writable("/dev/null"); }));
}

TEST(Errors, NameFileAndLine) {
  EXPECT_STREQ(InvalidInput("f", 3, "bad").what(), "f:3: bad");
  EXPECT_STREQ(InvalidInput("f", "bad").what(), "f: bad");
}

}  // namespace
