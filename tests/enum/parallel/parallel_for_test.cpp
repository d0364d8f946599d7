// Claim. parallel_for() calls the body once per index for any number of threads, ends only when all
// calls have ended, and throws the exception of the least index that threw.
// Oracle. Counting.
#include "enum/parallel/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "enum/core/errors.hpp"

namespace {
std::atomic<long> allocations_left{-1};  // negative: as many as wanted
}  // namespace

// The linker takes these for operator new and for what it was (tests.cmake): a definition of our
// own would not take the place of a sanitizer's.
void* operator_new(std::size_t size) __asm__("__real__Znwm");
void* counted_operator_new(std::size_t size) __asm__("__wrap__Znwm");
void* counted_operator_new(std::size_t size) {
  if (allocations_left >= 0 && allocations_left-- == 0) throw std::bad_alloc();
  return operator_new(size);
}

namespace {

using hexatlas::parallel::parallel_for;

TEST(ParallelFor, VisitsEachIndexOnce) {
  for (const int threads : {1, 2, 3, 7, 16})
    for (const std::size_t count : {0U, 1U, 2U, 15U, 1000U}) {
      std::vector<int> visits(count, 0);  // one slot per index: no race if each is visited once
      parallel_for(threads, count, [&](std::size_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads, " << count;
    }
}

TEST(ParallelFor, OneThreadKeepsTheOrderAndTheThread) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  parallel_for(1, 5, [&](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(i);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(ParallelFor, ASingleCallMayUseSeveralThreads) {
  std::atomic<int> waiting{0};
  std::atomic<int> met{0};
  parallel_for(4, 1, [&](std::size_t) {
    parallel_for(2, 2, [&](std::size_t) {
      ++waiting;
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
      while (waiting < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
      met += waiting == 2 ? 1 : 0;
    });
  });
  EXPECT_EQ(met, 2);
}

TEST(ParallelFor, ThrowsTheExceptionOfTheLeastIndexAfterAllCalls) {
  for (const int threads : {1, 2, 5})
    for (int repetition = 0; repetition < 20; ++repetition) {
      std::atomic<int> calls{0};
      std::string message;
      try {
        parallel_for(threads, 100, [&](std::size_t i) {
          ++calls;
          if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
        });
      } catch (const std::runtime_error& error) {
        message = error.what();
      }
      EXPECT_EQ(message, "7");
      EXPECT_EQ(calls.load(), 100);
    }
}

TEST(ParallelFor, HasFewerThreadsForWantOfMemory) {
  allocations_left = 0;
  EXPECT_THROW(::operator delete(::operator new(1)), std::bad_alloc);
  int told = 0;
  for (int allowed = 0; allowed < 24; ++allowed) {
    std::atomic<int> calls{0};
    allocations_left = allowed;
    try {
      parallel_for(3 + allowed % 2, 8, [&](std::size_t) { ++calls; });  // not as many as last time
      allocations_left = -1;
      EXPECT_EQ(calls.load(), 8) << allowed;
    } catch (const std::bad_alloc&) {
      allocations_left = -1;
      ++told;
    }
  }
  EXPECT_LT(told, 24);
}

TEST(ParallelFor, NeedsAThread) {
  EXPECT_THROW(parallel_for(0, 1, [](std::size_t) {}), hexatlas::core::PreconditionViolated);
  EXPECT_GE(hexatlas::parallel::available_threads(), 1);
}

TEST(ParallelFor, NoNumberOfThreadsMeansAll) {
  EXPECT_EQ(hexatlas::parallel::threads_or_all(0), hexatlas::parallel::available_threads());
  for (const int threads : {1, 2, 1000})
    EXPECT_EQ(hexatlas::parallel::threads_or_all(threads), threads);
}

}  // namespace
