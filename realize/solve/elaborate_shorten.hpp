#pragma once
/// \file
/// Short refutations of small sets of clauses.

#include <cstddef>
#include <optional>
#include <span>

#include "realize/solve/elaborate.hpp"

namespace hexatlas::solve {

/// Numbers in a proof as the catalogue writes it: literals and hints.
[[nodiscard]] std::size_t length_of(const TrimmedProof& proof, std::span<const Clause> premises);

/// A refutation of the clauses, the shortest of several: the solver is asked `attempts` times, with
/// different seeds, and then again for the premises that were needed, as long as this helps; at
/// last single lemmas are left out, if there are few. nullopt if the clauses are satisfiable.
/// Deterministic. Throws ResourceFailure if a proof is cut off. Requires attempts >= 1 and literals
/// of the stated variables, else PreconditionViolated. Cost: some seconds for proofs of some
/// hundred lemmas; not meant for proofs of many thousands. Not promised: a shortest proof.
[[nodiscard]] std::optional<TrimmedProof> short_refutation(std::span<const Clause> premises,
                                                           std::size_t variables,
                                                           unsigned attempts);

}  // namespace hexatlas::solve
