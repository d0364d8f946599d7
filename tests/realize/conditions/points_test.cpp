// Claim. The verdict on integer points is that of the definition: general position, signs of the
// tetrahedra, pairs that meet properly, convex position, Jacobian determinant.
// Oracle. Separating planes for pairs and supporting planes for convex position, on random points
// and random sets of tetrahedra (separating_planes.hpp); corner determinants written out.
#include "realize/conditions/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "enum/core/errors.hpp"
#include "tests/realize/conditions/separating_planes.hpp"

namespace {

using namespace hexatlas;
using certificate::Condition;
using certificate::Realization;
using complex::Triangulation;
using complex::VertexSet;
using conditions::PointsJudge;
using conditions::PointsVerdict;

Realization random_points(std::size_t count, std::int64_t bound, std::mt19937_64& random) {
  std::uniform_int_distribution<std::int64_t> coordinate(-bound, bound);
  Realization points(count);
  for (auto& point : points)
    for (std::int64_t& x : point) x = coordinate(random);
  return points;
}

std::vector<VertexSet> random_tetrahedra(std::size_t count, int vertices, std::mt19937_64& random) {
  std::vector<VertexSet> result;
  std::uniform_int_distribution<unsigned> sets(0, (1U << static_cast<unsigned>(vertices)) - 1);
  while (result.size() < count) {
    const unsigned set = sets(random);
    if (std::popcount(set) == 4) result.push_back(static_cast<VertexSet>(set));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<int> signs_at(const std::vector<VertexSet>& tetrahedra, const Realization& points) {
  std::vector<int> signs;
  for (const VertexSet t : tetrahedra) {
    const auto [a, b, c, d] = complex::vertices_of(t);
    signs.push_back(oracle::side(points, a, b, c, d));
  }
  return signs;
}

TEST(Points, PairsAndConvexPosition) {
  std::mt19937_64 random(20261122);
  std::array<std::array<int, 2>, 2> seen{};
  for (int trial = 0; trial < 6000; ++trial) {
    const std::size_t count = 5 + static_cast<std::size_t>(trial) % 5;
    const Realization points = random_points(count, trial % 3 == 0 ? 500'000 : 9, random);
    if (!oracle::in_general_position(points)) continue;
    const Triangulation triangulation{static_cast<int>(count),
                                      random_tetrahedra(1 + static_cast<std::size_t>(trial) % 3,
                                                        static_cast<int>(count), random)};
    const auto signs = signs_at(triangulation.tetrahedra, points);
    const bool proper = oracle::all_meet_properly(triangulation.tetrahedra, points);
    const bool convex = oracle::in_convex_position(points);
    const PointsJudge embedded(triangulation, signs, Condition::embedded);
    ASSERT_EQ(embedded.verdict(points),
              proper ? PointsVerdict::satisfied : PointsVerdict::forbidden_partition);
    ASSERT_EQ(embedded.violations(points) == 0, proper);
    const PointsJudge in_convex(triangulation, signs, Condition::convex);
    ASSERT_EQ(in_convex.verdict(points),
              proper && convex ? PointsVerdict::satisfied : PointsVerdict::forbidden_partition);
    ++seen[proper ? 1 : 0][convex ? 1 : 0];
    std::vector<int> wrong = signs;
    wrong[0] = -wrong[0];
    ASSERT_EQ(PointsJudge(triangulation, wrong, Condition::embedded).verdict(points),
              PointsVerdict::wrong_sign);
  }
  for (const auto& row : seen)
    for (const int cases : row) EXPECT_GT(cases, 100);
}

TEST(Points, DegenerateAndOutOfRange) {
  std::mt19937_64 random(20261123);
  int degenerate = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Realization points = random_points(6, 3, random);
    const Triangulation triangulation{6, {0b1111}};
    const PointsJudge judge(triangulation, std::vector<int>{1}, Condition::embedded);
    const bool general = oracle::in_general_position(points);
    degenerate += general ? 0 : 1;
    ASSERT_EQ(judge.verdict(points) == PointsVerdict::degenerate, !general);
    if (!general) {
      ASSERT_GT(judge.violations(points), 0);
    }
    points[static_cast<std::size_t>(trial % 6)][static_cast<std::size_t>(trial % 3)] =
        (trial % 2 == 0 ? 1 : -1) * certificate::kCoordinateBound;
    ASSERT_EQ(judge.verdict(points), PointsVerdict::out_of_range);
  }
  EXPECT_GT(degenerate, 100);
  EXPECT_LT(degenerate, 1900);
}

/// One corner tetrahedron of a cube with moved corners: embedded whatever the other points are, so
/// the Jacobian determinant alone decides.
TEST(Points, Jacobian) {
  std::mt19937_64 random(20261124);
  std::array<int, 3> seen{};  // satisfied, a corner not positive, refuted with positive corners
  for (int trial = 0; trial < 3000; ++trial) {
    Realization points = random_points(8, 30, random);
    for (std::size_t v = 0; v < 8; ++v)
      for (std::size_t k = 0; k < 3; ++k)
        points[v][k] += 60 * static_cast<std::int64_t>(v >> k & 1U);
    if (!oracle::in_general_position(points)) continue;
    const Triangulation triangulation{8, {0b00010111}};
    const auto signs = signs_at(triangulation.tetrahedra, points);
    bool corners = true;
    for (std::size_t v = 0; v < 8; ++v) {
      const int parity = std::popcount(v) % 2 == 0 ? 1 : -1;
      corners = corners && parity * oracle::side(points, v, v ^ 1U, v ^ 2U, v ^ 4U) > 0;
    }
    ASSERT_EQ(PointsJudge(triangulation, signs, Condition::embedded).verdict(points),
              PointsVerdict::satisfied);
    const auto verdict = PointsJudge(triangulation, signs, Condition::jacobian).verdict(points);
    const bool satisfied = verdict == PointsVerdict::satisfied;
    ASSERT_TRUE(satisfied || verdict == PointsVerdict::jacobian_not_positive);
    if (!corners) {
      ASSERT_FALSE(satisfied);
    }
    ++seen[satisfied ? 0 : (corners ? 2 : 1)];
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[1], 100);
  EXPECT_GT(seen[2], 3);
}

TEST(Points, RefusesBadArguments) {
  const Triangulation one{5, {0b1111}};
  const std::vector<int> plus{1};
  EXPECT_THROW(PointsJudge(one, std::vector<int>{}, Condition::embedded),
               core::PreconditionViolated);
  EXPECT_THROW(PointsJudge(one, std::vector<int>{0}, Condition::embedded),
               core::PreconditionViolated);
  EXPECT_THROW(PointsJudge(one, plus, Condition::jacobian), core::PreconditionViolated);
  EXPECT_THROW(PointsJudge(Triangulation{17, {0b1111}}, plus, Condition::embedded),
               core::PreconditionViolated);
  const PointsJudge judge(one, plus, Condition::embedded);
  EXPECT_THROW((void)judge.verdict(Realization(4)), core::PreconditionViolated);
}

}  // namespace
