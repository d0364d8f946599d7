#pragma once
/// \file
/// What random trials of exact signs share: numbers to begin with, and what came of them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

#include "realize/exact/sign.hpp"

namespace hexatlas::sign_trials {

using Random = std::mt19937_64;

/// In [0, 1).
inline double unit(Random& random) { return std::ldexp(static_cast<double>(random() >> 11U), -53); }

/// One of `size` integers, zero in their middle.
inline double small_integer(Random& random, std::uint64_t size) {
  return static_cast<double>(random() % size) - static_cast<double>(size / 2);
}

/// How many trials had which sign, and in how many the filter was silent.
struct Tally {
  int negative = 0, zero = 0, positive = 0, left_by_filter = 0;
};

/// The filter may be silent, never wrong.
inline void add(exact::Sign expected, const std::optional<exact::Sign>& filtered, Tally& tally) {
  if (filtered) {
    ASSERT_EQ(*filtered, expected);
  }
  tally.negative += expected == exact::Sign::negative ? 1 : 0;
  tally.zero += expected == exact::Sign::zero ? 1 : 0;
  tally.positive += expected == exact::Sign::positive ? 1 : 0;
  tally.left_by_filter += filtered ? 0 : 1;
}

}  // namespace hexatlas::sign_trials
