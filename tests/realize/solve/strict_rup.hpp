#pragma once
/// \file
/// A slow and strict check of proofs with hints, for tests: each hint must be unit, the last empty.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "realize/certificate/certificate.hpp"

namespace hexatlas::sample {

inline bool follows(const std::vector<certificate::Clause>& clauses,
                    const certificate::Lemma& lemma) {
  std::map<std::int32_t, bool> value;
  for (const auto literal : lemma.clause) value[std::abs(literal)] = literal < 0;
  bool is_contradiction = false;
  for (const std::uint32_t hint : lemma.hints) {
    if (is_contradiction || hint == 0 || hint > clauses.size()) return false;
    std::set<std::int32_t> open;
    for (const auto literal : clauses[hint - 1]) {
      const auto found = value.find(std::abs(literal));
      if (found == value.end())
        open.insert(literal);
      else if (found->second == (literal > 0))
        return false;
    }
    if (open.size() > 1) return false;
    if (open.empty())
      is_contradiction = true;
    else
      value[std::abs(*open.begin())] = *open.begin() > 0;
  }
  return is_contradiction;
}

/// Whether each lemma follows from the clauses and the lemmas before it, and the last is empty.
inline bool is_refutation(std::vector<certificate::Clause> clauses,
                          std::span<const certificate::Lemma> lemmas) {
  for (const certificate::Lemma& lemma : lemmas) {
    if (!follows(clauses, lemma)) return false;
    clauses.push_back(lemma.clause);
  }
  return !lemmas.empty() && lemmas.back().clause.empty();
}

}  // namespace hexatlas::sample
