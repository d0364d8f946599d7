#pragma once
/// \file
/// Private to meshing/delaunay: a thread that has done its work gets some of another's.

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/region.hpp"

namespace hexatlas::delaunay {

/// A part of a closed curve, and what is to be inserted there.
template <class Index>
struct Stretch {
  Region region;
  std::span<const Index> sites;  ///< in the order of the curve
  Index start = kNone;           ///< a cell within the region, if one is known
};

/// Where threads that work meet those that wait for work. What one did before it gave is seen by
/// the one that takes it.
template <class Index>
class Handover {
 public:
  /// Of a thread, from when it begins to work until it has no more. Threads that were not begun
  /// are not waited for, so all may be one thread, one after the other.
  class Seat {
   public:
    explicit Seat(Handover& handover) : handover_(handover) {
      const std::lock_guard lock(handover_.mutex_);
      ++handover_.working_;
    }
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;
    ~Seat() {
      if (is_working_) handover_.leave(std::unique_lock(handover_.mutex_));
    }
    /// Waits for what another gives; nullopt when none works any more.
    [[nodiscard]] std::optional<Stretch<Index>> awaited() {
      const auto given = handover_.awaited();
      is_working_ = given.has_value();
      return given;
    }

   private:
    Handover& handover_;
    bool is_working_ = true;
  };

  /// Whether a thread waits. To be asked often.
  [[nodiscard]] bool is_wanted() const noexcept {
    return wanted_.load(std::memory_order_relaxed) > 0;
  }
  void give(const Stretch<Index>& stretch) {
    const std::lock_guard lock(mutex_);
    given_.push_back(stretch);
    wanted_.fetch_sub(1, std::memory_order_relaxed);
    changed_.notify_one();
  }

 private:
  void leave(const std::unique_lock<std::mutex>& /*held*/) {
    if (--working_ == 0) changed_.notify_all();
  }
  std::optional<Stretch<Index>> awaited() {
    std::unique_lock lock(mutex_);
    wanted_.fetch_add(1, std::memory_order_relaxed);
    leave(lock);
    changed_.wait(lock, [&] { return working_ == 0 || !given_.empty(); });
    if (given_.empty()) {
      wanted_.fetch_sub(1, std::memory_order_relaxed);
      return std::nullopt;
    }
    ++working_;
    const Stretch<Index> stretch = given_.back();
    given_.pop_back();
    return stretch;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Stretch<Index>> given_;
  int working_ = 0;
  std::atomic<int> wanted_{0};  ///< threads that wait, less what was given to them
};

}  // namespace hexatlas::delaunay
