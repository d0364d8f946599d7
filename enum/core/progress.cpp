#include "enum/core/progress.hpp"

#include <algorithm>
#include <cmath>

namespace hexatlas::core {
namespace {

constexpr double kBetweenUpdates = 0.2;
constexpr double kBetweenPhases = 60;  // in a log
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
  const double since = now - begin_;
  const double silence = now - last_;
  const bool is_terminal = reader_ == Reader::terminal;
  const bool is_time = is_terminal ? silence >= kBetweenUpdates : since >= log_after_;
  if (!is_time && !(is_new_phase && (is_terminal || silence >= kBetweenPhases))) return false;
  if (is_time) log_after_ = since + std::min(since, kLongestSilence);
  last_ = now;
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
