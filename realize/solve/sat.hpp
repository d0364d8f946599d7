#pragma once
/// \file
/// Propositional satisfiability: the door to CaDiCaL.
///
/// The answers are proposals: an assignment is to be checked by its user, a proof by a checker.
/// Deterministic: the same clauses, in the same order, and the same seeds give the same answers.
/// Requires throughout: literals of variables 1 .. `variables`, else PreconditionViolated.
/// Cost: exponential in the worst case; there is no limit on time.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "realize/certificate/certificate.hpp"

namespace hexatlas::solve {

using certificate::Clause;
using certificate::Literal;

/// Truth of each variable by variable - 1.
using Assignment = std::vector<bool>;

/// An incremental solver: clauses can be added between calls of solve().
class SatSolver {
 public:
  explicit SatSolver(std::size_t variables);
  ~SatSolver();
  SatSolver(SatSolver&&) noexcept;
  SatSolver& operator=(SatSolver&&) noexcept;
  SatSolver(const SatSolver&) = delete;
  SatSolver& operator=(const SatSolver&) = delete;

  void add(const Clause& clause);
  /// An assignment, or nullopt if there is none. Decisions prefer a random value for each
  /// variable that depends on the seed alone, so different seeds tend to give different models.
  [[nodiscard]] std::optional<Assignment> solve(std::uint64_t seed);

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
  std::size_t variables_;
};

/// A lemma that follows from the clauses before it by reverse unit propagation, or a clause that is
/// no longer needed.
struct ProofStep {
  bool is_deletion = false;
  Clause clause;
  friend bool operator==(const ProofStep&, const ProofStep&) = default;
};
using RupProof = std::vector<ProofStep>;

struct ProofSearch {
  std::uint64_t seed = 0;     ///< order of the clauses and preferred values; 0: as given
  bool inprocessing = false;  ///< simplification between searches: for large problems
};

/// An assignment that satisfies the clauses, or a proof that there is none. Steps by which CaDiCaL
/// would use clauses that are no consequences are switched off. Throws ResourceFailure if the proof
/// cannot be stored.
[[nodiscard]] std::variant<Assignment, RupProof> solve_or_prove(std::span<const Clause> clauses,
                                                                std::size_t variables,
                                                                const ProofSearch& search);

/// Reads a proof in the binary DRAT format. Throws ResourceFailure if it is cut off or is no such
/// proof.
[[nodiscard]] RupProof read_binary_drat(std::string_view bytes);

}  // namespace hexatlas::solve
