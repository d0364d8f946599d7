#pragma once
/// \file
/// How far long work has come, in words, and when to say so. Takes the time as an argument.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hexatlas::core {

class Progress {
 public:
  enum class Reader : std::uint8_t {
    terminal,  ///< a line that overwrites itself: at most five a second
    log        ///< after a minute, then each time after as long again, at most ten minutes, and
               ///< where a phase begins, if nothing was said for a minute
  };

  /// `now`: seconds on some clock, here and below.
  Progress(Reader reader, double now) noexcept : reader_(reader), begin_(now), last_(now) {}

  /// The words to be said now, such as "cuts: 30 of 100, 12 s, about 28 s more at this pace";
  /// nullopt if it is too early. `total`: 0 if nobody knows. The pace is that of this phase, and is
  /// left out before two seconds and where `total` changes, so that nothing follows from it.
  [[nodiscard]] std::optional<std::string> update(std::string_view phase, std::size_t done,
                                                  std::size_t total, double now);

 private:
  [[nodiscard]] bool is_due(bool is_new_phase, double now) noexcept;

  Reader reader_;
  double begin_;
  double last_;            ///< when something was said
  double log_after_ = 60;  ///< seconds since the beginning
  // Of the phase:
  std::optional<std::string> phase_;
  double start_ = 0;
  std::size_t done_at_start_ = 0;
  std::size_t total_ = 0;
  bool has_fixed_total_ = true;
};

}  // namespace hexatlas::core
