#pragma once
/// \file
/// Premises of refutations, listed from their definitions (the judge: recognizes single ones); a
/// search for refutations by cases; and propagation without hints.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/sabotage/triangulation_oracle.hpp"

namespace hexatlas::sabotage {

using Clause = std::vector<int>;

/// Sign variables of n points by listing all sets of four, those with the least greatest vertex
/// first.
class SignVariables {
 public:
  explicit SignVariables(int vertices) : fours_(subsets(first_numbers(vertices), 4)) {
    std::sort(fours_.begin(), fours_.end(), [](Simplex a, Simplex b) {
      std::reverse(a.begin(), a.end());
      std::reverse(b.begin(), b.end());
      return a < b;
    });
  }
  [[nodiscard]] int count() const { return static_cast<int>(fours_.size()); }
  [[nodiscard]] const Simplex& points(int variable) const {
    return fours_[static_cast<std::size_t>(variable - 1)];
  }
  /// The literal "the points, in this order, have this sign".
  [[nodiscard]] int literal(const Simplex& points, int sign) const {
    int variable = 1;
    while (this->points(variable) != sorted(points)) ++variable;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (points[j] > points[i]) sign = -sign;
      }
    }
    return sign * variable;
  }

 private:
  std::vector<Simplex> fours_;
};

/// "The coefficient of the i-th of five points in their dependency has this sign."
inline int circuit_literal(const SignVariables& variables, const Simplex& five, std::size_t i,
                           int sign) {
  return variables.literal(without(five, {five[i]}), i % 2 == 0 ? sign : -sign);
}

/// Literals of the signs of the tetrahedra: neighbours abcd and abce have opposite signs in this
/// order of their points. In a cell, the triangle is counter-clockwise from outside.
inline Clause sign_literals(const Complex& tetrahedra, const SlowCell* cell,
                            const SignVariables& variables) {
  std::vector<int> literal(tetrahedra.size(), 0);
  literal[0] = variables.literal(tetrahedra[0], 1);
  for (std::size_t round = 0; round < tetrahedra.size(); ++round) {
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      for (std::size_t j = 0; j < tetrahedra.size(); ++j) {
        Simplex face = common(tetrahedra[i], tetrahedra[j]);
        if (face.size() != 3 || literal[i] == 0) continue;
        Simplex first = face;
        Simplex second = face;
        first.push_back(without(tetrahedra[i], face)[0]);
        second.push_back(without(tetrahedra[j], face)[0]);
        const int sign = variables.literal(first, 1) == literal[i] ? 1 : -1;
        literal[j] = variables.literal(second, -sign);
      }
    }
  }
  if (cell == nullptr) return literal;
  const Complex boundary = boundary_of(tetrahedra);
  for (const auto& f : cell->facets) {
    for (const Simplex& out : {Simplex{f[0], f[1], f[2]}, Simplex{f[0], f[1], f.back()}}) {
      if (std::find(boundary.begin(), boundary.end(), sorted(out)) == boundary.end()) continue;
      for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
        const Simplex apex = without(tetrahedra[i], out);
        if (apex.size() != 1) continue;
        if (variables.literal({out[0], out[1], out[2], apex[0]}, -1) == literal[i]) return literal;
        for (int& l : literal) l = -l;
        return literal;
      }
    }
  }
  return literal;
}

/// All premise clauses, literals ascending. `condition`: "embedded", "convex" or "jacobian".
inline std::set<Clause> all_premises(const Complex& tetrahedra, int vertices, const SlowCell* cell,
                                     const std::string& condition) {
  const SignVariables variables(vertices);
  std::set<Clause> premises;
  const auto deny = [&premises](const Clause& conjunction) {
    Clause clause;
    for (const int literal : conjunction) clause.push_back(-literal);
    std::sort(clause.begin(), clause.end());
    premises.insert(clause);
  };
  for (const int literal : sign_literals(tetrahedra, cell, variables)) deny({-literal});
  for (const Simplex& ab : subsets(first_numbers(vertices), 2)) {
    for (const Simplex& four : subsets(without(first_numbers(vertices), ab), 4)) {
      for (unsigned bits = 0; bits < 8; ++bits) {
        for (const int all : {1, -1}) {
          // Signs of the first factors are free, those of the second make all products equal.
          Clause conjunction;
          for (std::size_t i = 1; i < 4; ++i) {
            const Simplex rest = without(four, {four[0], four[i]});
            const int first = ((bits >> (i - 1)) & 1U) != 0 ? 1 : -1;
            const int second = first * all * (i == 2 ? -1 : 1);
            conjunction.push_back(variables.literal({ab[0], ab[1], four[0], four[i]}, first));
            conjunction.push_back(variables.literal({ab[0], ab[1], rest[0], rest[1]}, second));
          }
          deny(conjunction);
        }
      }
    }
  }
  for (const Simplex& five : subsets(first_numbers(vertices), 5)) {
    for (const int sign : {1, -1}) {
      for (std::size_t odd = 0; odd <= 5; ++odd) {  // 5: none
        if (odd < 5 && condition != "convex") continue;
        Clause conjunction;
        for (std::size_t i = 0; i < 5; ++i) {
          conjunction.push_back(circuit_literal(variables, five, i, i == odd ? -sign : sign));
        }
        deny(conjunction);
      }
    }
  }
  for (const Simplex& s : tetrahedra) {
    for (const Simplex& t : tetrahedra) {
      if (s == t) continue;
      Simplex both = s;
      for (const int v : without(t, s)) both.push_back(v);
      for (const Simplex& five : subsets(sorted(both), 5)) {
        Clause conjunction;
        for (std::size_t i = 0; i < 5; ++i) {
          const bool in_s = contains(s, five[i]);
          if (in_s && contains(t, five[i])) continue;
          conjunction.push_back(circuit_literal(variables, five, i, in_s ? 1 : -1));
        }
        deny(conjunction);
      }
    }
  }
  if (condition == "jacobian") {
    for (int v = 0; v < 8; ++v) {
      const int bits = v % 2 + v / 2 % 2 + v / 4;
      deny({-variables.literal({v, v ^ 1, v ^ 2, v ^ 4}, bits % 2 == 0 ? 1 : -1)});
    }
  }
  return premises;
}

/// Whether assuming the literals of the clause false leads to a conflict by unit propagation.
inline bool follows_by_propagation(const std::vector<Clause>& clauses, const Clause& clause) {
  std::set<int> is_true;
  for (const int literal : clause) is_true.insert(-literal);
  for (bool more = true; more;) {
    more = false;
    for (const int literal : is_true) {
      if (is_true.contains(-literal)) return true;
    }
    for (const Clause& c : clauses) {
      std::set<int> free;
      bool satisfied = false;
      for (const int literal : c) {
        satisfied = satisfied || is_true.contains(literal);
        if (!is_true.contains(-literal)) free.insert(literal);
      }
      if (satisfied) continue;
      if (free.empty()) return true;
      if (free.size() == 1) more = is_true.insert(*free.begin()).second || more;
    }
  }
  return false;
}

/// Proves by cases that clauses are contradictory.
class CaseProof {
 public:
  explicit CaseProof(std::vector<Clause> clauses) : clauses_(std::move(clauses)) {}

  /// Lines `c` and `l` of a refutation, with `qed`; nullopt if the clauses have a model.
  std::optional<std::string> lines() {
    std::string text;
    for (const Clause& clause : clauses_) text += "c" + words(clause) + " 0\n";
    if (prove({}) == 0) return std::nullopt;
    return text + lemmas_ + "qed\n";
  }

 private:
  static std::string words(const std::vector<int>& numbers) {
    std::string text;
    for (const int number : numbers) text += " " + std::to_string(number);
    return text;
  }

  /// The number of a lemma that denies the decisions, 0 if there is a model.
  int prove(const Clause& decisions) {
    std::set<int> is_true(decisions.begin(), decisions.end());
    std::vector<int> hints;
    for (bool more = true; more;) {
      more = false;
      for (std::size_t c = 0; c < clauses_.size(); ++c) {
        std::set<int> free;
        bool satisfied = false;
        for (const int literal : clauses_[c]) {
          satisfied = satisfied || is_true.contains(literal);
          if (!is_true.contains(-literal)) free.insert(literal);
        }
        if (satisfied || free.size() > 1) continue;
        hints.push_back(static_cast<int>(c) + 1);
        if (free.empty()) return add_lemma(decisions, hints);
        is_true.insert(*free.begin());
        more = true;
      }
    }
    for (const Clause& clause : clauses_) {
      for (const int literal : clause) {
        if (is_true.contains(literal) || is_true.contains(-literal)) continue;
        Clause one = decisions;
        one.push_back(literal);
        Clause two = decisions;
        two.push_back(-literal);
        const int first = prove(one);
        const int second = first == 0 ? 0 : prove(two);
        return second == 0 ? 0 : add_lemma(decisions, {first, second});
      }
    }
    return 0;
  }

  int add_lemma(const Clause& decisions, const std::vector<int>& hints) {
    Clause lemma;
    for (const int literal : decisions) lemma.push_back(-literal);
    lemmas_ += "l" + words(lemma) + " 0" + words(hints) + " 0\n";
    clauses_.push_back(lemma);
    return static_cast<int>(clauses_.size());
  }

  std::vector<Clause> clauses_;
  std::string lemmas_;
};

}  // namespace hexatlas::sabotage
