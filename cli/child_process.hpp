#pragma once
/// \file
/// Another program, run without a shell.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hexatlas::cli {

/// The file that runs under this name: the path itself if it has a slash, otherwise the first one
/// in PATH. None if there is no such file or it cannot be executed.
[[nodiscard]] std::optional<std::string> executable(const std::string& name);

enum class Ended : std::uint8_t { by_itself, by_timeout, by_request };

struct ChildResult {
  Ended ended = Ended::by_itself;
  int status = 0;  ///< exit status; 128 + number of the signal that killed it
};

/// Runs words[0] with these words until it ends, for at most so many seconds, or until
/// stop_requested(). It reads nothing, and what it says on either stream goes to the file `log`. It
/// has a process group of its own, of which nothing is left running. Throws ResourceFailure if it
/// cannot be started.
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& words, const std::string& log,
                                    int limit_seconds);

}  // namespace hexatlas::cli
