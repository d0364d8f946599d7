#include "enum/parallel/parallel_for.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "enum/core/checks.hpp"

namespace hexatlas::parallel {
namespace {

/// Keeps the exception of the smallest index.
class FirstException {
 public:
  void guard(std::size_t index, const std::function<void(std::size_t)>& body) {
    try {
      body(index);
    } catch (...) {  // kept, and thrown again by rethrow()
      const std::lock_guard lock(mutex_);
      if (index < index_) {
        index_ = index;
        exception_ = std::current_exception();
      }
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::size_t index_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr exception_;
};

/// Starts up to `count` threads; where the system has no more, what it has must do.
template <class Work>
void start(std::vector<std::jthread>& pool, int count, const Work& work) {
  try {
    pool.reserve(static_cast<std::size_t>(count));
    while (pool.size() < static_cast<std::size_t>(count)) pool.emplace_back(work);
  } catch (const std::system_error&) {  // too many, or no memory for a stack
  } catch (const std::bad_alloc&) {     // none for what a thread begins with
  }
}

#ifdef _OPENMP
/// The run time of OpenMP ends the program where it cannot make a thread. So they are made once
/// before, unless it has them from the last time; and one more, since it needs memory of its own.
int threads_to_be_had(int wanted) {
  thread_local int asked = 1;
  thread_local int had = 1;
  if (wanted == asked) return had;
  std::latch all_are_made{1};
  std::vector<std::jthread> tried;  // joined before the latch that they wait for ends
  start(tried, wanted, [&all_are_made] { all_are_made.wait(); });
  all_are_made.count_down();
  asked = wanted;
  had = std::max(1, static_cast<int>(tried.size()));
  return had;
}
#endif

void run(int threads, std::size_t count, FirstException& first,
         const std::function<void(std::size_t)>& body) {
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads_to_be_had(threads))
  for (std::size_t i = 0; i < count; ++i) first.guard(i, body);
#else
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) first.guard(i, body);
  };
  std::vector<std::jthread> pool;
  start(pool, threads - 1, work);
  work();
#endif
}

}  // namespace

int available_threads() noexcept {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  return std::max(1, CPU_COUNT(&set));
}

int threads_or_all(int threads) noexcept { return threads == 0 ? available_threads() : threads; }

void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t)>& body) {
  core::expects(threads >= 1, "at least one thread");
  FirstException first;
  // One call is made here, outside of any team: within one of OpenMP its own would have one thread.
  if (threads == 1 || count <= 1)
    for (std::size_t i = 0; i < count; ++i) first.guard(i, body);
  else
    run(threads, count, first, body);
  first.rethrow();
}

}  // namespace hexatlas::parallel
