// Claim. Points that are found realize the triangulation under the condition and are small; where
// the condition cannot hold, none are found; the same search finds the same points. The slacks and
// Jacobian coefficients that the search follows have the derivatives that it is told.
// Oracle. Separating and supporting planes and corner determinants, which know no Radon partitions;
// differences instead of derivatives; the exact signs of the coefficients.
#include "realize/solve/coordinates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "realize/exact/jacobian.hpp"
#include "realize/solve/coordinates_clauses.hpp"
#include "realize/solve/coordinates_descent.hpp"
#include "realize/solve/coordinates_jacobian.hpp"
#include "realize/solve/coordinates_slack.hpp"
#include "tests/realize/conditions/separating_planes.hpp"

namespace {

using namespace hexatlas;
using certificate::Condition;
using certificate::Realization;
using complex::Triangulation;
using complex::VertexSet;

Triangulation triangulation_of(int vertices, const std::string& text) {
  Triangulation result{vertices, {}};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    unsigned set = 0;
    for (const char digit : word) set |= 1U << static_cast<unsigned>(digit - '0');
    result.tetrahedra.push_back(static_cast<VertexSet>(set));
  }
  std::sort(result.tetrahedra.begin(), result.tetrahedra.end());
  return result;
}

/// The signs with the facets of the hexahedron counter-clockwise from outside: its corner 0 has the
/// boundary triangle 0 4 2 or the boundary triangles at the diagonal 0 6.
std::vector<int> signs_of_hexahedron(const Triangulation& triangulation) {
  std::vector<int> signs = *complex::orientation_of(triangulation);
  for (const std::array<std::size_t, 3>& outer :
       {std::array<std::size_t, 3>{0, 4, 6}, std::array<std::size_t, 3>{0, 4, 2}}) {
    const unsigned triangle = 1U << outer[0] | 1U << outer[1] | 1U << outer[2];
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < signs.size(); ++i)
      if ((triangulation.tetrahedra[i] & triangle) == triangle) at.push_back(i);
    if (at.size() != 1) continue;
    const auto apex =
        static_cast<std::size_t>(std::countr_zero(triangulation.tetrahedra[at[0]] ^ triangle));
    // The sign of outer[0], outer[1], outer[2], apex is negative; so that of the ascending order
    // is:
    std::array<std::size_t, 4> order{outer[0], outer[1], outer[2], apex};
    int sign = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (order[j] > order[i]) sign = -sign;
    if (signs[at[0]] != sign)
      for (int& s : signs) s = -s;
    return signs;
  }
  return {};
}

bool realizes(const Realization& points, const Triangulation& triangulation,
              const std::vector<int>& signs, Condition condition) {
  if (!oracle::in_general_position(points)) return false;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const auto [a, b, c, d] = complex::vertices_of(triangulation.tetrahedra[i]);
    if (oracle::side(points, a, b, c, d) != signs[i]) return false;
  }
  if (!oracle::all_meet_properly(triangulation.tetrahedra, points)) return false;
  if (condition == Condition::convex) return oracle::in_convex_position(points);
  for (std::size_t v = 0; v < 8 && condition == Condition::jacobian; ++v) {
    const int parity = std::popcount(v) % 2 == 0 ? 1 : -1;
    if (parity * oracle::side(points, v, v ^ 1U, v ^ 2U, v ^ 4U) <= 0) return false;
  }
  return true;
}

// Triangulations of the hexahedron; the last column says under which conditions points exist.
struct Known {
  const char* tetrahedra;
  bool embedded, other;
};
const std::array<Known, 5> kKnown{{
    {"0124 1237 1247 1457 2467", true, true},
    {"0134 0234 1234 1235 1246 0156 1256 0147 2357 0457 0167 1467 0567 2567", true, false},
    {"0124 0134 1234 0136 0346 2346 0156 0457 1367 0467 0567 1567", true, true},
    {"0124 0134 1234 0135 0345 2345 1356 2356 0247 2457 0267 1367 0467 1567 2567", false, false},
    {"0124 0134 1234 0345 2345 0136 0356 2356 0157 2457 0167 1367 2467 0567 2567", true, true},
}};

TEST(Coordinates, Hexahedra) {
  for (const Known& known : kKnown) {
    const Triangulation triangulation = triangulation_of(8, known.tetrahedra);
    const std::vector<int> signs = signs_of_hexahedron(triangulation);
    for (const Condition condition : certificate::kConditions) {
      solve::SearchEffort effort;
      const bool exists = condition == Condition::embedded ? known.embedded : known.other;
      effort.starts = exists ? 25 : 5;
      effort.shrink_starts = 1;
      effort.repair_steps = 100;
      const auto points = solve::find_realization(triangulation, signs, condition, effort);
      ASSERT_EQ(points.has_value(), exists) << known.tetrahedra << name_of(condition);
      if (!points) continue;
      EXPECT_TRUE(realizes(*points, triangulation, signs, condition)) << known.tetrahedra;
      EXPECT_LE(solve::extent_of(*points), condition == Condition::jacobian ? 8 : 4);
      EXPECT_EQ(points, solve::find_realization(triangulation, signs, condition, effort));
    }
  }
}

/// Mirrored signs have mirrored points.
TEST(Coordinates, MirrorImage) {
  const Triangulation triangulation = triangulation_of(8, kKnown[2].tetrahedra);
  std::vector<int> signs = signs_of_hexahedron(triangulation);
  for (int& s : signs) s = -s;
  solve::SearchEffort effort;
  effort.shrink_starts = 0;
  const auto points = solve::find_realization(triangulation, signs, Condition::convex, effort);
  ASSERT_TRUE(points.has_value());
  EXPECT_TRUE(realizes(*points, triangulation, signs, Condition::convex));
}

/// The cone over an octahedron from inside, and a row of tetrahedra on twelve vertices.
TEST(Coordinates, OtherBalls) {
  const Triangulation cone = triangulation_of(7, "0246 0256 0346 0356 1246 1256 1346 1356");
  Triangulation row{12, {}};
  for (int v = 0; v + 3 < row.vertices; ++v)
    row.tetrahedra.push_back(static_cast<VertexSet>(0b1111U << static_cast<unsigned>(v)));
  for (const Triangulation& ball : {cone, row}) {
    const std::vector<int> signs = *complex::orientation_of(ball);
    for (const Condition condition : {Condition::embedded, Condition::convex}) {
      solve::SearchEffort effort;
      effort.starts = 10;
      effort.shrink_starts = 0;
      const auto points = solve::find_realization(ball, signs, condition, effort);
      // A vertex inside the ball is no extreme point.
      const bool exists = condition == Condition::embedded || ball.vertices == 12;
      ASSERT_EQ(points.has_value(), exists);
      if (points) {
        EXPECT_TRUE(realizes(*points, ball, signs, condition));
      }
    }
  }
}

TEST(Coordinates, GivenChirotope) {
  const Triangulation triangulation = triangulation_of(8, kKnown[2].tetrahedra);
  const std::vector<int> signs = signs_of_hexahedron(triangulation);
  solve::SearchEffort effort;
  effort.shrink_starts = 0;
  const auto points = solve::find_realization(triangulation, signs, Condition::embedded, effort);
  ASSERT_TRUE(points.has_value());
  chirotope::Signs wanted;
  for (std::size_t i = 0; i < chirotope::variable_count(8); ++i) {
    const auto [a, b, c, d] = chirotope::points_of(static_cast<certificate::Literal>(i + 1));
    wanted.push_back(static_cast<std::int8_t>(oracle::side(*points, a, b, c, d)));
  }
  effort.seed = 2;
  const auto again =
      solve::find_realization_of(wanted, triangulation, signs, Condition::embedded, effort);
  ASSERT_TRUE(again.has_value());
  EXPECT_TRUE(realizes(*again, triangulation, signs, Condition::embedded));
  // Against the sign of a tetrahedron nothing can be found.
  for (std::int8_t& sign : wanted) sign = static_cast<std::int8_t>(-sign);
  EXPECT_FALSE(
      solve::find_realization_of(wanted, triangulation, signs, Condition::embedded, effort));
}

TEST(Coordinates, Derivatives) {
  std::mt19937_64 random(20261125);
  const Triangulation triangulation = triangulation_of(8, kKnown[2].tetrahedra);
  const auto conditions = solve::sign_conditions(triangulation, signs_of_hexahedron(triangulation),
                                                 Condition::jacobian, {});
  solve::CoordinateSlacks slacks(conditions, Condition::jacobian);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> points(24);
    for (double& x : points) x = 2 * solve::uniform(random) - 1;
    const std::size_t count = slacks.at(points).size();
    std::vector<double> weights(count);
    for (double& w : weights) w = solve::uniform(random);
    const auto value = [&] {
      double sum = 0;
      const auto now = slacks.at(points);
      for (std::size_t i = 0; i < count; ++i) sum += weights[i] * now[i];
      return sum;
    };
    std::vector<double> gradient(24, 0.0);
    (void)slacks.at(points);
    slacks.add_derivative(weights, gradient);
    for (std::size_t i = 0; i < 24; ++i) {
      constexpr double kStep = 1e-6;
      const double x = points[i];
      points[i] = x + kStep;
      const double above = value();
      points[i] = x - kStep;
      const double below = value();
      points[i] = x;
      ASSERT_NEAR(gradient[i], (above - below) / (2 * kStep), 1e-4);
    }
  }
}

TEST(Coordinates, SignsOfJacobianCoefficients) {
  std::mt19937_64 random(20261126);
  solve::JacobianCoefficients coefficients;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<double> points(24);
    exact::Hexahedron corners{};
    for (double& x : points) x = static_cast<double>(random() % 9);
    for (std::size_t v = 0; v < 8; ++v)
      corners[v] = {points[3 * v], points[3 * v + 1], points[3 * v + 2]};
    const auto expected = exact::signs_of_jacobian_coefficients(corners);
    const auto& values = coefficients.at(points);
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_EQ((values[i] > 0) - (values[i] < 0), static_cast<int>(expected[i]));
  }
}

}  // namespace
