#include "realize/solve/coordinates_clauses.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "enum/core/checks.hpp"
#include "realize/conditions/clauses.hpp"

namespace hexatlas::solve {
namespace {

using certificate::Clause;
using certificate::Condition;
using certificate::Literal;

/// Known signs, and the clauses that they leave, until nothing changes.
class Propagation {
 public:
  explicit Propagation(std::size_t variables) : signs_(variables, 0) {}

  void learn(Literal unit) {
    contradictory_ = contradictory_ || sign_of(unit) < 0;
    signs_[static_cast<std::size_t>(std::abs(unit) - 1)] = unit > 0 ? 1 : -1;
  }

  void simplify(std::vector<Clause>& clauses) {
    for (bool learnt = true; learnt && !contradictory_;) {
      learnt = false;
      std::vector<Clause> left;
      for (Clause& clause : clauses) {
        if (std::any_of(clause.begin(), clause.end(), [this](Literal l) { return sign_of(l) > 0; }))
          continue;
        std::erase_if(clause, [this](Literal l) { return sign_of(l) < 0; });
        contradictory_ = contradictory_ || clause.empty();
        if (clause.size() == 1) {
          learn(clause.front());
          learnt = true;
        } else if (!clause.empty()) {
          left.push_back(std::move(clause));
        }
      }
      clauses = std::move(left);
    }
  }

  [[nodiscard]] bool contradictory() const noexcept { return contradictory_; }
  [[nodiscard]] std::vector<Literal> units() const {
    std::vector<Literal> result;
    for (std::size_t i = 0; i < signs_.size(); ++i)
      if (signs_[i] != 0) result.push_back(signs_[i] * static_cast<Literal>(i + 1));
    return result;
  }

 private:
  [[nodiscard]] int sign_of(Literal literal) const { return chirotope::sign_of(literal, signs_); }

  chirotope::Signs signs_;
  bool contradictory_ = false;
};

void append(std::vector<Clause>& to, std::vector<Clause> clauses) {
  for (Clause& clause : clauses) to.push_back(std::move(clause));
}

}  // namespace

SignConditions sign_conditions(const complex::Triangulation& triangulation,
                               std::span<const int> signs, Condition condition,
                               const chirotope::Signs& known) {
  const std::size_t variables = chirotope::variable_count(triangulation.vertices);
  core::expects(known.empty() || known.size() == variables,
                "coordinates: a known sign or 0 per variable");
  Propagation propagation(variables);
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i] != 0) propagation.learn(known[i] * static_cast<Literal>(i + 1));

  SignConditions result;
  append(result.clauses, conditions::sign_clauses(triangulation, signs));
  append(result.clauses, conditions::proper_clauses(triangulation));
  if (condition == Condition::convex)
    append(result.clauses, chirotope::convex_clauses(triangulation.vertices));
  if (condition == Condition::jacobian) append(result.clauses, conditions::corner_clauses());

  propagation.simplify(result.clauses);
  for (Clause& clause : result.clauses) std::sort(clause.begin(), clause.end());
  std::sort(result.clauses.begin(), result.clauses.end());
  result.clauses.erase(std::unique(result.clauses.begin(), result.clauses.end()),
                       result.clauses.end());
  result.units = propagation.units();
  result.contradictory = propagation.contradictory();
  return result;
}

}  // namespace hexatlas::solve
