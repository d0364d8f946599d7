#pragma once
/// \file
/// Internal to the judge: refutations, proofs that no points fulfil a condition
/// (docs/formats/catalogue.md, "Refutations"). Premises are recognized by chirotope_clauses.hpp,
/// final polynomials are summed here, lemmas are left to lrat.hpp.

#include <cstdint>
#include <string>

#include "tables/check/chirotope_clauses.hpp"
#include "tables/check/triangulation_laws.hpp"

namespace hexatlas::check {

struct RefutationCounts {
  std::uint64_t premises = 0, polynomials = 0, lemmas = 0;
};

/// Law::kPremise, kPolynomial, kLemma, kContradiction; adds to `counts` what was accepted. Errors:
/// Malformed. Cost: O(length of the clauses and of the clauses named as hints).
[[nodiscard]] CatalogueFinding check_refutation(const RefutationText& text, const std::string& file,
                                                const SignedTriangulation& triangulation,
                                                Condition condition, RefutationCounts& counts);

}  // namespace hexatlas::check
