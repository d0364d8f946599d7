#include "cli/interrupt.hpp"

#include <csignal>

namespace hexatlas::cli {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void request_stop(int signal) {
  stop.store(true);
  // The next one of either kind ends the program at once.
  static_cast<void>(signal);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void heed_stops() {
  // Once: what the first signal did is to stay.
  static const bool is_installed = [] {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, request_stop);
    // A terminal that closes; who began the program with nohup wants it to go on.
    if (std::signal(SIGHUP, SIG_IGN) != SIG_IGN) std::signal(SIGHUP, request_stop);
    return true;
  }();
  static_cast<void>(is_installed);
}

const std::atomic<bool>& stop_requested() {
  heed_stops();
  return stop;
}

}  // namespace hexatlas::cli
