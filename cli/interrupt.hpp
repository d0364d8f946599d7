#pragma once
/// \file
/// Stopping early, on request.

#include <atomic>

namespace hexatlas::cli {

/// Becomes true at SIGINT, SIGTERM or, unless it was ignored, SIGHUP, from the first call on; a
/// second SIGINT or SIGTERM ends the program at once.
[[nodiscard]] const std::atomic<bool>& stop_requested();

}  // namespace hexatlas::cli
