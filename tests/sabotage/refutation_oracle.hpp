#pragma once
/// \file
/// Premises of refutations, listed from their definitions (the judge: recognizes single ones); a
/// search for refutations by cases; and propagation without hints.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
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

/// The brackets of the edge lemma of the format, as points in the order of their names x0, x1, y0,
/// y1, R, and factors. `apex`: 0 or 1, the end of the edge that is opposite to u on a facet.
struct SlowEdge {
  std::array<Simplex, 5> points;
  std::array<int, 5> factor{};

  SlowEdge(int tail, int axis, int apex, int side) {
    const int head = tail + (1 << axis);
    const int i = 1 << (axis + side) % 3;
    const int j = 1 << (axis + 3 - side) % 3;
    const int u = (apex == 0 ? tail : head) ^ i ^ j;
    points = {Simplex{tail, head, tail ^ i, u}, Simplex{tail, head, head ^ i, u},
              Simplex{tail, head, tail ^ j, u}, Simplex{tail, head, head ^ j, u},
              Simplex{tail, head, tail ^ i, head ^ i}};
    const int of_i = (tail & i) != 0 ? -1 : 1;
    const int of_j = (tail & j) != 0 ? -1 : 1;
    factor = {of_i, of_i, of_j, of_j, side == 1 ? -1 : 1};
  }
  /// "The value has this sign."
  [[nodiscard]] int literal(const SignVariables& variables, std::size_t value, int sign) const {
    return variables.literal(points[value], sign * factor[value]);
  }
};

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
    for (int number = 0; number < 8 * 3 * 2 * 2; ++number) {
      const int tail = number / 12;
      const int axis = number / 4 % 3;
      if ((tail >> axis) % 2 != 0) continue;
      const SlowEdge edge(tail, axis, number % 2, 1 + number / 2 % 2);
      for (const int x : {1, -1}) {
        for (const int turn : {1, -1}) {
          deny({edge.literal(variables, 0, x), edge.literal(variables, 1, -x),
                edge.literal(variables, 2, -x * turn), edge.literal(variables, 3, -x * turn),
                edge.literal(variables, 4, turn)});
        }
      }
    }
  }
  return premises;
}

/// Whether the terms of a line `f` add up to 0, each being an inequality wherever the clause is
/// false. `words` from the first term on.
inline bool is_final_polynomial(const Clause& clause, const std::vector<std::string>& words,
                                int vertices) {
  const SignVariables variables(vertices);
  const auto is_known = [&](int literal) {
    return std::find(clause.begin(), clause.end(), -literal) != clause.end();
  };
  for (const int literal : clause) {
    if (is_known(literal)) return false;  // also denied
  }
  std::map<Simplex, std::int64_t> sums;
  bool of_edges = false;
  std::size_t at = 0;
  const auto number = [&] { return std::stoi(words.at(at++)); };
  while (at < words.size()) {
    if (words[at] == "e") {
      of_edges = true;
      ++at;
      continue;
    }
    const int weight = number();
    if (weight < 1) return false;
    if (of_edges) {
      const int tail = number();
      const int axis = number();
      const int u = number();
      const int side = number();
      const int larger = number();
      if (tail < 0 || tail > 7 || axis < 0 || axis > 2 || side < 1 || side > 2 || larger < 1 ||
          larger > 2 || (tail >> axis) % 2 != 0) {
        return false;
      }
      const int apex = u == (tail ^ 7 ^ (1 << axis)) ? 0 : 1;
      const SlowEdge edge(tail, axis, apex, side);
      if (edge.points[0][3] != u) return false;
      bool holds = false;
      for (const int x : {1, -1}) {
        for (const int turn : {1, -1}) {
          const int right = x * turn * (larger == 1 ? 1 : -1);
          holds = holds || (is_known(edge.literal(variables, 0, x)) &&
                            is_known(edge.literal(variables, 1, -x)) &&
                            is_known(edge.literal(variables, 2, right)) &&
                            is_known(edge.literal(variables, 3, -right)) &&
                            is_known(edge.literal(variables, 4, turn)));
        }
      }
      if (!holds) return false;
      const int plus = larger == 1 ? weight : -weight;
      sums[sorted(edge.points[2])] += plus;
      sums[sorted(edge.points[1])] += plus;
      sums[sorted(edge.points[3])] -= plus;
      sums[sorted(edge.points[0])] -= plus;
      continue;
    }
    Simplex p;
    for (int i = 0; i < 6; ++i) p.push_back(number());
    const auto larger = static_cast<std::size_t>(number());
    const auto smaller = static_cast<std::size_t>(number());
    if (larger < 1 || larger > 3 || smaller < 1 || smaller > 3 || larger == smaller ||
        std::set<int>(p.begin(), p.end()).size() != 6 || p[0] > p[1] ||
        !std::is_sorted(p.begin() + 2, p.end()) || sorted(p)[0] < 0 || sorted(p)[5] >= vertices) {
      return false;
    }
    // The three products with their factors, so that their sum is 0.
    const std::array<std::array<Simplex, 2>, 3> products = {
        {{Simplex{p[0], p[1], p[2], p[3]}, Simplex{p[0], p[1], p[4], p[5]}},
         {Simplex{p[0], p[1], p[4], p[2]}, Simplex{p[0], p[1], p[3], p[5]}},
         {Simplex{p[0], p[1], p[2], p[5]}, Simplex{p[0], p[1], p[3], p[4]}}}};
    std::array<int, 3> sign = {0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      for (const int a : {1, -1}) {
        for (const int b : {1, -1}) {
          if (is_known(variables.literal(products[i][0], a)) &&
              is_known(variables.literal(products[i][1], b))) {
            sign[i] = a * b;
          }
        }
      }
    }
    const int other = sign[larger - 1];
    if (sign[0] * sign[1] * sign[2] == 0 || sign[0] + sign[1] + sign[2] != -other) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      sums[sorted(products[larger - 1][i])] += weight;
      sums[sorted(products[smaller - 1][i])] -= weight;
    }
  }
  return !words.empty() && words.back() != "e" &&
         std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; });
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
