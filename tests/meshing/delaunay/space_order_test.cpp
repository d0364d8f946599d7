// Claim. Each point comes once, in rounds, along a curve whose neighbours are neighbours in space;
// for any number of threads alike. Points that are crowded keep to a curve of their own.
// Oracle. The points themselves; lengths of the ways.
#include "meshing/delaunay/space_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "tests/meshing/delaunay/clouds.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::space_order;
using delaunay::SpaceOrder;

double distance(const mesh::Point& p, const mesh::Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

std::vector<std::uint32_t> numbers(const SpaceOrder& order) {
  std::vector<std::uint32_t> result;
  for (const auto& placed : order.points) result.push_back(placed.point);
  return result;
}

std::vector<std::uint64_t> keys(const SpaceOrder& order) {
  std::vector<std::uint64_t> result;
  for (const auto& placed : order.points) result.push_back(placed.key);
  return result;
}

void expect_order(const SpaceOrder& order, std::size_t count) {
  std::vector<std::uint32_t> all = numbers(order);
  std::sort(all.begin(), all.end());
  std::vector<std::uint32_t> expected(count);
  std::iota(expected.begin(), expected.end(), 0U);
  ASSERT_EQ(all, expected);
  ASSERT_EQ(order.rounds.front(), 0U);
  ASSERT_EQ(order.rounds.back(), count);
  for (std::size_t r = 0; r + 1 < order.rounds.size(); ++r) {
    ASSERT_LE(order.rounds[r], order.rounds[r + 1]);
    for (std::size_t i = order.rounds[r]; i < order.rounds[r + 1]; ++i) {
      ASSERT_LT(order.points[i].key >> order.curves.key_bits(), 1U);
      ASSERT_TRUE(i == order.rounds[r] || order.points[i - 1].key <= order.points[i].key);
    }
  }
}

/// On the lattice points of a cube each curve has them all at different places, and those of most
/// neighbours along it are neighbours in space, as far as it does not leave the cube.
TEST(Curves, AreDifferentWaysThroughTheSamePoints) {
  constexpr int kSide = 16;
  const auto points = grid(kSide, 1);
  const delaunay::Curves curves(std::span<const mesh::Point>(points), std::identity(), 4);
  std::set<std::vector<std::size_t>> ways;
  for (unsigned curve = 0; curve < 6; ++curve) {
    std::vector<std::pair<std::uint64_t, std::size_t>> way;
    for (std::size_t i = 0; i < points.size(); ++i)
      way.emplace_back(curves.key_of(points[i], curve), i);
    std::sort(way.begin(), way.end());
    EXPECT_EQ(way.back().first >> curves.key_bits(curve), 0U);
    std::vector<std::size_t> order;
    std::size_t jumps = 0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      order.push_back(way[k].second);
      if (k == 0) continue;
      EXPECT_LT(way[k - 1].first, way[k].first);
      if (distance(points[way[k - 1].second], points[way[k].second]) > 1) ++jumps;
    }
    EXPECT_LE(jumps, curve == 0 ? 0U : points.size() / 8) << curve;
    EXPECT_TRUE(ways.insert(order).second) << curve;
  }
}

TEST(SpaceOrder, IsAPermutationInRounds) {
  Random random(20261251);
  for (const std::size_t count : {0U, 1U, 2U, 3U, 100U, 1000U, 5000U, 40000U}) {
    for (const Cloud& points :
         {uniform(count, random), Cloud(count, {1, 2, 3}), clusters(count, random)}) {
      expect_order(space_order(points, 5, 1), count);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(SpaceOrder, IsAClosedCurveThroughNeighbours) {
  for (const int side : {2, 4, 8}) {
    Cloud grid;
    for (int i = 0; i < side * side * side; ++i)
      grid.push_back({static_cast<double>(i % side), static_cast<double>(i / side % side),
                      static_cast<double>(i / side / side)});
    const SpaceOrder order = space_order(grid, 3, 1);
    ASSERT_EQ(order.rounds.size(), 2U);
    for (std::size_t i = 0; i < grid.size(); ++i)
      EXPECT_EQ(
          distance(grid[order.points[i].point], grid[order.points[(i + 1) % grid.size()].point]), 1)
          << side << ' ' << i;
  }
}

TEST(SpaceOrder, RoundsGrowAndAreSamples) {
  Random random(20261252);
  const Cloud points = uniform(100000, random);
  const SpaceOrder order = space_order(points, 1, 1);
  ASSERT_GE(order.rounds.size(), 4U);
  EXPECT_LT(order.rounds[1], 4000U);
  for (std::size_t r = 1; r + 1 < order.rounds.size(); ++r) {
    EXPECT_GT(order.rounds[r + 1], 6 * order.rounds[r]);
    EXPECT_LT(order.rounds[r + 1], 10 * order.rounds[r]);
  }
  // Of each round a half lies in each half of the numbers.
  for (std::size_t r = 0; r + 1 < order.rounds.size(); ++r) {
    const std::size_t count = order.rounds[r + 1] - order.rounds[r];
    const auto low = static_cast<std::size_t>(
        std::count_if(order.points.begin() + static_cast<std::ptrdiff_t>(order.rounds[r]),
                      order.points.begin() + static_cast<std::ptrdiff_t>(order.rounds[r + 1]),
                      [&](const auto& placed) { return placed.point < points.size() / 2; }));
    EXPECT_NEAR(static_cast<double>(low) / static_cast<double>(count), 0.5, 0.06);
  }
}

TEST(SpaceOrder, IsTheSameForAnyThreads) {
  Random random(20261253);
  for (const Cloud& points :
       {uniform(30000, random), clusters(5000, random), uniform(2, random), Cloud{}}) {
    const SpaceOrder one = space_order(points, 3, 1);
    for (const int threads : {2, 3, 4}) {
      const SpaceOrder other = space_order(points, 3, threads);
      EXPECT_EQ(numbers(other), numbers(one));
      EXPECT_EQ(keys(other), keys(one));
      EXPECT_EQ(other.rounds, one.rounds);
    }
  }
  const Cloud points = uniform(30000, random);
  EXPECT_NE(numbers(space_order(points, 3, 1)), numbers(space_order(points, 4, 1)));
}

/// All points of a lattice with 2^k points along each axis, in one round: each step has length 1.
TEST(SpaceOrder, VisitsNeighboursInSuccession) {
  for (const std::size_t side : {2U, 4U, 8U}) {
    const Cloud points = grid(side, 1);
    const SpaceOrder order = space_order(points, 0, 1);
    ASSERT_EQ(order.rounds, (std::vector<std::size_t>{0, points.size()}));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto& before = order.points[i - 1];
      const auto& after = order.points[i];
      ASSERT_LT(before.key, after.key);
      ASSERT_EQ(distance(points[before.point], points[after.point]), 1);
    }
  }
}

/// The mean step within rounds, in units of the mean distance of neighbours if evenly spread.
double mean_step(const Cloud& points, double volume) {
  const SpaceOrder order = space_order(points, 0, 1);
  double sum = 0;
  const std::size_t begin = order.rounds[order.rounds.size() - 2];
  for (std::size_t i = begin + 1; i < points.size(); ++i)
    sum += distance(points[order.points[i - 1].point], points[order.points[i].point]);
  const auto steps = static_cast<double>(points.size() - begin - 1);
  return sum / steps / std::cbrt(volume / steps);
}

TEST(SpaceOrder, IsShort) {
  Random random(20261254);
  EXPECT_LT(mean_step(uniform(50000, random), 1), 1.5);
  EXPECT_LT(mean_step(uniform(50000, random, 1e-90, 1e-90, 1e-90), 1e-270), 1.5);
}

/// Two crowds, each far below a cell of the grid through both.
TEST(SpaceOrder, IsShortWithinACrowd) {
  Random random(20261255);
  constexpr double kWidth = 1e-7;
  Cloud points = uniform(20000, random, kWidth, kWidth, kWidth);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    points[i].x += 1;
    points[i].y += 1;
  }
  const SpaceOrder order = space_order(points, 0, 1);
  const std::size_t begin = order.rounds[order.rounds.size() - 2];
  std::size_t changes = 0;
  double sum = 0;
  for (std::size_t i = begin + 1; i < points.size(); ++i) {
    const auto& p = points[order.points[i - 1].point];
    const auto& q = points[order.points[i].point];
    if ((p.x > 0.5) != (q.x > 0.5))
      ++changes;
    else
      sum += distance(p, q);
  }
  EXPECT_EQ(changes, 1U);
  const auto steps = static_cast<double>(points.size() - begin);
  EXPECT_LT(sum / steps / kWidth * std::cbrt(steps / 2), 1.5);
}

}  // namespace
