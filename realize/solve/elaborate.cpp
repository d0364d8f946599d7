#include "realize/solve/elaborate.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "enum/core/checks.hpp"
#include "realize/solve/elaborate_propagation.hpp"

namespace hexatlas::solve {
namespace {

using certificate::Lemma;

std::size_t greatest_variable(std::span<const Clause> premises, std::span<const ProofStep> proof) {
  Literal greatest = 0;
  const auto include = [&](const Clause& clause) {
    for (const Literal literal : clause) {
      core::expects(literal != 0, "elaborate: literals are not 0");
      greatest = std::max(greatest, std::abs(literal));
    }
  };
  for (const Clause& clause : premises) include(clause);
  for (const ProofStep& step : proof) include(step.clause);
  return static_cast<std::size_t>(greatest);
}

/// All lemmas up to the first empty one, with hints that number clauses from 0; none if there is no
/// such lemma.
std::vector<Lemma> with_hints(std::span<const Clause> premises, std::span<const ProofStep> proof) {
  Propagator clauses(greatest_variable(premises, proof));
  for (const Clause& premise : premises) clauses.add(sorted_set(premise));
  std::vector<Lemma> lemmas;
  for (const ProofStep& step : proof) {
    if (clauses.contradicts()) break;
    Clause clause = sorted_set(step.clause);
    if (step.is_deletion) {
      clauses.remove(clause);
      continue;
    }
    auto hints = clauses.hints_for(clause);
    if (!hints) continue;
    clauses.add(clause);
    if (clause.size() == 1) clauses.prefer_unit(clause[0]);
    lemmas.push_back({std::move(clause), std::move(*hints)});
  }
  if (!clauses.contradicts()) return {};
  lemmas.push_back({{}, *clauses.hints_for({})});
  return lemmas;
}

std::vector<bool> needed_lemmas(std::size_t premise_count, std::span<const Lemma> lemmas) {
  std::vector<bool> needed(lemmas.size());
  needed.back() = true;
  for (std::size_t i = lemmas.size(); i-- > 0;)
    if (needed[i])
      for (const std::uint32_t hint : lemmas[i].hints)
        if (hint >= premise_count) needed[hint - premise_count] = true;
  return needed;
}

}  // namespace

std::optional<std::vector<Lemma>> elaborate(std::span<const Clause> premises,
                                            std::span<const ProofStep> proof) {
  std::vector<Lemma> lemmas = with_hints(premises, proof);
  if (lemmas.empty()) return std::nullopt;
  const std::size_t count = premises.size();
  const std::vector<bool> needed = needed_lemmas(count, lemmas);
  std::vector<std::uint32_t> number(lemmas.size());
  std::vector<Lemma> kept;
  for (std::size_t i = 0; i < lemmas.size(); ++i) {
    if (!needed[i]) continue;
    for (std::uint32_t& hint : lemmas[i].hints)
      hint = hint < count ? hint + 1 : number[hint - count];
    kept.push_back(std::move(lemmas[i]));
    number[i] = static_cast<std::uint32_t>(count + kept.size());
  }
  return kept;
}

TrimmedProof trimmed(std::size_t premise_count, std::vector<Lemma> lemmas) {
  std::vector<std::uint32_t> number(premise_count);  // 0: not needed
  for (const Lemma& lemma : lemmas)
    for (const std::uint32_t hint : lemma.hints)
      if (hint <= premise_count) number[hint - 1] = 1;
  TrimmedProof proof;
  for (std::size_t i = 0; i < premise_count; ++i)
    if (number[i] != 0) {
      proof.premises.push_back(static_cast<std::uint32_t>(i));
      number[i] = static_cast<std::uint32_t>(proof.premises.size());
    }
  const auto dropped = static_cast<std::uint32_t>(premise_count - proof.premises.size());
  for (Lemma& lemma : lemmas)
    for (std::uint32_t& hint : lemma.hints)
      hint = hint <= premise_count ? number[hint - 1] : hint - dropped;
  proof.lemmas = std::move(lemmas);
  return proof;
}

}  // namespace hexatlas::solve
