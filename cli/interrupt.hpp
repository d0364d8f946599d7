#pragma once
/// \file
/// Stopping early, on request.

#include <atomic>

namespace hexatlas::cli {

/// Becomes true at SIGINT or SIGTERM, from the first call on; a second signal ends the program at
/// once.
[[nodiscard]] const std::atomic<bool>& stop_requested();

}  // namespace hexatlas::cli
