#pragma once
/// \file
/// The one way to use several threads. Two back ends, chosen when building: OpenMP, and
/// standard threads for builds under a race detector (docs/architecture/decisions/0005).

#include <cstddef>
#include <functional>

namespace hexatlas::parallel {

/// Number of processors this process may use; at least 1.
[[nodiscard]] int available_threads() noexcept;

/// `threads`, or available_threads() if it is 0: what a caller means who leaves the number open.
[[nodiscard]] int threads_or_all(int threads) noexcept;

/// Calls body(i) once for each i in [0, count), on at most `threads` threads, in any order; on
/// fewer if the system cannot make so many, for want of memory or by a limit.
/// Returns when all calls have returned. If calls throw, the exception of the smallest such
/// i is thrown again and every other i is still called. With threads == 1 the calls are made
/// in order on the calling thread, as is a single call, which may use several threads itself;
/// whether those of a call beside others may is not promised. Requires threads >= 1.
/// The caller sees to it that results do not depend on the order: one slot per i.
void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace hexatlas::parallel
