#include "cli/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "enum/core/files.hpp"

namespace hexatlas::cli {

std::string version() { return HEXATLAS_VERSION; }

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

void print(std::string_view text) { core::write_file("-", text); }

std::string to_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void say_text(std::string_view text) {
  // Where words cannot be written, there is nobody to tell: the exit code still answers.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void tell(const std::string& output, std::string_view text) {
  if (output == "-")
    say_text(text);
  else
    print(text);
}

void say(std::string_view line) { say_text(fmt::format("hexatlas: {}\n", line)); }

void say_fault(std::string_view line) {
  std::string shown;  // names from the command line may hold anything; a fault is one line
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    shown += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  say_text(shown + "\n");
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProgressLine::ProgressLine()
    : is_terminal_(::isatty(STDERR_FILENO) == 1),
      progress_(is_terminal_ ? core::Progress::Reader::terminal : core::Progress::Reader::log,
                seconds()) {}

ProgressLine::~ProgressLine() {
  if (is_shown_) say_text("\r\033[K");
}

void ProgressLine::update(const std::string& phase, std::size_t done, std::size_t total) {
  const auto words = progress_.update(phase, done, total, seconds());
  if (!words) return;
  if (!is_terminal_) return say(*words);
  is_shown_ = true;
  say_text("\r\033[K" + *words);
  std::fflush(stderr);
}

}  // namespace hexatlas::cli
