#include "realize/solve/elaborate_propagation.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace hexatlas::solve {
namespace {

constexpr std::uint32_t kAssumed = std::numeric_limits<std::uint32_t>::max();

std::size_t variable_of(Literal literal) { return static_cast<std::size_t>(std::abs(literal)); }
std::size_t place_of(Literal literal) { return 2 * variable_of(literal) + (literal < 0 ? 1 : 0); }

std::uint64_t hash_of(const Clause& clause) {
  std::uint64_t hash = clause.size();
  for (const Literal literal : clause)
    hash = (hash ^ place_of(literal)) * 0x9E3779B97F4A7C15U + (hash >> 29U);
  return hash;
}

bool is_tautology(const Clause& sorted) {
  return std::adjacent_find(sorted.begin(), sorted.end(),
                            [](Literal a, Literal b) { return a == -b; }) != sorted.end();
}

}  // namespace

Clause sorted_set(Clause clause) {
  std::sort(clause.begin(), clause.end(), [](Literal a, Literal b) {
    return std::pair(std::abs(a), a) < std::pair(std::abs(b), b);
  });
  clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
  return clause;
}

Propagator::Propagator(std::size_t variables)
    : watches_(2 * variables + 2),
      value_(variables + 1),
      reason_(variables + 1, kAssumed),
      in_lemma_(variables + 1),
      seen_(variables + 1) {}

std::span<Literal> Propagator::literals_of(Index clause) {
  return {literals_.begin() + static_cast<std::ptrdiff_t>(begin_[clause]),
          literals_.begin() + static_cast<std::ptrdiff_t>(begin_[clause + 1])};
}

int Propagator::value_of(Literal literal) const {
  return literal > 0 ? value_[variable_of(literal)] : -value_[variable_of(literal)];
}

void Propagator::assign(Literal literal, Index reason) {
  value_[variable_of(literal)] = literal > 0 ? 1 : -1;
  reason_[variable_of(literal)] = reason;
  trail_.push_back(literal);
}

void Propagator::add(const Clause& clause) {
  const auto index = static_cast<Index>(removed_.size());
  literals_.insert(literals_.end(), clause.begin(), clause.end());
  begin_.push_back(literals_.size());
  removed_.push_back(false);
  by_hash_[hash_of(clause)].push_back(index);
  if (!contradicts() && !is_tautology(clause)) attach(index);
}

void Propagator::attach(Index clause) {
  const std::span<Literal> literals = literals_of(clause);
  const auto rest = std::partition(literals.begin(), literals.end(),
                                   [&](Literal literal) { return value_of(literal) >= 0; });
  const auto open = rest - literals.begin();
  if (open == 0) {
    conflict_ = clause;
  } else if (open > 1) {
    watches_[place_of(literals[0])].push_back({clause, literals[1]});
    watches_[place_of(literals[1])].push_back({clause, literals[0]});
  } else if (value_of(literals[0]) == 0) {  // else satisfied for ever, and so is this one now
    assign(literals[0], clause);
    conflict_ = propagate();
    root_size_ = trail_.size();
  }
}

void Propagator::remove(const Clause& clause) {
  const auto found = by_hash_.find(hash_of(clause));
  if (found == by_hash_.end()) return;
  std::vector<Index>& candidates = found->second;
  const auto same = std::find_if(candidates.begin(), candidates.end(), [&](Index candidate) {
    const std::span<const Literal> stored = literals_of(candidate);
    return std::is_permutation(stored.begin(), stored.end(), clause.begin(), clause.end());
  });
  if (same == candidates.end()) return;
  for (const Literal literal : clause)
    if (value_of(literal) > 0 && reason_[variable_of(literal)] == *same) return;
  removed_[*same] = true;  // watches are dropped when they are next visited
  candidates.erase(same);
}

void Propagator::prefer_unit(Literal literal) {
  if (value_of(literal) > 0)
    reason_[variable_of(literal)] = static_cast<Index>(removed_.size() - 1);
}

/// Puts another literal that is not false in the place of the falsified one, which is moved to the
/// second place. False if there is none.
bool Propagator::rewatch(Index clause, Literal falsified) {
  const std::span<Literal> literals = literals_of(clause);
  if (literals[0] == falsified) std::swap(literals[0], literals[1]);
  const auto next = std::find_if(literals.begin() + 2, literals.end(),
                                 [&](Literal literal) { return value_of(literal) >= 0; });
  if (next == literals.end()) return false;
  std::swap(literals[1], *next);
  watches_[place_of(literals[1])].push_back({clause, literals[0]});
  return true;
}

/// The conflict found among the clauses that watch a literal which has become false, if any.
std::optional<Propagator::Index> Propagator::visit_watches(Literal falsified) {
  std::vector<Watch>& watches = watches_[place_of(falsified)];
  std::optional<Index> conflict;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < watches.size(); ++i) {
    const Watch watch = watches[i];
    if (removed_[watch.clause]) continue;
    if (conflict || value_of(watch.other) > 0) {
      watches[kept++] = watch;
      continue;
    }
    if (rewatch(watch.clause, falsified)) continue;
    const Literal first = literals_of(watch.clause)[0];
    watches[kept++] = {watch.clause, first};
    if (value_of(first) == 0)
      assign(first, watch.clause);
    else if (value_of(first) < 0)
      conflict = watch.clause;
  }
  watches.resize(kept);
  return conflict;
}

std::optional<Propagator::Index> Propagator::propagate() {
  while (propagated_ < trail_.size())
    if (const auto conflict = visit_watches(-trail_[propagated_++])) return conflict;
  return std::nullopt;
}

std::optional<Propagator::Hints> Propagator::hints_for(const Clause& lemma) {
  for (const Literal literal : lemma) in_lemma_[variable_of(literal)] = true;
  const std::optional<Index> conflict = conflict_of(lemma);
  std::optional<Hints> hints;
  if (conflict) hints = reasons_of(*conflict);
  for (const Literal literal : lemma) in_lemma_[variable_of(literal)] = false;
  return_to_root();
  return hints;
}

/// A clause with all literals false once those of the lemma are assumed false.
std::optional<Propagator::Index> Propagator::conflict_of(const Clause& lemma) {
  if (conflict_) return conflict_;
  // If literals of the lemma are true at the root, the reason of the first of them becomes false,
  // and no clause used for it contains another of them.
  const auto is_true = [&](Literal literal) { return value_of(literal) > 0; };
  if (std::any_of(lemma.begin(), lemma.end(), is_true)) {
    const auto first = std::find_first_of(trail_.begin(), trail_.end(), lemma.begin(), lemma.end());
    return reason_[variable_of(*first)];
  }
  for (const Literal literal : lemma)
    if (value_of(literal) == 0) assign(-literal, kAssumed);
  return propagate();
}

Propagator::Hints Propagator::reasons_of(Index conflict) {
  Hints hints{conflict};
  const auto mark = [&](Index clause) {
    for (const Literal literal : literals_of(clause))
      if (!in_lemma_[variable_of(literal)]) seen_[variable_of(literal)] = true;
  };
  mark(conflict);
  for (std::size_t i = trail_.size(); i-- > 0;) {
    const std::size_t variable = variable_of(trail_[i]);
    if (!seen_[variable]) continue;
    hints.push_back(reason_[variable]);
    mark(reason_[variable]);
    seen_[variable] = false;
  }
  std::reverse(hints.begin(), hints.end());
  return hints;
}

void Propagator::return_to_root() {
  for (std::size_t i = root_size_; i < trail_.size(); ++i) value_[variable_of(trail_[i])] = 0;
  trail_.resize(root_size_);
  propagated_ = root_size_;
}

}  // namespace hexatlas::solve
