#include "realize/chirotope/chirotope.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::chirotope {
namespace {

constexpr std::size_t choose(int n, int k) {
  std::size_t result = 1;
  for (int i = 0; i < k; ++i)
    result =
        result * static_cast<std::size_t>(std::max(n - i, 0)) / static_cast<std::size_t>(i + 1);
  return result;
}

void expect_points(int points) {
  core::expects(points >= 0 && points <= kMaxPoints, "chirotope: at most 16 points");
}

/// Calls visit(subset) for each k-subset of 0 .. n-1, in lexicographic order.
template <std::size_t kSize, class Visit>
void for_each_subset(int n, const Visit& visit) {
  std::array<std::uint8_t, kSize> subset{};
  for (std::size_t i = 0; i < kSize; ++i) subset[i] = static_cast<std::uint8_t>(i);
  if (n < static_cast<int>(kSize)) return;
  while (true) {
    visit(subset);
    std::size_t place = kSize;
    while (place > 0 && subset[place - 1] == n - static_cast<int>(kSize - place) - 1) --place;
    if (place == 0) return;
    ++subset[place - 1];
    for (std::size_t i = place; i < kSize; ++i)
      subset[i] = static_cast<std::uint8_t>(subset[i - 1] + 1);
  }
}

}  // namespace

std::size_t variable_count(int points) {
  expect_points(points);
  return choose(points, 4);
}

Literal literal_of(int a, int b, int c, int d) {
  std::array<int, 4> points{a, b, c, d};
  Literal sign = 1;
  for (std::size_t end = 3; end > 0; --end)
    for (std::size_t i = 0; i < end; ++i)
      if (points[i] > points[i + 1]) {
        std::swap(points[i], points[i + 1]);
        sign = -sign;
      }
  core::expects(points[0] >= 0 && points[3] < kMaxPoints && points[0] < points[1] &&
                    points[1] < points[2] && points[2] < points[3],
                "chirotope: four distinct points below 16");
  std::size_t variable = 1;
  for (std::size_t i = 0; i < 4; ++i) variable += choose(points[i], static_cast<int>(i) + 1);
  return sign * static_cast<Literal>(variable);
}

std::array<std::uint8_t, 4> points_of(Literal variable) {
  core::expects(variable >= 1 && static_cast<std::size_t>(variable) <= variable_count(kMaxPoints),
                "chirotope: a variable of 16 points");
  auto rest = static_cast<std::size_t>(variable - 1);
  std::array<std::uint8_t, 4> points{};
  for (int size = 4; size > 0; --size) {
    int point = size - 1;
    while (choose(point + 1, size) <= rest) ++point;
    rest -= choose(point, size);
    points[static_cast<std::size_t>(size - 1)] = static_cast<std::uint8_t>(point);
  }
  return points;
}

int sign_of(Literal literal, const Signs& signs) {
  const auto variable = static_cast<std::size_t>(std::abs(literal));
  core::expects(variable >= 1 && variable <= signs.size(), "chirotope: a literal of these signs");
  return literal > 0 ? signs[variable - 1] : -signs[variable - 1];
}

std::vector<PlueckerRelation> pluecker_relations(int points) {
  expect_points(points);
  std::vector<PlueckerRelation> relations;
  for_each_subset<2>(points, [&](const std::array<std::uint8_t, 2>& common) {
    for_each_subset<4>(points - 2, [&](std::array<std::uint8_t, 4> others) {
      for (std::uint8_t& other : others) {  // the others are numbered without the common two
        if (other >= common[0]) ++other;
        if (other >= common[1]) ++other;
      }
      relations.push_back({common, others});
    });
  });
  return relations;
}

PlueckerProducts products_of(const PlueckerRelation& relation) {
  const auto [a, b] = relation.common;
  const auto [w, x, y, z] = relation.others;
  return {{{literal_of(a, b, w, x), literal_of(a, b, y, z)},
           {-literal_of(a, b, w, y), literal_of(a, b, x, z)},
           {literal_of(a, b, w, z), literal_of(a, b, x, y)}}};
}

std::array<Literal, 5> circuit_of(const std::array<std::uint8_t, 5>& points) {
  std::array<Literal, 5> circuit{};
  for (std::size_t left_out = 0; left_out < 5; ++left_out) {
    std::array<std::uint8_t, 4> rest{};
    for (std::size_t i = 0; i < 4; ++i) rest[i] = points[i < left_out ? i : i + 1];
    const Literal literal = literal_of(rest[0], rest[1], rest[2], rest[3]);
    circuit[left_out] = left_out % 2 == 0 ? literal : -literal;
  }
  return circuit;
}

std::vector<std::array<std::uint8_t, 5>> fives(int points) {
  expect_points(points);
  std::vector<std::array<std::uint8_t, 5>> result;
  for_each_subset<5>(points,
                     [&](const std::array<std::uint8_t, 5>& five) { result.push_back(five); });
  return result;
}

std::array<Clause, 2> not_all_equal(std::span<const Literal> literals) {
  std::array<Clause, 2> clauses{Clause(literals.begin(), literals.end()), Clause{}};
  for (const Literal literal : literals) clauses[1].push_back(-literal);
  return clauses;
}

std::vector<Clause> grassmann_pluecker_clauses(int points) {
  std::vector<Clause> clauses;
  for (const PlueckerRelation& relation : pluecker_relations(points)) {
    const PlueckerProducts products = products_of(relation);
    // One clause per assignment that makes the three products equal: a common sign, and in each
    // product a free sign of its first factor. The clause has the literals that are false then.
    for (const int product : {+1, -1})
      for (unsigned choice = 0; choice < 8; ++choice) {
        Clause clause;
        for (std::size_t i = 0; i < 3; ++i) {
          const int first = (choice >> i & 1U) != 0 ? +1 : -1;
          clause.push_back(-first * products[i][0]);
          clause.push_back(-first * product * products[i][1]);
        }
        clauses.push_back(std::move(clause));
      }
  }
  return clauses;
}

std::vector<Clause> acyclic_clauses(int points) {
  std::vector<Clause> clauses;
  for (const auto& five : fives(points))
    for (Clause& clause : not_all_equal(circuit_of(five))) clauses.push_back(std::move(clause));
  return clauses;
}

std::vector<Clause> convex_clauses(int points) {
  std::vector<Clause> clauses;
  for (const auto& five : fives(points))
    for (std::size_t alone = 0; alone < 5; ++alone) {
      std::array<Literal, 5> circuit = circuit_of(five);
      circuit[alone] = -circuit[alone];
      for (Clause& clause : not_all_equal(circuit)) clauses.push_back(std::move(clause));
    }
  return clauses;
}

}  // namespace hexatlas::chirotope
