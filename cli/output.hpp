#pragma once
/// \file
/// What the program says, and where: data on standard output, words on standard error.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "enum/core/progress.hpp"
#include "enum/core/words.hpp"

namespace hexatlas::cli {

/// "0.1.0".
[[nodiscard]] std::string version();

/// Data. Throws ResourceFailure if it cannot be written.
void print(std::string_view text);
/// Data that come with an output; if that is on standard output ("-"), they go to standard error.
void tell(const std::string& output, std::string_view text);
/// One line; bytes that are not UTF-8, which names of files may hold, become U+FFFD.
[[nodiscard]] std::string to_line(const nlohmann::ordered_json& json);
using core::counted;
/// What messages call an input: its path, or "standard input" for "-".
[[nodiscard]] std::string input_name(const std::string& path);
/// An option and the file that it names; none if that is empty.
using NamedFile = std::pair<const char*, std::string>;
/// "INPUT and --output are the same file", of the first two of which one would be lost.
[[nodiscard]] std::optional<std::string> same_files(const NamedFile& input,
                                                    const std::vector<NamedFile>& outputs);
/// Words on standard error, as they stand; no error if they cannot be written.
void say_text(std::string_view text);
/// A word to the user: one line on standard error, after the name of the program.
void say(std::string_view line);
/// An error that names its file: one line `file:line: reason` on standard error, as compilers do.
void say_fault(std::string_view line);

/// How far the work has come (progress.hpp), on standard error: on a terminal in a line that
/// overwrites itself and is removed at the end, otherwise now and then in a line of its own.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();
  void update(const std::string& phase, std::size_t done, std::size_t total);
  /// Whether somebody may be watching, so that an estimate is worth its cost.
  [[nodiscard]] bool is_watched() const noexcept { return is_terminal_; }

 private:
  bool is_terminal_;
  bool is_shown_ = false;
  core::Progress progress_;
};

/// Seconds on a clock that never goes back.
[[nodiscard]] double seconds();

}  // namespace hexatlas::cli
