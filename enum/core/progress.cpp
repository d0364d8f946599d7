#include "enum/core/progress.hpp"

#include <algorithm>
#include <cmath>

namespace hexatlas::core {
namespace {

constexpr double kBetweenUpdates = 0.2;
constexpr double kLongestSilence = 600;
constexpr double kBeforeEstimate = 2;

std::string in_words(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 2 * kMinute) return std::to_string(std::llround(seconds)) + " s";
  if (seconds < 2 * kHour) return std::to_string(std::llround(seconds / kMinute)) + " min";
  return std::to_string(std::llround(seconds / kHour)) + " h";
}

}  // namespace

bool Progress::is_due(bool is_new_phase, double now) noexcept {
  if (reader_ == Reader::terminal) {
    if (!is_new_phase && now - last_ < kBetweenUpdates) return false;
    last_ = now;
    return true;
  }
  const double since = now - begin_;
  if (since < log_after_) return false;
  log_after_ = since + std::min(since, kLongestSilence);
  return true;
}

std::optional<std::string> Progress::update(std::string_view phase, std::size_t done,
                                            std::size_t total, double now) {
  const bool is_new_phase = phase != phase_;
  if (is_new_phase) {
    phase_ = phase;
    start_ = now;
    done_at_start_ = done;
    total_ = total;
    has_fixed_total_ = true;
  }
  has_fixed_total_ = has_fixed_total_ && total == total_;
  if (!is_due(is_new_phase, now)) return std::nullopt;
  const double since = now - start_;
  std::string words = std::string(phase) + ": " + std::to_string(done);
  if (total != 0) words += " of " + std::to_string(total);
  words += ", " + in_words(since);
  if (has_fixed_total_ && since >= kBeforeEstimate && done > done_at_start_ && done < total) {
    const double each = since / static_cast<double>(done - done_at_start_);
    words += ", about " + in_words(each * static_cast<double>(total - done)) + " more at this pace";
  }
  return words;
}

}  // namespace hexatlas::core
