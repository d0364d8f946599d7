// Claim. Points satisfy the premise clauses of a condition if and only if they obey what each
// family says. Oracle. Random integer points: two tetrahedra meet in their common face only if a
// plane through three of their points, those in common among them, separates them; corners of a
// cube by determinants.
#include "realize/conditions/clauses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "enum/core/errors.hpp"
#include "realize/chirotope/chirotope.hpp"
#include "tests/realize/random_points.hpp"

namespace {

using namespace hexatlas;
using certificate::Condition;
using complex::Triangulation;
using complex::VertexSet;
using sample::Points;

/// Whether points of `plus` lie on the positive side of the plane or on it, those of `minus` on the
/// negative side or on it.
bool separates(const std::array<int, 3>& plane, VertexSet plus, VertexSet minus,
               const Points& points) {
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  for (int v = 0; v < static_cast<int>(points.size()); ++v) {
    if (v == plane[0] || v == plane[1] || v == plane[2]) continue;
    const int side = sample::sign_of_points(at(plane[0]), at(plane[1]), at(plane[2]), at(v));
    if ((plus >> v & 1) != 0 && side < 0) return false;
    if ((minus >> v & 1) != 0 && side > 0) return false;
  }
  return true;
}

/// In general position the parts of two tetrahedra in a plane that separates them are faces with at
/// most three vertices in all, so they meet in the common ones; and a separating plane can be moved
/// until it contains three of the points.
bool meet_properly(VertexSet s, VertexSet t, const Points& points) {
  const int count = static_cast<int>(points.size());
  for (int c = 2; c < count; ++c)
    for (int b = 1; b < c; ++b)
      for (int a = 0; a < b; ++a) {
        const auto plane = static_cast<VertexSet>(1U << a | 1U << b | 1U << c);
        if ((plane & ~(s | t)) != 0 || (s & t & ~plane) != 0) continue;
        if (separates({a, b, c}, s, t, points) || separates({a, b, c}, t, s, points)) return true;
      }
  return false;
}

VertexSet random_tetrahedron(int vertices, std::mt19937_64& random) {
  VertexSet set = 0;
  while (std::popcount(set) < 4)
    set |= complex::bit_of(static_cast<int>(random() % static_cast<unsigned>(vertices)));
  return set;
}

TEST(Clauses, ProperMeansMeetingInTheCommonFace) {
  std::mt19937_64 random(1);
  std::array<std::array<int, 2>, 4> seen{};
  for (int i = 0; i < 4000; ++i) {
    const Points points = sample::random_points(8, 60, random);
    const VertexSet s = random_tetrahedron(8, random);
    const VertexSet t = random_tetrahedron(8, random);
    if (s == t) continue;
    const bool proper = meet_properly(s, t, points);
    ++seen[static_cast<std::size_t>(std::popcount(static_cast<VertexSet>(s & t)))][proper ? 1 : 0];
    const auto clauses = conditions::proper_clauses({8, {s, t}});
    EXPECT_EQ(sample::satisfies_all(sample::signs_of(points), clauses), proper);
  }
  for (const auto& [improper, proper] : seen) {
    EXPECT_GT(improper, 3);
    EXPECT_GT(proper, 3);
  }
}

TEST(Clauses, TwoTetrahedraAtATriangleNeedTwoShortClauses) {
  const auto clauses = conditions::proper_clauses({5, {0b01111, 0b11110}});
  ASSERT_EQ(clauses.size(), 2U);
  EXPECT_EQ(clauses[0].size(), 2U);
}

TEST(Clauses, SignsAreThoseOfTheTetrahedra) {
  std::mt19937_64 random(2);
  const Points points = sample::random_points(8, 60, random);
  Triangulation triangulation{8, {}};
  std::vector<int> signs;
  for (int i = 0; i < 10; ++i) {
    const VertexSet set = random_tetrahedron(8, random);
    const auto [a, b, c, d] = complex::vertices_of(set);
    triangulation.tetrahedra.push_back(set);
    signs.push_back(sample::sign_of_points(points[a], points[b], points[c], points[d]));
  }
  const auto of_points = sample::signs_of(points);
  EXPECT_TRUE(sample::satisfies_all(of_points, conditions::sign_clauses(triangulation, signs)));
  signs[3] = -signs[3];
  EXPECT_FALSE(sample::satisfies_all(of_points, conditions::sign_clauses(triangulation, signs)));
}

/// A cube with edges of length 100 in the directions of the axes, its corners moved a little.
Points random_cube(std::mt19937_64& random) {
  while (true) {
    Points points = sample::random_points(8, 9, random);
    for (unsigned v = 0; v < 8; ++v)
      for (unsigned k = 0; k < 3; ++k) points[v][k] += (v >> k & 1U) != 0 ? 100 : 0;
    const auto signs = sample::signs_of(points);
    if (std::count(signs.begin(), signs.end(), 0) == 0) return points;
  }
}

TEST(Clauses, CornersOfACubeArePositive) {
  std::mt19937_64 random(3);
  const auto clauses = conditions::corner_clauses();
  EXPECT_EQ(clauses.size(), 8U);
  for (int i = 0; i < 20; ++i) {
    Points points = random_cube(random);
    EXPECT_TRUE(sample::satisfies_all(sample::signs_of(points), clauses));
    // A corner pulled through the plane of its neighbours spoils its own determinant.
    const unsigned corner = static_cast<unsigned>(random() % 8);
    for (unsigned k = 0; k < 3; ++k) points[corner][k] += (corner >> k & 1U) != 0 ? -70 : 70;
    EXPECT_FALSE(sample::satisfies(sample::signs_of(points), clauses[corner]));
  }
}

TEST(Clauses, PremisesOfAConditionHoldForItsPoints) {
  const auto set = [](int a, int b, int c, int d) {
    return static_cast<VertexSet>(1U << a | 1U << b | 1U << c | 1U << d);
  };
  // One tetrahedron in the middle, one at each of the corners 0, 3, 5, 6.
  const Triangulation five{
      8, {set(0, 1, 2, 4), set(3, 1, 2, 7), set(5, 1, 4, 7), set(6, 2, 4, 7), set(1, 2, 4, 7)}};
  std::mt19937_64 random(4);
  const Points points = random_cube(random);
  std::vector<int> signs;
  for (const VertexSet tetrahedron : five.tetrahedra) {
    const auto [a, b, c, d] = complex::vertices_of(tetrahedron);
    signs.push_back(sample::sign_of_points(points[a], points[b], points[c], points[d]));
  }
  const auto of_points = sample::signs_of(points);
  const std::size_t base = 5 + 6720 + 112 + conditions::proper_clauses(five).size();
  const std::array<std::pair<Condition, std::size_t>, 3> expected{
      {{Condition::embedded, base},
       {Condition::convex, base + 560},
       {Condition::jacobian, base + 8 + 192}}};
  for (const auto& [condition, size] : expected) {
    const auto clauses = conditions::premises(five, signs, condition);
    EXPECT_EQ(clauses.size(), size);
    EXPECT_TRUE(sample::satisfies_all(of_points, clauses));
  }
}

TEST(Clauses, NonsenseIsRefused) {
  const std::vector<int> one{1};
  const std::vector<int> zero{0};
  EXPECT_THROW((void)conditions::sign_clauses({8, {0b1111}}, {}), core::PreconditionViolated);
  EXPECT_THROW((void)conditions::sign_clauses({8, {0b1111}}, zero), core::PreconditionViolated);
  EXPECT_THROW((void)conditions::sign_clauses({8, {0b111}}, one), core::PreconditionViolated);
  EXPECT_THROW((void)conditions::sign_clauses({4, {0b11110}}, one), core::PreconditionViolated);
  EXPECT_THROW((void)conditions::premises({5, {0b1111}}, one, Condition::jacobian),
               core::PreconditionViolated);
}

}  // namespace
