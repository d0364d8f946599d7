// Claim. The checker of LRAT proofs accepts a lemma exactly if its hints are, one after the other,
// unit and at last empty; hence whatever it accepts follows from the premises.
// Oracle. On random formulas with few variables: a second reading of the rule with sets of
// literals, and truth tables. Refutations come from a search by cases; they are mutated, and read
// against formulas that are satisfiable.
#include "tables/check/lrat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "tables/check/malformed.hpp"
#include "tests/share.hpp"

namespace hexatlas::check {
namespace {

using Formula = std::vector<Literals>;
using Hints = std::vector<std::uint32_t>;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }

  Literals clause(std::size_t variables, std::size_t most) {
    Literals literals(below(most + 1));
    for (std::int32_t& literal : literals) {
      literal = static_cast<std::int32_t>(below(variables)) + 1;
      if (below(2) == 0) literal = -literal;
    }
    return literals;
  }

 private:
  std::mt19937_64 engine_;
};

bool is_true(const Literals& clause, std::uint32_t model) {
  return std::any_of(clause.begin(), clause.end(), [model](std::int32_t literal) {
    return ((model >> (std::abs(literal) - 1) & 1U) != 0) == (literal > 0);
  });
}

/// By truth table: each model of the formula is one of the clause.
bool implies(const Formula& formula, const Literals& clause, std::size_t variables) {
  for (std::uint32_t model = 0; model < 1U << variables; ++model) {
    const bool is_model = std::all_of(formula.begin(), formula.end(),
                                      [model](const Literals& c) { return is_true(c, model); });
    if (is_model && !is_true(clause, model)) return false;
  }
  return true;
}

/// The rule, with sets of literals.
bool follows_by_sets(const Formula& clauses, const Literals& lemma, const Hints& hints) {
  std::set<std::int32_t> holds;
  for (const std::int32_t literal : lemma) holds.insert(-literal);
  for (const std::int32_t literal : lemma) {
    if (holds.count(literal) != 0) return hints.empty();
  }
  for (std::size_t i = 0; i < hints.size(); ++i) {
    if (hints[i] == 0 || hints[i] > clauses.size()) return false;
    std::set<std::int32_t> left;
    for (const std::int32_t literal : clauses[hints[i] - 1]) {
      if (holds.count(-literal) == 0) left.insert(literal);
    }
    if (left.empty()) return i + 1 == hints.size();
    if (left.size() > 1 || holds.count(*left.begin()) != 0) return false;
    holds.insert(*left.begin());
  }
  return false;
}

/// Refutes by cases: each lemma is the negation of the decisions, and follows from those of its two
/// cases.
class Refuter {
 public:
  Refuter(Formula formula, std::size_t variables)
      : clauses_(std::move(formula)), variables_(variables) {}

  /// Whether the formula is unsatisfiable; then text() is a refutation unless it has an empty
  /// clause.
  bool run() { return falsified() != 0; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] bool is_falsified(const Literals& clause) const {
    return std::all_of(clause.begin(), clause.end(), [this](std::int32_t literal) {
      return std::count(decisions_.begin(), decisions_.end(), -literal) != 0;
    });
  }

  /// Number of a clause that the decisions make false, 0 if there is a model.
  std::uint32_t falsified() {
    for (std::uint32_t i = 0; i < clauses_.size(); ++i) {
      if (is_falsified(clauses_[i])) return i + 1;
    }
    if (decisions_.size() == variables_) return 0;
    const auto variable = static_cast<std::int32_t>(decisions_.size() + 1);
    Hints hints;
    for (const std::int32_t decision : {variable, -variable}) {
      decisions_.push_back(decision);
      hints.push_back(falsified());
      decisions_.pop_back();
      if (hints.back() == 0) return 0;
      if (is_falsified(clauses_[hints.back() - 1])) return hints.back();
    }
    Literals lemma;
    for (const std::int32_t decision : decisions_) lemma.push_back(-decision);
    clauses_.push_back(lemma);
    text_ += std::to_string(clauses_.size());
    for (const std::int32_t literal : lemma) text_ += " " + std::to_string(literal);
    text_ += " 0 " + std::to_string(hints[0]) + " " + std::to_string(hints[1]) + " 0\n";
    return static_cast<std::uint32_t>(clauses_.size());
  }

  Formula clauses_;
  std::size_t variables_;
  std::vector<std::int32_t> decisions_;
  std::string text_;
};

LratChecker checker_of(const Formula& formula, std::size_t variables) {
  LratChecker checker(variables);
  for (const Literals& clause : formula) EXPECT_TRUE(checker.add_premise(clause));
  return checker;
}

bool accepts(const Formula& formula, std::size_t variables, const std::string& text) {
  LratChecker checker = checker_of(formula, variables);
  try {
    return fault_of_lrat(checker, text, "proof").empty();
  } catch (const Malformed&) {
    return false;
  }
}

TEST(Lrat, AgreesWithTheRuleOnSetsAndWithTruthTables) {
  constexpr std::size_t kVariables = 4;
  Dice dice(1);
  std::size_t accepted = 0;
  for (int round = 0; round < 30000; ++round) {
    Formula clauses;
    for (std::size_t i = 2 + dice.below(6); i > 0; --i) {
      clauses.push_back(dice.clause(kVariables, 3));
    }
    const std::size_t premises = clauses.size();
    LratChecker checker = checker_of(clauses, kVariables);
    for (int step = 0; step < 8; ++step) {
      const Literals lemma = dice.clause(kVariables, 4);
      Hints hints(dice.below(5));
      for (std::uint32_t& hint : hints) {
        hint = static_cast<std::uint32_t>(dice.below(clauses.size() + 2));
      }
      const bool expected = follows_by_sets(clauses, lemma, hints);
      ASSERT_EQ(checker.add_lemma(lemma, hints), expected);
      if (!expected) continue;
      ++accepted;
      clauses.push_back(lemma);
      const Formula given(clauses.begin(), clauses.begin() + static_cast<std::ptrdiff_t>(premises));
      ASSERT_TRUE(implies(given, lemma, kVariables));
      ASSERT_EQ(checker.size(), clauses.size());
    }
  }
  EXPECT_GT(accepted, 5000U);
}

TEST(Lrat, AcceptsRefutationsOfUnsatisfiableFormulasOnly) {
  constexpr std::size_t kVariables = 5;
  Dice dice(2);
  std::size_t refuted = 0;
  for (int round = 0; round < 400; ++round) {
    Formula formula;
    for (int i = 0; i < 24; ++i) formula.push_back(dice.clause(kVariables, 2));
    std::erase_if(formula, [](const Literals& clause) { return clause.empty(); });
    for (int i = 0; i < 8; ++i) formula.push_back({1, -2, 3});
    Refuter refuter(formula, kVariables);
    const bool unsatisfiable = refuter.run();
    ASSERT_EQ(unsatisfiable, implies(formula, {}, kVariables));
    if (!unsatisfiable) continue;
    ++refuted;
    ASSERT_TRUE(accepts(formula, kVariables, refuter.text()));
  }
  EXPECT_GT(refuted, 50U);
}

std::string mutated(std::string text, Dice& dice) {
  for (std::size_t edits = 1 + dice.below(3); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = dice.below(text.size());
    const char digit = "0123456789 -\nd"[dice.below(14)];
    switch (dice.below(3)) {
      case 0:
        text[at] = digit;
        break;
      case 1:
        text.insert(at, 1, digit);
        break;
      default:
        text.erase(at, 1 + dice.below(4));
        break;
    }
  }
  return text;
}

TEST(Lrat, RefusesMutatedRefutationsOfSatisfiableFormulas) {
  constexpr std::size_t kVariables = 5;
  Dice dice(3);
  int tried = 0;
  while (tried < support::share_of(4000)) {
    Formula formula;
    for (int i = 0; i < 12; ++i) {
      formula.push_back(dice.clause(kVariables, 2));
      if (formula.back().empty()) formula.back() = {1};
    }
    Refuter refuter(formula, kVariables);
    if (!refuter.run()) continue;
    for (std::size_t i = 0; i < formula.size(); ++i) {
      Formula weakened = formula;
      weakened[i] = {1, -1};
      if (implies(weakened, {}, kVariables)) continue;
      ++tried;
      EXPECT_FALSE(accepts(weakened, kVariables, refuter.text()));
      for (int k = 0; k < 20; ++k) {
        ASSERT_FALSE(accepts(weakened, kVariables, mutated(refuter.text(), dice)));
      }
    }
  }
}

TEST(Lrat, TakesClausesAsSets) {
  LratChecker checker(3);
  ASSERT_TRUE(checker.add_premise({2, 1, 2}));
  ASSERT_TRUE(checker.add_premise({-2, -2}));
  ASSERT_TRUE(checker.add_premise({3, -3}));
  EXPECT_TRUE(checker.add_lemma({1, 1}, Hints{2, 1}));   // -2, then 1 2 is empty
  EXPECT_FALSE(checker.add_lemma({1}, Hints{3, 2, 1}));  // a tautology is never unit
  EXPECT_FALSE(checker.add_lemma({3}, Hints{3}));
  EXPECT_TRUE(checker.add_lemma({3, 1, -3}, {}));
  EXPECT_FALSE(checker.add_lemma({3, 1, -3}, Hints{2}));
  EXPECT_FALSE(checker.has_empty_clause());
}

TEST(Lrat, RefusesLiteralsOfNoVariable) {
  LratChecker checker(2);
  EXPECT_FALSE(checker.add_premise({0}));
  EXPECT_FALSE(checker.add_premise({1, 3}));
  EXPECT_FALSE(checker.add_premise({-3}));
  EXPECT_FALSE(checker.add_premise({std::numeric_limits<std::int32_t>::min()}));
  EXPECT_FALSE(checker.add_lemma({std::numeric_limits<std::int32_t>::max()}, {}));
  EXPECT_EQ(checker.size(), 0U);
  EXPECT_TRUE(checker.add_premise({}));
  EXPECT_TRUE(checker.has_empty_clause());
}

TEST(Lrat, RefusesHintsToRemovedClauses) {
  LratChecker checker = checker_of({{1}, {-1}}, 1);
  EXPECT_FALSE(checker.remove(0));
  EXPECT_FALSE(checker.remove(3));
  EXPECT_TRUE(checker.remove(2));
  EXPECT_FALSE(checker.remove(2));
  EXPECT_FALSE(checker.add_lemma({}, Hints{1, 2}));
  EXPECT_FALSE(checker.has_empty_clause());
}

TEST(Lrat, ReadsTheFormatStrictly) {
  const Formula formula = {{1, 2}, {1, -2}, {-1, 2}, {-1, -2}};
  const auto reads = [&formula](const std::string& text) { return accepts(formula, 2, text); };
  EXPECT_TRUE(reads("5 1 0 1 2 0\n5 d 1 2 0\n6 0 5 3 4 0\n"));
  EXPECT_TRUE(reads("5 1 0 1 2 0\n7 d 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads(""));
  EXPECT_FALSE(reads("5 1 0 1 2 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0\n6 0 5 3 4 0"));
  EXPECT_FALSE(reads("5 1 0 1 2 0\n6 0 5 3 4 0\n6 d 1 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0\n6 0 5 3 4 0\n\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0 \n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1  2 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0\r\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 01 0 1 2 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 -0 1 2 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 +1 0 1 2 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 -2 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 4294967298 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("6 1 0 1 2 0\n7 0 6 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0\n5 d 3 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0\n5 d 9 0\n6 0 5 3 4 0\n"));
  EXPECT_FALSE(reads("5 1 0 1 2 0 0\n6 0 5 3 4 0\n"));
}

}  // namespace
}  // namespace hexatlas::check
