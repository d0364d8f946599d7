// Claim. A search on a pool has the nodes and solutions of explore(), for any number of threads,
// stopped and gone on with anywhere, and in any number of shards; estimates of its size come near.
// Oracle. explore() in one piece; the n queens problem.
#include "enum/search/pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "enum/search/estimate.hpp"
#include "tests/enum/search/queens.hpp"

namespace {

using namespace hexatlas;
using search::Counts;
using support::Queens;
using support::Rows;
using Frontier = search::Frontier<int, Rows>;

constexpr int kSize = 9;

Queens make() { return Queens{kSize}; }
std::optional<Rows> collect(const Queens& queens) { return queens.row; }

Counts whole() {
  Queens queens = make();
  return search::explore(queens, {}, {}, [](const Queens&) { return true; }).counts;
}

std::set<Rows> as_set(const std::vector<Rows>& found) { return {found.begin(), found.end()}; }

TEST(Pool, HasTheCountsOfTheSearchForAnyNumberOfThreads) {
  std::vector<Rows> first;
  for (const int threads : {1, 2, 3}) {
    Frontier frontier;
    search::explore_pending(frontier, {.threads = threads}, make, collect, {});
    EXPECT_TRUE(frontier.is_finished());
    EXPECT_EQ(frontier.counts, whole());
    EXPECT_EQ(frontier.found.size(), 352U);  // OEIS A000170
    EXPECT_EQ(as_set(frontier.found).size(), frontier.found.size());
    if (threads == 1) first = frontier.found;
    EXPECT_EQ(frontier.found, first);
  }
}

TEST(Pool, GoesOnWhereItStopped) {
  Frontier frontier;
  int calls = 0;
  while (!frontier.is_finished()) {
    const auto before = frontier.counts.nodes;
    search::explore_pending(frontier, {.max_nodes = 7777}, make, collect, {});
    EXPECT_LE(frontier.counts.nodes - before, 7777U);
    EXPECT_GT(frontier.counts.nodes, before);
    ++calls;
  }
  EXPECT_GT(calls, 5);
  EXPECT_EQ(frontier.counts, whole());
  EXPECT_EQ(as_set(frontier.found).size(), 352U);
}

TEST(Pool, StopsWhenAsked) {
  Frontier frontier;
  const std::atomic<bool> stop{true};
  search::explore_pending(frontier, {.stop = &stop}, make, collect, {});
  EXPECT_EQ(frontier.counts, Counts{});
  search::explore_pending(frontier, {}, make, collect, [] { return false; });
  EXPECT_FALSE(frontier.is_finished());
  EXPECT_GT(frontier.counts.nodes, 0U);
}

TEST(Pool, ShardsAddUp) {
  for (const std::size_t parts : {1U, 2U, 3U, 7U, 100U}) {
    Counts sum;
    std::set<Rows> found;
    for (std::size_t part = 0; part < parts; ++part) {
      auto frontier = search::shard<Rows>(part, parts, make, collect);
      search::explore_pending(frontier, {}, make, collect, {});
      sum += frontier.counts;
      for (const Rows& rows : frontier.found) EXPECT_TRUE(found.insert(rows).second);
    }
    EXPECT_EQ(sum, whole()) << parts;
    EXPECT_EQ(found.size(), 352U);
  }
}

TEST(Pool, ShardsAreOfLikeSize) {
  const auto big = [] { return Queens{11}; };
  Queens queens = big();
  const auto all = search::explore(queens, {}, {}, [](const Queens&) { return true; }).counts.nodes;
  for (std::size_t part = 0; part < 7; ++part) {
    auto frontier = search::shard<Rows>(part, 7, big, collect);
    search::explore_pending(frontier, {}, big, collect, {});
    EXPECT_GT(frontier.counts.nodes, all / 14);
    EXPECT_LT(frontier.counts.nodes, all / 4);
  }
}

TEST(Estimate, ComesNear) {
  const auto big = [] { return Queens{12}; };
  Queens queens = big();
  const auto nodes = static_cast<double>(
      search::explore(queens, {}, {}, [](const Queens&) { return true; }).counts.nodes);
  const search::Estimate estimate = search::estimate_nodes(big, 4000, 1, 2);
  EXPECT_FALSE(estimate.is_exact);
  EXPECT_LT(std::abs(estimate.nodes - nodes), 4 * estimate.standard_error);
  EXPECT_LT(estimate.standard_error, nodes / 20);
  EXPECT_EQ(search::estimate_nodes(big, 4000, 1, 1).nodes, estimate.nodes);
  EXPECT_NE(search::estimate_nodes(big, 4000, 2, 1).nodes, estimate.nodes);
}

TEST(Estimate, IsExactForASmallTree) {
  const auto small = [] { return Queens{4}; };
  Queens queens = small();
  const auto counts = search::explore(queens, {}, {}, [](const Queens&) { return true; }).counts;
  const search::Estimate estimate = search::estimate_nodes(small, 10, 1, 1);
  EXPECT_TRUE(estimate.is_exact);
  EXPECT_EQ(estimate.nodes, static_cast<double>(counts.nodes));
}

}  // namespace
