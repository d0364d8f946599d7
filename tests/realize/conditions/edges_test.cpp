// Claim. The edge lemma holds for hexahedra with positive Jacobian, its clauses and inequalities
// are those that the judge accepts, and they say something: some hexahedra with positive corners
// break them. Oracle. The two sides of the lemma as integers, for random hexahedra whose Jacobian
// is proven positive by realize/exact; the judge's own reading of the lemma
// (tables/check/edge_lemma.hpp).
#include "realize/conditions/edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <vector>

#include "realize/conditions/clauses.hpp"
#include "realize/exact/jacobian.hpp"
#include "tables/check/edge_lemma.hpp"
#include "tests/realize/random_points.hpp"

namespace {

using namespace hexatlas;
using conditions::EdgeRelation;
using sample::Points;

Points distorted_cube(std::int64_t range, std::mt19937_64& random) {
  for (;;) {
    Points points = sample::random_points(8, range, random);
    for (unsigned v = 0; v < 8; ++v)
      for (unsigned k = 0; k < 3; ++k) points[v][k] += (v >> k & 1U) != 0 ? 100 : 0;
    const auto signs = sample::signs_of(points);
    if (std::count(signs.begin(), signs.end(), 0) == 0) return points;
  }
}

bool has_positive_jacobian(const Points& points) {
  exact::Hexahedron hexahedron;
  for (std::size_t v = 0; v < 8; ++v)
    hexahedron[v] = {static_cast<double>(points[v][0]), static_cast<double>(points[v][1]),
                     static_cast<double>(points[v][2])};
  return exact::exact_jacobian_verdict(hexahedron, 4).positivity == exact::Positivity::positive;
}

std::int64_t determinant(const Points& p, std::size_t a, std::size_t b, std::size_t c,
                         std::size_t d) {
  std::array<std::array<std::int64_t, 3>, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    m[0][i] = p[b][i] - p[a][i];
    m[1][i] = p[c][i] - p[a][i];
    m[2][i] = p[d][i] - p[a][i];
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

struct Numbers {
  std::int64_t x0, x1, y0, y1;
  int turn;
};

/// Read off the document once more, in coordinates.
Numbers numbers_of(const Points& p, std::size_t v, unsigned axis, std::size_t u, int side) {
  const std::size_t w = v | std::size_t{1} << axis;
  std::size_t i = std::size_t{1} << (axis + 1) % 3, j = std::size_t{1} << (axis + 2) % 3;
  const int factor = side == 1 ? -1 : 1;
  if (side == 2) std::swap(i, j);
  const int si = (v & i) != 0 ? -1 : 1, sj = (v & j) != 0 ? -1 : 1;
  return {si * determinant(p, v, w, v ^ i, u), si * determinant(p, v, w, w ^ i, u),
          sj * determinant(p, v, w, v ^ j, u), sj * determinant(p, v, w, w ^ j, u),
          factor * sign(determinant(p, v, w, v ^ i, w ^ i))};
}

TEST(Edges, TheLemmaHoldsForPositiveJacobians) {
  std::mt19937_64 random(5);
  int cases = 0, inequalities = 0, hexahedra = 0;
  for (int tried = 0; tried < 4000; ++tried) {
    const Points points = distorted_cube(70, random);
    if (!has_positive_jacobian(points)) continue;
    ++hexahedra;
    const auto signs = sample::signs_of(points);
    for (const EdgeRelation& relation : conditions::edge_relations()) {
      const Numbers n =
          numbers_of(points, relation.tail, relation.axis, relation.apex, relation.side);
      EXPECT_EQ(chirotope::sign_of(relation.x0, signs), sign(n.x0));
      EXPECT_EQ(chirotope::sign_of(relation.x1, signs), sign(n.x1));
      EXPECT_EQ(chirotope::sign_of(relation.y0, signs), sign(n.y0));
      EXPECT_EQ(chirotope::sign_of(relation.y1, signs), sign(n.y1));
      EXPECT_EQ(chirotope::sign_of(relation.turn, signs), n.turn);
      if (sign(n.x0) == sign(n.x1)) continue;
      ++cases;
      const std::int64_t sum = n.y0 * std::abs(n.x1) + n.y1 * std::abs(n.x0);
      EXPECT_EQ(sign(sum), n.turn * sign(n.x0));
      if (const auto larger = conditions::larger_product(relation, signs)) {
        ++inequalities;
        EXPECT_EQ(std::abs(n.y0) * std::abs(n.x1) > std::abs(n.y1) * std::abs(n.x0), *larger == 1);
      }
    }
    EXPECT_TRUE(sample::satisfies_all(signs, conditions::edge_clauses()));
  }
  EXPECT_GT(hexahedra, 50);
  EXPECT_GT(cases, 1000);
  EXPECT_GT(inequalities, 100);
}

TEST(Edges, TheyRefuseSomeHexahedraWithPositiveCorners) {
  std::mt19937_64 random(6);
  int refused = 0;
  for (int tried = 0; tried < 20000 && refused == 0; ++tried) {
    const Points points = distorted_cube(150, random);
    const auto signs = sample::signs_of(points);
    if (!sample::satisfies_all(signs, conditions::corner_clauses())) continue;
    if (sample::satisfies_all(signs, conditions::edge_clauses())) continue;
    ++refused;
    EXPECT_FALSE(has_positive_jacobian(points));
  }
  EXPECT_GT(refused, 0);
}

TEST(Edges, TheJudgeReadsTheLemmaInTheSameWay) {
  const auto relations = conditions::edge_relations();
  EXPECT_EQ(relations.size(), 48U);
  const auto clauses = conditions::edge_clauses();
  EXPECT_EQ(clauses.size(), 192U);
  for (const auto& clause : clauses) {
    const auto denied = check::denied_signs(clause, 8);
    ASSERT_TRUE(denied);
    EXPECT_TRUE(check::contradicts_edge(*denied));
    for (std::size_t i = 0; i < clause.size(); ++i) {
      auto turned = *denied;
      turned[i].sign = -turned[i].sign;
      const bool listed = std::any_of(clauses.begin(), clauses.end(), [&](const auto& other) {
        const auto same = check::denied_signs(other, 8);
        return std::all_of(same->begin(), same->end(), [&](const check::DeniedSign& one) {
          return std::any_of(turned.begin(), turned.end(), [&](const check::DeniedSign& t) {
            return t.four == one.four && t.sign == one.sign;
          });
        });
      });
      EXPECT_EQ(check::contradicts_edge(turned), listed);
    }
  }
  for (std::uint8_t tail = 0; tail < 9; ++tail)
    for (std::uint8_t axis = 0; axis < 4; ++axis)
      for (std::uint8_t apex = 0; apex < 9; ++apex)
        for (std::uint8_t side = 0; side < 4; ++side)
          EXPECT_EQ(conditions::edge_relation(tail, axis, apex, side).has_value(),
                    check::edge_case(tail, axis, apex, side).has_value());
}

TEST(Edges, TheJudgeDrawsTheSameInequalities) {
  std::mt19937_64 random(7);
  int drawn = 0;
  for (int tried = 0; tried < 200; ++tried) {
    const Points points = sample::random_points(8, 50, random);
    const auto signs = sample::signs_of(points);
    std::vector<check::DeniedSign> all;
    std::vector<std::int32_t> clause;
    for (std::size_t i = 0; i < signs.size(); ++i)
      clause.push_back(static_cast<std::int32_t>(i + 1) * -signs[i]);
    all = *check::denied_signs(clause, 8);
    for (const EdgeRelation& r : conditions::edge_relations()) {
      const auto larger = conditions::larger_product(r, signs);
      const auto edge = check::edge_case(r.tail, r.axis, r.apex, r.side);
      for (const std::uint64_t which : {1U, 2U})
        EXPECT_EQ(check::implies_larger(*edge, all, which), larger && *larger == which);
      drawn += larger ? 1 : 0;
    }
  }
  EXPECT_GT(drawn, 100);
}

}  // namespace
