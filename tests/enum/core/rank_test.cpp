// Claim. rank_modulo_2() is the rank. Oracle. The number of different sums of rows, which is a
// power of two with the rank as its exponent.
#include "enum/core/rank.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace hexatlas;

TEST(RankModuloTwo, IsThatOfAllSums) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const std::size_t count = random() % 9, columns = 1 + random() % 10;
    std::vector<std::vector<std::size_t>> rows(count);
    std::vector<unsigned> words(count, 0);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < columns; ++c)
        if (random() % 3 == 0) {
          rows[i].push_back(c);
          words[i] |= 1U << c;
        }
    std::set<unsigned> sums{0};
    for (const unsigned word : words) {
      const std::set<unsigned> before = sums;
      for (const unsigned sum : before) sums.insert(sum ^ word);
    }
    EXPECT_EQ(std::size_t{1} << core::rank_modulo_2(rows), sums.size());
  }
}

}  // namespace
