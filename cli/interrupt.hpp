#pragma once
/// \file
/// Stopping early, on request.

#include <atomic>

namespace hexatlas::cli {

/// Becomes true at SIGINT, SIGTERM or, unless it was ignored, SIGHUP, from the first call on; a
/// second SIGINT or SIGTERM ends the program at once.
[[nodiscard]] const std::atomic<bool>& stop_requested();

/// As a first call of it: before a saved search is read, which may take a while and is part of the
/// work that a signal stops.
void heed_stops();

}  // namespace hexatlas::cli
