// Claim. A PairSet holds what was inserted and not erased since. Oracle. std::set.
#include "enum/complex/pair_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "enum/core/random.hpp"

namespace {

using namespace hexatlas;
using complex::VertexId;

TEST(PairSet, IsASet) {
  for (const std::size_t range : {2U, 9U, 40U, 3000U}) {
    core::Random random(range);
    complex::PairSet set;
    std::set<std::pair<VertexId, VertexId>> expected;
    for (int i = 0; i < 20'000; ++i) {
      auto a = static_cast<VertexId>(random.below(range));
      auto b = static_cast<VertexId>(random.below(range));
      if (random.below(50) == 0) a = ~VertexId{0} - a;  // the greatest vertices as well
      if (a == b) continue;
      EXPECT_EQ(set.has(a, b), expected.contains(std::minmax(a, b)));
      const bool is_new = !expected.contains(std::minmax(a, b));
      if (random.below(2) == 0) {
        EXPECT_EQ(set.insert(a, b), is_new);
        expected.insert(std::minmax(a, b));
        EXPECT_TRUE(set.has(b, a));
      } else if (!is_new && random.below(3) != 0) {
        set.erase(b, a);
        expected.erase(std::minmax(a, b));
        EXPECT_FALSE(set.has(a, b));
      }
      ASSERT_EQ(set.size(), expected.size());
    }
    for (const auto& [a, b] : expected) EXPECT_TRUE(set.has(a, b) && set.has(b, a));
    if (range == 3000) {
      EXPECT_GT(set.size(), 3000U) << "it has grown";
    }
  }
}

}  // namespace
