#include "realize/solve/final_polynomial.hpp"

#include <z3++.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "realize/conditions/edges.hpp"
#include "realize/solve/final_polynomial_hull.hpp"

namespace hexatlas::solve {
namespace {

using certificate::Clause;
using certificate::Condition;
using certificate::EdgeTerm;
using certificate::FinalPolynomial;
using certificate::FinalPolynomialTerm;
using certificate::Literal;
using chirotope::PlueckerProducts;
using chirotope::PlueckerRelation;
using chirotope::Signs;
using conditions::EdgeRelation;

constexpr std::int64_t kGreatestWeight = std::int64_t{1} << 31U;

std::size_t variable_of(Literal literal) { return static_cast<std::size_t>(std::abs(literal)); }

/// The place 0, 1, 2 of the product whose sign differs from the others; nullopt if a sign is not
/// known or the relation is broken.
std::optional<std::size_t> odd_product(const PlueckerProducts& products, const Signs& signs) {
  std::array<int, 3> sign{};
  for (std::size_t i = 0; i < 3; ++i)
    sign[i] = chirotope::sign_of(products[i][0], signs) * chirotope::sign_of(products[i][1], signs);
  const int sum = sign[0] + sign[1] + sign[2];
  if (sign[0] * sign[1] * sign[2] == 0 || std::abs(sum) == 3) return std::nullopt;
  return static_cast<std::size_t>(std::find(sign.begin(), sign.end(), -sum) - sign.begin());
}

/// The sum of two logarithms of determinants is greater than that of two others.
struct Inequality {
  std::vector<std::size_t> determinants;  ///< those whose signs it needs, by variable
  FourTermVector logarithms;              ///< by variable
  std::variant<FinalPolynomialTerm, EdgeTerm> term;
};

Inequality pluecker_inequality(const PlueckerRelation& relation, const PlueckerProducts& products,
                               std::size_t larger, std::size_t smaller) {
  Inequality inequality;
  for (const auto& product : products)
    for (const Literal literal : product) inequality.determinants.push_back(variable_of(literal));
  inequality.logarithms = {{variable_of(products[larger][0]), variable_of(products[larger][1])},
                           {variable_of(products[smaller][0]), variable_of(products[smaller][1])}};
  FinalPolynomialTerm term;
  term.common = relation.common;
  term.others = relation.others;
  term.larger = static_cast<std::uint8_t>(larger + 1);
  term.smaller = static_cast<std::uint8_t>(smaller + 1);
  inequality.term = term;
  return inequality;
}

Inequality edge_inequality(const EdgeRelation& relation, std::uint8_t larger) {
  Inequality inequality;
  for (const Literal literal : {relation.x0, relation.x1, relation.y0, relation.y1, relation.turn})
    inequality.determinants.push_back(variable_of(literal));
  FourTermVector& logarithms = inequality.logarithms;
  logarithms = {{variable_of(relation.y0), variable_of(relation.x1)},
                {variable_of(relation.y1), variable_of(relation.x0)}};
  if (larger == 2) std::swap(logarithms.plus, logarithms.minus);
  inequality.term = EdgeTerm{1, relation.tail, relation.axis, relation.apex, relation.side, larger};
  return inequality;
}

std::vector<Inequality> inequalities_of(int points, const Signs& signs, Condition condition) {
  std::vector<Inequality> inequalities;
  for (const PlueckerRelation& relation : chirotope::pluecker_relations(points)) {
    const PlueckerProducts products = chirotope::products_of(relation);
    const auto odd = odd_product(products, signs);
    if (!odd) continue;
    for (std::size_t other = 0; other < 3; ++other)
      if (other != *odd)
        inequalities.push_back(pluecker_inequality(relation, products, *odd, other));
  }
  if (condition == Condition::jacobian)
    for (const EdgeRelation& relation : conditions::edge_relations())
      if (const auto larger = conditions::larger_product(relation, signs))
        inequalities.push_back(edge_inequality(relation, *larger));
  return inequalities;
}

void include_determinants(const Inequality& inequality, std::set<std::size_t>& variables) {
  variables.insert(inequality.determinants.begin(), inequality.determinants.end());
}

/// Indices of contradictory inequalities among those that need no excluded determinant.
std::optional<std::vector<std::size_t>> propose_contradiction(
    const std::vector<Inequality>& inequalities, const std::set<std::size_t>& excluded,
    std::size_t determinants) {
  std::vector<std::size_t> candidates;
  std::vector<FourTermVector> vectors;
  for (std::size_t i = 0; i < inequalities.size(); ++i) {
    std::set<std::size_t> used;
    include_determinants(inequalities[i], used);
    if (std::any_of(used.begin(), used.end(), [&](std::size_t v) { return excluded.contains(v); }))
      continue;
    candidates.push_back(i);
    vectors.push_back(inequalities[i].logarithms);
  }
  auto contradiction = propose_zero_combination(vectors, determinants + 1);
  if (contradiction)
    for (std::size_t& i : *contradiction) i = candidates[i];
  return contradiction;
}

/// The rational numbers, not negative, as coprime integers in the same proportion; nullopt if they
/// exceed kGreatestWeight, or nearly so.
std::optional<std::vector<std::int64_t>> scaled_to_integers(
    const std::vector<std::pair<std::int64_t, std::int64_t>>& fractions) {
  std::int64_t denominator = 1;
  for (const auto& [above, below] : fractions) {
    if (below > kGreatestWeight) return std::nullopt;
    denominator = std::lcm(denominator, below);
    if (denominator > kGreatestWeight) return std::nullopt;
  }
  std::vector<std::int64_t> integers;
  std::int64_t divisor = 0;
  for (const auto& [above, below] : fractions) {
    if (above > kGreatestWeight / (denominator / below)) return std::nullopt;
    integers.push_back(above * (denominator / below));
    divisor = std::gcd(divisor, integers.back());
  }
  for (std::int64_t& integer : integers) integer /= divisor;
  return integers;
}

/// Non-negative weights of the inequalities, not all 0, by which all logarithms cancel.
std::optional<std::vector<std::int64_t>> cancelling_weights(
    const std::vector<Inequality>& inequalities) {
  z3::context context;
  z3::solver solver(context, "QF_LRA");
  std::vector<z3::expr> weight;
  z3::expr sum = context.real_val(0);
  std::map<std::size_t, z3::expr> total;  // by determinant
  for (std::size_t i = 0; i < inequalities.size(); ++i) {
    weight.push_back(context.real_const(("w" + std::to_string(i)).c_str()));
    solver.add(weight[i] >= 0);
    sum = sum + weight[i];
    const auto entry = [&](std::size_t variable) -> z3::expr& {
      return total.try_emplace(variable, context.real_val(0)).first->second;
    };
    const FourTermVector& logarithms = inequalities[i].logarithms;
    for (const std::size_t variable : logarithms.plus)
      entry(variable) = entry(variable) + weight[i];
    for (const std::size_t variable : logarithms.minus)
      entry(variable) = entry(variable) - weight[i];
  }
  solver.add(sum == 1);
  for (const auto& [variable, entry] : total) solver.add(entry == 0);
  if (solver.check() != z3::sat) return std::nullopt;
  const z3::model model = solver.get_model();
  std::vector<std::pair<std::int64_t, std::int64_t>> fractions;
  for (const z3::expr& unknown : weight) {
    auto& [above, below] = fractions.emplace_back();
    if (!Z3_get_numeral_small(context, model.eval(unknown, true), &above, &below))
      return std::nullopt;
  }
  return scaled_to_integers(fractions);
}

FinalPolynomial polynomial_of(const std::vector<Inequality>& inequalities,
                              const std::vector<std::int64_t>& weights, const Signs& signs) {
  FinalPolynomial polynomial;
  std::set<std::size_t> used;
  for (std::size_t i = 0; i < inequalities.size(); ++i) {
    if (weights[i] == 0) continue;
    const Inequality& inequality = inequalities[i];
    include_determinants(inequality, used);
    if (const auto* edge = std::get_if<EdgeTerm>(&inequality.term)) {
      polynomial.edge_terms.push_back(*edge);
      polynomial.edge_terms.back().weight = weights[i];
    } else {
      polynomial.terms.push_back(std::get<FinalPolynomialTerm>(inequality.term));
      polynomial.terms.back().weight = weights[i];
    }
  }
  for (const std::size_t variable : used) {
    const auto literal = static_cast<Literal>(variable);
    polynomial.clause.push_back(signs[variable - 1] > 0 ? -literal : literal);
  }
  return polynomial;
}

std::set<std::size_t> determinants_of(const std::vector<Inequality>& inequalities,
                                      const std::vector<std::size_t>& indices) {
  std::set<std::size_t> used;
  for (const std::size_t i : indices) include_determinants(inequalities[i], used);
  return used;
}

/// Contradictory inequalities that need few determinants: each in turn is avoided if the others do.
std::optional<std::vector<Inequality>> few_contradictory(
    const std::vector<Inequality>& inequalities, std::size_t determinants) {
  auto best = propose_contradiction(inequalities, {}, determinants);
  if (!best) return std::nullopt;
  std::set<std::size_t> excluded;
  const auto exclude_unused = [&](const std::vector<std::size_t>& contradiction) {
    const std::set<std::size_t> used = determinants_of(inequalities, contradiction);
    for (std::size_t variable = 1; variable <= determinants; ++variable)
      if (!used.contains(variable)) excluded.insert(variable);
  };
  exclude_unused(*best);
  for (std::size_t variable = 1; variable <= determinants; ++variable) {
    if (!excluded.insert(variable).second) continue;
    if (auto next = propose_contradiction(inequalities, excluded, determinants)) {
      best = std::move(next);
      exclude_unused(*best);
    } else {
      excluded.erase(variable);
    }
  }
  std::vector<Inequality> chosen;
  for (const std::size_t i : *best) chosen.push_back(inequalities[i]);
  return chosen;
}

bool is_well_formed(const FinalPolynomialTerm& term) {
  const auto [a, b] = term.common;
  const auto& others = term.others;
  const bool points =
      a < b && b < chirotope::kMaxPoints && others[3] < chirotope::kMaxPoints &&
      std::adjacent_find(others.begin(), others.end(), std::greater_equal<>()) == others.end() &&
      std::count(others.begin(), others.end(), a) == 0 &&
      std::count(others.begin(), others.end(), b) == 0;
  const auto is_product = [](std::uint8_t number) { return number >= 1 && number <= 3; };
  return points && term.weight >= 1 && term.weight <= kGreatestWeight && is_product(term.larger) &&
         is_product(term.smaller) && term.larger != term.smaller;
}

/// The inequality of a term if the signs imply it.
std::optional<Inequality> implied(const FinalPolynomialTerm& term, const Signs& signs) {
  if (!is_well_formed(term)) return std::nullopt;
  const PlueckerRelation relation{term.common, term.others};
  const PlueckerProducts products = chirotope::products_of(relation);
  const std::size_t larger = term.larger - std::size_t{1};
  if (odd_product(products, signs) != larger) return std::nullopt;
  return pluecker_inequality(relation, products, larger, term.smaller - std::size_t{1});
}

std::optional<Inequality> implied(const EdgeTerm& term, const Signs& signs) {
  const auto relation = conditions::edge_relation(term.tail, term.axis, term.apex, term.side);
  if (!relation || term.weight < 1 || term.weight > kGreatestWeight ||
      conditions::larger_product(*relation, signs) != term.larger)
    return std::nullopt;
  return edge_inequality(*relation, term.larger);
}

/// The signs that are the negation of the clause; nullopt if it is a tautology or no clause.
std::optional<Signs> negation_of(const Clause& clause) {
  Signs signs(chirotope::variable_count(chirotope::kMaxPoints));
  for (const Literal literal : clause) {
    if (literal == 0 || literal < -static_cast<std::int64_t>(signs.size()) ||
        literal > static_cast<std::int64_t>(signs.size()))
      return std::nullopt;
    const auto negated = static_cast<std::int8_t>(literal > 0 ? -1 : +1);
    std::int8_t& sign = signs[variable_of(literal) - 1];
    if (sign == -negated) return std::nullopt;
    sign = negated;
  }
  return signs;
}

}  // namespace

bool is_proof(const FinalPolynomial& polynomial) {
  const auto signs = negation_of(polynomial.clause);
  if (!signs) return false;
  std::map<std::size_t, std::int64_t> total;
  const auto all_implied = [&](const auto& terms) {
    for (const auto& term : terms) {
      const auto inequality = implied(term, *signs);
      if (!inequality) return false;
      for (const std::size_t variable : inequality->logarithms.plus) total[variable] += term.weight;
      for (const std::size_t variable : inequality->logarithms.minus)
        total[variable] -= term.weight;
    }
    return true;
  };
  return all_implied(polynomial.terms) && all_implied(polynomial.edge_terms) && !total.empty() &&
         std::all_of(total.begin(), total.end(),
                     [](const auto& entry) { return entry.second == 0; });
}

std::optional<FinalPolynomial> find_final_polynomial(int points, const Signs& signs,
                                                     Condition condition) {
  core::expects(signs.size() == chirotope::variable_count(points),
                "final polynomial: one sign per four points");
  try {
    const auto chosen = few_contradictory(inequalities_of(points, signs, condition), signs.size());
    if (!chosen) return std::nullopt;
    const auto weights = cancelling_weights(*chosen);
    if (!weights) return std::nullopt;
    FinalPolynomial polynomial = polynomial_of(*chosen, *weights, signs);
    core::ensures(is_proof(polynomial), "final polynomial: the sum is not 0");
    return polynomial;
  } catch (const z3::exception& failure) {
    throw core::ResourceFailure(std::string("linear programming failed: ") + failure.msg());
  }
}

}  // namespace hexatlas::solve
