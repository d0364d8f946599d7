#include "realize/solve/refute.hpp"

#include <cstddef>
#include <utility>

#include "enum/core/checks.hpp"
#include "realize/conditions/clauses.hpp"
#include "realize/solve/elaborate_shorten.hpp"
#include "realize/solve/final_polynomial.hpp"

namespace hexatlas::solve {

using certificate::FinalPolynomial;
using certificate::Refutation;
using chirotope::Signs;

SignSearch::SignSearch(const complex::Triangulation& triangulation, std::span<const int> signs,
                       certificate::Condition condition)
    : variables_(chirotope::variable_count(triangulation.vertices)),
      premises_(conditions::premises(triangulation, signs, condition)),
      solver_(variables_) {
  for (const Clause& premise : premises_) solver_.add(premise);
}

std::optional<Signs> SignSearch::next(std::uint64_t seed) {
  const auto assignment = solver_.solve(seed);
  if (!assignment) return std::nullopt;
  Signs signs;
  for (const bool is_positive : *assignment)
    signs.push_back(static_cast<std::int8_t>(is_positive ? 1 : -1));
  return signs;
}

void SignSearch::exclude(const FinalPolynomial& polynomial) {
  core::expects(is_proof(polynomial), "refute: polynomials are proofs");
  solver_.add(polynomial.clause);
  polynomials_.push_back(polynomial);
}

void SignSearch::exclude(const Signs& model) {
  core::expects(model.size() == variables_, "refute: one sign per four points");
  Clause blocked;
  for (std::size_t i = 0; i < variables_; ++i) {
    const auto literal = static_cast<Literal>(i + 1);
    blocked.push_back(model[i] > 0 ? -literal : literal);
  }
  solver_.add(blocked);
  has_blocked_models_ = true;
}

std::optional<Refutation> SignSearch::refutation(unsigned attempts) const {
  core::expects(may_refute(), "refute: models were excluded without proof");
  return refute(premises_, polynomials_, variables_, attempts);
}

std::optional<Refutation> refute(std::span<const Clause> premises,
                                 std::span<const FinalPolynomial> polynomials,
                                 std::size_t variables, unsigned attempts) {
  std::vector<Clause> clauses(premises.begin(), premises.end());
  for (const FinalPolynomial& polynomial : polynomials) clauses.push_back(polynomial.clause);
  auto proof = short_refutation(clauses, variables, attempts);
  if (!proof) return std::nullopt;
  Refutation refutation;
  for (const std::uint32_t index : proof->premises) {
    if (index < premises.size())
      refutation.premises.push_back(premises[index]);
    else
      refutation.polynomials.push_back(polynomials[index - premises.size()]);
  }
  refutation.lemmas = std::move(proof->lemmas);
  return refutation;
}

}  // namespace hexatlas::solve
