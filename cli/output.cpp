#include "cli/output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "enum/core/files.hpp"

namespace hexatlas::cli {
namespace {

/// The output would take the place of the input.
bool is_same_file(const std::string& input, const std::string& output) {
  if (input == "-" || output == "-") return false;
  std::error_code error;  // a file that is not there is told by who opens it
  return std::filesystem::is_regular_file(input, error) &&
         std::filesystem::equivalent(input, output, error);
}

/// Two outputs are one file also if it is not there yet.
bool is_same_output(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  namespace fs = std::filesystem;
  if (is_same_file(a, b)) return true;
  std::error_code error, other;  // what is wrong with a name is told by who writes there
  const fs::path one = fs::weakly_canonical(fs::absolute(a), error);
  return one == fs::weakly_canonical(fs::absolute(b), other) && !error && !other;
}

}  // namespace

std::string version() { return HEXATLAS_VERSION; }

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

void print(std::string_view text) { core::write_file("-", text); }

std::string to_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::optional<std::string> same_files(const NamedFile& input,
                                      const std::vector<NamedFile>& outputs) {
  const auto told = [](const NamedFile& one, const NamedFile& other) {
    return fmt::format("{} and {} are the same file", one.first, other.first);
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].second.empty()) continue;
    if (is_same_file(input.second, outputs[i].second)) return told(input, outputs[i]);
    for (std::size_t j = 0; j < i; ++j)
      if (!outputs[j].second.empty() && is_same_output(outputs[j].second, outputs[i].second))
        return told(outputs[j], outputs[i]);
  }
  return std::nullopt;
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
