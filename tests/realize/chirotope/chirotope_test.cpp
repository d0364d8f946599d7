// Claim. Variables, literals, circuits and clause families are those of points and vectors.
// Oracle. Points with integer coordinates: determinants, Radon partitions made by construction,
// points in tetrahedra. All sign vectors that satisfy the clauses of six elements against all
// images of one vector configuration: uniform oriented matroids of rank 4 on six elements are dual
// to those of rank 2, which are one up to reorientation, relabelling and mirror images, (6-1)! 2^5
// in number.
#include "realize/chirotope/chirotope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "enum/core/errors.hpp"
#include "tests/realize/random_points.hpp"

namespace {

using namespace hexatlas;
using chirotope::Clause;
using chirotope::Literal;
using chirotope::Signs;
using sample::Point;
using sample::Points;

TEST(Chirotope, VariablesCountColexicographically) {
  Literal variable = 0;
  for (int d = 3; d < chirotope::kMaxPoints; ++d)
    for (int c = 2; c < d; ++c)
      for (int b = 1; b < c; ++b)
        for (int a = 0; a < b; ++a) {
          EXPECT_EQ(chirotope::literal_of(a, b, c, d), ++variable);
          const auto points = chirotope::points_of(variable);
          EXPECT_EQ(chirotope::literal_of(points[0], points[1], points[2], points[3]), variable);
          EXPECT_TRUE(points[0] == a && points[1] == b && points[2] == c && points[3] == d);
        }
  EXPECT_EQ(chirotope::variable_count(chirotope::kMaxPoints), static_cast<std::size_t>(variable));
  EXPECT_EQ(chirotope::variable_count(3), 0U);
}

TEST(Chirotope, LiteralsAreTrueForTheSignInTheirOrder) {
  std::mt19937_64 random(1);
  const Points points = sample::random_points(7, 50, random);
  const Signs signs = sample::signs_of(points);
  for (int i = 0; i < 7 * 7 * 7 * 7; ++i) {
    const std::array<int, 4> p{i % 7, i / 7 % 7, i / 49 % 7, i / 343};
    if (std::set<int>(p.begin(), p.end()).size() < 4) continue;
    const Literal literal = chirotope::literal_of(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(chirotope::sign_of(literal, signs),
              sample::sign_of_points(
                  points[static_cast<std::size_t>(p[0])], points[static_cast<std::size_t>(p[1])],
                  points[static_cast<std::size_t>(p[2])], points[static_cast<std::size_t>(p[3])]));
  }
}

TEST(Chirotope, NonsenseIsRefused) {
  EXPECT_THROW((void)chirotope::literal_of(0, 1, 1, 2), core::PreconditionViolated);
  EXPECT_THROW((void)chirotope::literal_of(-1, 1, 3, 2), core::PreconditionViolated);
  EXPECT_THROW((void)chirotope::literal_of(0, 1, 2, 16), core::PreconditionViolated);
  EXPECT_THROW((void)chirotope::points_of(0), core::PreconditionViolated);
  EXPECT_THROW((void)chirotope::points_of(1821), core::PreconditionViolated);
  EXPECT_THROW((void)chirotope::sign_of(6, Signs(5)), core::PreconditionViolated);
  EXPECT_THROW((void)chirotope::pluecker_relations(17), core::PreconditionViolated);
}

TEST(Chirotope, CircuitsAreRadonPartitions) {
  std::mt19937_64 random(2);
  int tried = 0;
  while (tried < 300) {
    // s q_0, .., s q_3 and sum of l_i q_i, s the sum of the l_i: weights l_i and -s.
    Points points = sample::random_points(5, 20, random);
    std::array<std::int64_t, 5> weight{};
    for (std::size_t i = 0; i < 4; ++i) weight[i] = static_cast<std::int64_t>(random() % 19) - 9;
    const std::int64_t sum = weight[0] + weight[1] + weight[2] + weight[3];
    weight[4] = -sum;
    if (std::count(weight.begin(), weight.end(), 0) != 0) continue;
    points[4] = {0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        points[4][k] += weight[i] * points[i][k];
        points[i][k] *= sum;
      }
    std::array<std::size_t, 5> place{0, 1, 2, 3, 4};
    std::rotate(place.begin(), place.begin() + static_cast<int>(random() % 5), place.end());
    Points moved(5);
    std::array<int, 5> side{};
    for (std::size_t i = 0; i < 5; ++i) {
      moved[place[i]] = points[i];
      side[place[i]] = weight[i] > 0 ? 1 : -1;
    }
    const Signs signs = sample::signs_of(moved);
    const auto circuit = chirotope::circuit_of({0, 1, 2, 3, 4});
    const int first = chirotope::sign_of(circuit[0], signs) * side[0];
    EXPECT_NE(first, 0);
    for (std::size_t i = 1; i < 5; ++i)
      EXPECT_EQ(chirotope::sign_of(circuit[i], signs) * side[i], first);
    ++tried;
  }
}

TEST(Chirotope, PointsSatisfyTheClauses) {
  std::mt19937_64 random(3);
  const auto relations = chirotope::grassmann_pluecker_clauses(9);
  const auto acyclic = chirotope::acyclic_clauses(9);
  EXPECT_EQ(relations.size(), 36U * 35U * 16U);
  EXPECT_EQ(acyclic.size(), 126U * 2U);
  for (int i = 0; i < 50; ++i) {
    const Signs signs = sample::signs_of(sample::random_points(9, 100, random));
    EXPECT_TRUE(sample::satisfies_all(signs, relations));
    EXPECT_TRUE(sample::satisfies_all(signs, acyclic));
  }
}

bool is_in_tetrahedron(const Point& p, const Points& corners) {
  const int whole = sample::sign_of_points(corners[0], corners[1], corners[2], corners[3]);
  for (std::size_t i = 0; i < 4; ++i) {
    Points replaced = corners;
    replaced[i] = p;
    if (sample::sign_of_points(replaced[0], replaced[1], replaced[2], replaced[3]) != whole)
      return false;
  }
  return true;
}

/// No point lies in a tetrahedron of others (which suffices, by Caratheodory's theorem).
bool is_in_convex_position(const Points& points) {
  for (const auto& five : chirotope::fives(static_cast<int>(points.size())))
    for (std::size_t alone = 0; alone < 5; ++alone) {
      Points corners;
      for (std::size_t i = 0; i < 5; ++i)
        if (i != alone) corners.push_back(points[five[i]]);
      if (is_in_tetrahedron(points[five[alone]], corners)) return false;
    }
  return true;
}

TEST(Chirotope, ConvexClausesHoldInConvexPositionOnly) {
  std::mt19937_64 random(4);
  const auto clauses = chirotope::convex_clauses(6);
  EXPECT_EQ(clauses.size(), 6U * 10U);
  std::array<int, 2> seen{};
  for (int i = 0; i < 500; ++i) {
    const Points points = sample::random_points(6, 30, random);
    const bool convex = is_in_convex_position(points);
    ++seen[convex ? 1 : 0];
    EXPECT_EQ(sample::satisfies_all(sample::signs_of(points), clauses), convex);
  }
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[1], 20);
  Points curve;
  for (std::int64_t t = 1; t <= 8; ++t) curve.push_back({t, t * t, t * t * t});
  EXPECT_TRUE(sample::satisfies_all(sample::signs_of(curve), chirotope::convex_clauses(8)));
}

std::set<Signs> models(int points, const std::vector<Clause>& clauses) {
  std::set<Signs> result;
  const std::size_t count = chirotope::variable_count(points);
  for (unsigned word = 0; word < 1U << count; ++word) {
    Signs signs(count);
    for (std::size_t i = 0; i < count; ++i) signs[i] = (word >> i & 1U) != 0 ? 1 : -1;
    if (sample::satisfies_all(signs, clauses)) result.insert(signs);
  }
  return result;
}

TEST(Chirotope, NothingIsAskedOfFiveElements) {
  EXPECT_EQ(models(5, chirotope::grassmann_pluecker_clauses(5)).size(), 32U);
}

TEST(Chirotope, SixElementsAreImagesOfOneConfiguration) {
  // Vectors (1, t, t^2, t^3) with increasing t have positive determinants only.
  std::set<Signs> images;
  std::array<std::size_t, 6> order{0, 1, 2, 3, 4, 5};
  do {
    for (unsigned reversed = 0; reversed < 64; ++reversed) {
      Signs signs;
      for (Literal variable = 1; variable <= 15; ++variable) {
        int sign = 1;
        const auto points = chirotope::points_of(variable);
        for (std::size_t i = 0; i < 4; ++i) {
          if ((reversed >> points[i] & 1U) != 0) sign = -sign;
          for (std::size_t k = 0; k < i; ++k)
            if (order[points[k]] > order[points[i]]) sign = -sign;
        }
        signs.push_back(static_cast<std::int8_t>(sign));
      }
      images.insert(signs);
      for (std::int8_t& sign : signs) sign = static_cast<std::int8_t>(-sign);  // a mirror image
      images.insert(signs);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  const std::set<Signs> found = models(6, chirotope::grassmann_pluecker_clauses(6));
  EXPECT_EQ(found.size(), 120U * 32U);
  EXPECT_TRUE(found == images) << images.size();
}

TEST(Chirotope, AcyclicOnesOnSixElementsAreThoseOfPoints) {
  std::vector<Clause> clauses = chirotope::grassmann_pluecker_clauses(6);
  for (const Clause& clause : chirotope::acyclic_clauses(6)) clauses.push_back(clause);
  const std::set<Signs> found = models(6, clauses);
  // Some types are rare; a relabelled or mirrored one is again one of points.
  std::set<Signs> of_points;
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const Signs signs = sample::signs_of(sample::random_points(6, 200, random));
    if (of_points.contains(signs)) continue;
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};
    do {
      for (const int mirror : {+1, -1}) {
        Signs image;
        for (Literal variable = 1; variable <= 15; ++variable) {
          const auto [a, b, c, d] = chirotope::points_of(variable);
          const Literal old = chirotope::literal_of(order[a], order[b], order[c], order[d]);
          image.push_back(static_cast<std::int8_t>(mirror * chirotope::sign_of(old, signs)));
        }
        of_points.insert(image);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  EXPECT_TRUE(found == of_points) << found.size() << " found, " << of_points.size() << " sampled";
}

}  // namespace
