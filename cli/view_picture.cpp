#include "cli/view_picture.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/child_process.hpp"
#include "enum/core/errors.hpp"
#include "enum/core/files.hpp"

namespace hexatlas::cli {
namespace {

namespace fs = std::filesystem;

/// Removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code error;
    std::string pattern = (fs::temp_directory_path(error) / "hexatlas-XXXXXX").string();
    if (error || ::mkdtemp(pattern.data()) == nullptr)
      throw core::ResourceFailure("no temporary folder can be made at " + pattern);
    path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code error;  // what is left is in the folder for such things
    fs::remove_all(path_, error);
  }
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string url_of(const std::string& path) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/-_.~";
  std::string url = "file://";
  for (const char c : path)
    url += kPlain.find(c) != std::string_view::npos
               ? std::string(1, c)
               : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return url;
}

std::vector<std::string> words_for(const std::string& browser, const TemporaryFolder& folder,
                                   const PictureRequest& request) {
  std::vector<std::string> words{
      browser, "--headless", "--disable-quic", "--no-first-run", "--no-default-browser-check",
      "--disable-background-networking", "--disable-component-update", "--disable-sync",
      "--disable-extensions", "--disable-breakpad", "--disable-dev-shm-usage",
      // Software rendering: the same everywhere, and there where no graphics hardware is.
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb",
      "--force-device-scale-factor=1", "--hide-scrollbars", "--enable-logging=stderr",
      // Time that passes only while the page waits, so that a slow machine draws it, too.
      "--virtual-time-budget=10000", "--user-data-dir=" + folder.file("profile"),
      fmt::format("--window-size={},{}", request.width, request.height),
      "--screenshot=" + folder.file("picture.png"), url_of(folder.file("page.html"))};
  if (::geteuid() == 0) words.insert(words.begin() + 2, "--no-sandbox");  // root has none
  return words;
}

std::string bytes_or_nothing(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) ? core::read_file(path) : std::string();
}

/// The signature of a PNG, and width and height as its first block tells them.
bool is_png_of_size(std::string_view bytes, const PictureRequest& request) {
  constexpr std::string_view kBegin("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8U | static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return bytes.size() > 24 && bytes.substr(0, 16) == kBegin &&
         number(16) == static_cast<unsigned>(request.width) &&
         number(20) == static_cast<unsigned>(request.height);
}

/// What the page, or else the browser, said last of a failure.
std::string last_words(std::string_view log) {
  constexpr std::string_view kSpaces = " \t\r\n";
  const std::size_t last = log.find_last_not_of(kSpaces);
  if (last == std::string_view::npos) return "it said nothing";
  log = log.substr(0, last + 1);
  const std::size_t line = log.find_last_of('\n');
  log = line == std::string_view::npos ? log : log.substr(line + 1);
  std::string text;
  for (const char c : log.substr(0, 200)) text += c >= ' ' && c <= '~' ? c : '?';
  return "it said: " + text;
}

}  // namespace

std::string browser() {
  if (const char* const named = std::getenv("CHROMIUM"); named != nullptr && *named != '\0') {
    if (const auto found = executable(named)) return *found;
    throw core::ResourceFailure(fmt::format("CHROMIUM is `{}`, which cannot be run", named));
  }
  for (const char* const name :
       {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"})
    if (const auto found = executable(name)) return *found;
  throw core::ResourceFailure(
      "--png needs Chromium: install it (Debian: apt-get install chromium), or name it in the "
      "variable CHROMIUM");
}

std::string picture_of(const std::string& page, const std::string& browser,
                       const PictureRequest& request) {
  const TemporaryFolder folder;
  core::write_file(folder.file("page.html"), page);
  const ChildResult ran =
      run_child(words_for(browser, folder, request), folder.file("log"), request.timeout);
  if (ran.ended == Ended::by_request) return {};
  if (ran.ended == Ended::by_timeout)
    throw core::ResourceFailure(
        fmt::format("{} made no picture within {} s", browser, request.timeout));
  const std::string log = bytes_or_nothing(folder.file("log"));
  std::string picture = bytes_or_nothing(folder.file("picture.png"));
  if (log.find("\"hexatlas: failed") != std::string::npos)
    throw core::ResourceFailure(browser + " cannot draw with WebGL 2 here");
  if (log.find("\"hexatlas: drawn") == std::string::npos || !is_png_of_size(picture, request))
    throw core::ResourceFailure(fmt::format("{} made no picture (exit status {}); {}", browser,
                                            ran.status, last_words(log)));
  return picture;
}

}  // namespace hexatlas::cli
