#pragma once
/// \file
/// From proofs of a solver to proofs with hints, which a simple program checks in linear time.
///
/// Definition. A lemma follows by reverse unit propagation (RUP) if assuming its literals false and
/// then all literals forced by clauses with all others false ends in a clause with all literals
/// false. The hints name the clauses used, in this order. Source: L. Cruz-Filipe, M. Heule,
/// W. Hunt, M. Kaufmann, P. Schneider-Kamp, "Efficient certified RAT verification" (2017).
///
/// Not promised: shortest proofs.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "realize/certificate/certificate.hpp"
#include "realize/solve/sat.hpp"

namespace hexatlas::solve {

/// The lemmas of the proof that are needed for the empty clause, with hints. Premises keep their
/// numbers 1 .. premises.size(), lemmas are numbered after them; the last is empty. Lemmas that do
/// not follow by reverse unit propagation are passed over; nullopt: the others do not lead to the
/// empty clause, since the proof was cut off or needs more than such lemmas.
/// Cost: one unit propagation per lemma; deletions are obeyed, since they make propagation cheaper.
/// Requires nonzero literals, else PreconditionViolated.
[[nodiscard]] std::optional<std::vector<certificate::Lemma>> elaborate(
    std::span<const Clause> premises, std::span<const ProofStep> proof);

/// A proof that names the premises it needs.
struct TrimmedProof {
  std::vector<std::uint32_t> premises;     ///< indices from 0, ascending
  std::vector<certificate::Lemma> lemmas;  ///< hints number these premises from 1, then the lemmas
};

/// Keeps the premises to which a hint refers. Requires lemmas as elaborate() returns them.
[[nodiscard]] TrimmedProof trimmed(std::size_t premise_count,
                                   std::vector<certificate::Lemma> lemmas);

}  // namespace hexatlas::solve
