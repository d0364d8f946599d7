#pragma once
/// \file
/// Searches for signs of points that realize a triangulation, and proofs that there are none.
///
/// Method. The premises of realize/conditions/clauses.hpp go to a solver. Its models are oriented
/// matroids, candidates for a search for coordinates; a model with a final polynomial has none, and
/// the clause of the polynomial excludes it and all others with the same signs. If no model is
/// left, premises and clauses of polynomials together refute the condition.
///
///     SignSearch search(triangulation, signs, condition);
///     while (const auto model = search.next(seed))
///       if (const auto polynomial = find_final_polynomial(vertices, *model))
///         search.exclude(*polynomial);
///       else
///         ...                            // coordinates, or another seed, or give up
///     search.refutation(attempts);
///
/// Deterministic. Requires arguments as in conditions::premises().

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"
#include "realize/chirotope/chirotope.hpp"
#include "realize/solve/sat.hpp"

namespace hexatlas::solve {

/// A refutation of premises and clauses of polynomials, short within the limits of
/// short_refutation(); premises and polynomials that it does not need are left out. nullopt: they
/// are satisfiable. Requires attempts >= 1.
[[nodiscard]] std::optional<certificate::Refutation> refute(
    std::span<const Clause> premises, std::span<const certificate::FinalPolynomial> polynomials,
    std::size_t variables, unsigned attempts);

class SignSearch {
 public:
  SignSearch(const complex::Triangulation& triangulation, std::span<const int> signs,
             certificate::Condition condition);

  /// Signs, none of them 0, that obey the premises and everything excluded so far; nullopt if there
  /// are none. Different seeds tend to give different signs.
  [[nodiscard]] std::optional<chirotope::Signs> next(std::uint64_t seed);

  /// Excludes the signs to which the polynomial applies. Requires is_proof().
  void exclude(const certificate::FinalPolynomial& polynomial);
  /// Excludes just these signs, for the sake of variety: it is no proof that there are no points,
  /// and the search can yield no refutation any more.
  void exclude(const chirotope::Signs& model);

  [[nodiscard]] bool may_refute() const noexcept { return !has_blocked_models_; }

  /// As refute(), of the premises and the polynomials. nullopt: there are signs left. Requires
  /// may_refute().
  [[nodiscard]] std::optional<certificate::Refutation> refutation(unsigned attempts) const;

 private:
  std::size_t variables_;
  std::vector<Clause> premises_;
  std::vector<certificate::FinalPolynomial> polynomials_;
  SatSolver solver_;
  bool has_blocked_models_ = false;
};

}  // namespace hexatlas::solve
