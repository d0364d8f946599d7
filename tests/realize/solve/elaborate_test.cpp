// Claim. The solver is right about small problems; its proofs become proofs with hints that are
// valid, trimmed and shortened or not; a proof that is cut off is noticed. Oracle. All assignments,
// one after the other; a strict check of hints (strict_rup.hpp).
#include "realize/solve/elaborate.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "enum/core/errors.hpp"
#include "realize/solve/elaborate_shorten.hpp"
#include "tests/realize/solve/strict_rup.hpp"

namespace {

using namespace hexatlas;
using solve::Assignment;
using solve::Clause;
using solve::RupProof;

bool satisfies(const Assignment& assignment, const std::vector<Clause>& clauses) {
  for (const Clause& clause : clauses) {
    bool is_true = false;
    for (const auto literal : clause)
      is_true =
          is_true || assignment[static_cast<std::size_t>(std::abs(literal)) - 1] == (literal > 0);
    if (!is_true) return false;
  }
  return true;
}

bool is_satisfiable(const std::vector<Clause>& clauses, std::size_t variables) {
  for (unsigned word = 0; word < 1U << variables; ++word) {
    Assignment assignment(variables);
    for (std::size_t i = 0; i < variables; ++i) assignment[i] = (word >> i & 1U) != 0;
    if (satisfies(assignment, clauses)) return true;
  }
  return false;
}

/// Clauses of up to three literals; some repeat a literal or contain it with its negation.
std::vector<Clause> random_clauses(std::size_t count, unsigned variables, std::mt19937_64& random) {
  std::vector<Clause> clauses(count);
  for (Clause& clause : clauses) {
    const std::size_t size = random() % 16 == 0 ? 1 + random() % 2 : 3;
    for (std::size_t i = 0; i < size; ++i) {
      const auto variable = static_cast<std::int32_t>(1 + random() % variables);
      clause.push_back(random() % 2 == 0 ? variable : -variable);
    }
  }
  return clauses;
}

std::vector<Clause> clauses_at(const std::vector<Clause>& clauses,
                               const std::vector<std::uint32_t>& indices) {
  std::vector<Clause> result;
  result.reserve(indices.size());
  for (const std::uint32_t index : indices) result.push_back(clauses[index]);
  return result;
}

/// n + 1 pigeons in n holes.
std::vector<Clause> pigeons(int holes) {
  const auto sits = [&](int pigeon, int hole) { return 1 + pigeon * holes + hole; };
  std::vector<Clause> clauses;
  for (int p = 0; p <= holes; ++p) {
    Clause somewhere;
    for (int h = 0; h < holes; ++h) somewhere.push_back(sits(p, h));
    clauses.push_back(somewhere);
    for (int q = 0; q < p; ++q)
      for (int h = 0; h < holes; ++h) clauses.push_back({-sits(p, h), -sits(q, h)});
  }
  return clauses;
}

TEST(Elaborate, RandomProblems) {
  std::mt19937_64 random(1);
  int refuted = 0;
  for (int i = 0; i < 400; ++i) {
    const auto clauses = random_clauses(30 + random() % 30, 10, random);
    const bool satisfiable = is_satisfiable(clauses, 10);
    const auto answer = solve::solve_or_prove(
        clauses, 10, {.seed = random() % 3, .inprocessing = random() % 2 == 0});
    const auto* proof = std::get_if<RupProof>(&answer);
    ASSERT_EQ(proof == nullptr, satisfiable);
    EXPECT_EQ(solve::short_refutation(clauses, 10, 1).has_value(), !satisfiable);
    if (satisfiable) {
      EXPECT_TRUE(satisfies(std::get<Assignment>(answer), clauses));
      continue;
    }
    ++refuted;
    const auto lemmas = solve::elaborate(clauses, *proof);
    ASSERT_TRUE(lemmas.has_value());
    EXPECT_TRUE(sample::is_refutation(clauses, *lemmas));
    const auto trimmed = solve::trimmed(clauses.size(), *lemmas);
    EXPECT_TRUE(sample::is_refutation(clauses_at(clauses, trimmed.premises), trimmed.lemmas));
  }
  EXPECT_GT(refuted, 100);
  EXPECT_LT(refuted, 300);
}

TEST(Elaborate, IncrementalSolver) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20; ++i) {
    std::vector<Clause> clauses;
    solve::SatSolver solver(9);
    bool satisfiable = true;
    while (satisfiable) {
      for (const Clause& clause : random_clauses(4, 9, random)) {
        clauses.push_back(clause);
        solver.add(clause);
      }
      satisfiable = is_satisfiable(clauses, 9);
      const auto model = solver.solve(random());
      ASSERT_EQ(model.has_value(), satisfiable);
      EXPECT_TRUE(!model || satisfies(*model, clauses));
    }
  }
}

TEST(Elaborate, SeedsGiveDifferentModelsAndEachSeedTheSame) {
  const std::vector<Clause> clauses{{1, 2}, {-3, 4}, {5, -6}};
  std::vector<Assignment> first;
  std::vector<Assignment> second;
  for (std::vector<Assignment>* models : {&first, &second}) {
    solve::SatSolver solver(40);
    for (const Clause& clause : clauses) solver.add(clause);
    for (std::uint64_t seed = 0; seed < 10; ++seed) models->push_back(*solver.solve(seed));
  }
  EXPECT_EQ(first, second);
  for (std::size_t i = 1; i < first.size(); ++i) EXPECT_NE(first[i], first[0]);
}

TEST(Elaborate, PigeonsBothWays) {
  const auto clauses = pigeons(6);
  for (const bool inprocessing : {false, true}) {
    const auto answer =
        solve::solve_or_prove(clauses, 42, {.seed = 0, .inprocessing = inprocessing});
    const auto lemmas = solve::elaborate(clauses, std::get<RupProof>(answer));
    ASSERT_TRUE(lemmas.has_value());
    EXPECT_TRUE(sample::is_refutation(clauses, *lemmas));
    EXPECT_GT(lemmas->size(), 20U);
  }
}

TEST(Elaborate, ShortRefutationsAreValidShorterAndRepeatable) {
  const auto clauses = pigeons(4);
  const auto answer = solve::solve_or_prove(clauses, 20, {});
  const auto trimmed =
      solve::trimmed(clauses.size(), *solve::elaborate(clauses, std::get<RupProof>(answer)));
  const auto shorter = solve::short_refutation(clauses, 20, 3);
  ASSERT_TRUE(shorter.has_value());
  EXPECT_TRUE(sample::is_refutation(clauses_at(clauses, shorter->premises), shorter->lemmas));
  EXPECT_LE(solve::length_of(*shorter, clauses), solve::length_of(trimmed, clauses));
  const auto again = solve::short_refutation(clauses, 20, 3);
  EXPECT_EQ(again->premises, shorter->premises);
  EXPECT_EQ(again->lemmas, shorter->lemmas);
}

TEST(Elaborate, AProofCutOffIsNoProof) {
  const auto clauses = pigeons(5);
  const auto answer = solve::solve_or_prove(clauses, 30, {});
  const RupProof& proof = std::get<RupProof>(answer);
  int refused = 0;
  for (std::size_t length = 0; length < proof.size(); ++length) {
    const auto lemmas = solve::elaborate(clauses, std::span(proof).first(length));
    EXPECT_TRUE(!lemmas || sample::is_refutation(clauses, *lemmas));
    if (!lemmas) ++refused;
  }
  EXPECT_GT(refused, 20);
}

TEST(Elaborate, BytesCutOffAreNoticed) {
  using namespace std::string_literals;
  // 300 is written in two bytes, least seven bits first: 2 * 300 = 88 + 4 * 128.
  const std::string bytes = "a\xD8\x04\x03\x00"s + "d\x04\x00"s + "a\x00"s;
  const RupProof proof{{false, {300, -1}}, {true, {2}}, {false, {}}};
  EXPECT_EQ(solve::read_binary_drat(bytes), proof);
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    if (size == 5 || size == 8) continue;  // ends of steps
    EXPECT_THROW((void)solve::read_binary_drat(bytes.substr(0, size)), core::ResourceFailure);
  }
  EXPECT_THROW((void)solve::read_binary_drat("b\x00"s), core::ResourceFailure);
  EXPECT_THROW((void)solve::read_binary_drat("a\x01\x00"s), core::ResourceFailure);
  EXPECT_THROW((void)solve::read_binary_drat("a\xFF\xFF\xFF\xFF\xFF\xFF\x00"s),
               core::ResourceFailure);
}

TEST(Elaborate, LemmasThatDoNotFollowArePassedOver) {
  const std::vector<Clause> clauses{{1, 2}, {1, -2}, {-1, 3}, {-1, -3}};
  const RupProof helpful{{false, {3}}, {false, {1}}, {false, {}}};
  const auto lemmas = solve::elaborate(clauses, helpful);
  ASSERT_TRUE(lemmas.has_value());
  EXPECT_TRUE(sample::is_refutation(clauses, *lemmas));
  const RupProof harmful{{false, {3}}, {false, {-3}}, {false, {}}};
  EXPECT_FALSE(solve::elaborate(std::span(clauses).first(3), harmful).has_value());
  const RupProof deleting{{true, {1, 2}}, {false, {1}}, {false, {}}};
  EXPECT_FALSE(solve::elaborate(clauses, deleting).has_value());
}

TEST(Elaborate, ContradictionsAmongThePremisesNeedNoLemma) {
  for (const std::vector<Clause>& clauses :
       {std::vector<Clause>{{1}, {-1}}, std::vector<Clause>{{2, 2}, {-2, 3}, {1, -1}, {-3, -2, -3}},
        std::vector<Clause>{{1, 2}, {}}}) {
    const auto lemmas = solve::elaborate(clauses, {});
    ASSERT_TRUE(lemmas.has_value());
    EXPECT_EQ(lemmas->size(), 1U);
    EXPECT_TRUE(sample::is_refutation(clauses, *lemmas));
    EXPECT_TRUE(solve::short_refutation(clauses, 3, 2).has_value());
  }
}

TEST(Elaborate, NonsenseIsRefused) {
  EXPECT_THROW((void)solve::elaborate(std::vector<Clause>{{0}}, {}), core::PreconditionViolated);
  EXPECT_THROW((void)solve::solve_or_prove(std::vector<Clause>{{3}}, 2, {}),
               core::PreconditionViolated);
  EXPECT_THROW((void)solve::short_refutation({}, 2, 0), core::PreconditionViolated);
  solve::SatSolver solver(2);
  EXPECT_THROW(solver.add({-3}), core::PreconditionViolated);
}

}  // namespace
