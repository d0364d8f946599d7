#pragma once
/// \file
/// Clauses with unit propagation that remembers its reasons. Private to realize/solve.
///
/// Method. Two watched literals per clause (M. Moskewicz, C. Madigan, Y. Zhao, L. Zhang, S. Malik,
/// "Chaff", 2001). Literals that follow from the clauses alone stay assigned, "at the root"; those
/// that follow from the negation of a lemma are taken back.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "realize/solve/sat.hpp"

namespace hexatlas::solve {

/// The literals ascending by variable, each once.
[[nodiscard]] Clause sorted_set(Clause clause);

/// Requires throughout: clauses as sorted_set() returns them, of the stated variables.
class Propagator {
 public:
  /// Clauses by index, in the order in which they were added.
  using Hints = std::vector<std::uint32_t>;

  explicit Propagator(std::size_t variables);

  void add(const Clause& clause);
  /// Forgets a clause, unless there is none or a literal at the root follows from it.
  void remove(const Clause& clause);

  /// If the lemma follows by reverse unit propagation: the clauses used, in the order of
  /// propagation, the last being the one with all literals false.
  [[nodiscard]] std::optional<Hints> hints_for(const Clause& lemma);

  /// Whether the clauses alone lead to a contradiction; hints_for({}) then has its reason.
  [[nodiscard]] bool contradicts() const noexcept { return conflict_.has_value(); }

  /// To be called after add() of a unit clause: its literal, if at the root, now follows from it.
  void prefer_unit(Literal literal);

 private:
  using Index = std::uint32_t;
  struct Watch {
    Index clause;
    Literal other;  ///< some other literal of the clause: if true, there is nothing to do
  };

  [[nodiscard]] std::span<Literal> literals_of(Index clause);
  [[nodiscard]] int value_of(Literal literal) const;
  void assign(Literal literal, Index reason);
  void attach(Index clause);
  [[nodiscard]] std::optional<Index> propagate();
  [[nodiscard]] std::optional<Index> visit_watches(Literal falsified);
  [[nodiscard]] bool rewatch(Index clause, Literal falsified);
  [[nodiscard]] std::optional<Index> conflict_of(const Clause& lemma);
  [[nodiscard]] Hints reasons_of(Index conflict);
  void return_to_root();

  std::vector<Literal> literals_;      ///< of all clauses, one after the other
  std::vector<std::size_t> begin_{0};  ///< clause i is begin_[i] .. begin_[i+1]
  std::vector<bool> removed_;          ///< by clause
  std::unordered_map<std::uint64_t, std::vector<Index>> by_hash_;  ///< clauses not removed
  std::vector<std::vector<Watch>> watches_;  ///< by literal: clauses that watch it
  std::vector<std::int8_t> value_;           ///< by variable
  std::vector<Index> reason_;                ///< by variable, if assigned
  std::vector<bool> in_lemma_;               ///< by variable, false between calls
  std::vector<bool> seen_;                   ///< by variable, false between calls
  std::vector<Literal> trail_;               ///< true literals in the order of assignment
  std::size_t propagated_ = 0;               ///< of the trail
  std::size_t root_size_ = 0;                ///< of the trail
  std::optional<Index> conflict_;            ///< at the root
};

}  // namespace hexatlas::solve
