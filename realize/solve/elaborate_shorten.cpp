#include "realize/solve/elaborate_shorten.hpp"

#include <cstdint>
#include <numeric>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::solve {
namespace {

using Core = std::vector<std::uint32_t>;

class Shortener {
 public:
  Shortener(std::span<const Clause> premises, std::size_t variables)
      : premises_(premises), variables_(variables) {}

  /// A proof by the solver that uses premises of the core only. nullopt: satisfiable.
  [[nodiscard]] std::optional<TrimmedProof> solved(const Core& core, std::uint64_t seed) const {
    const auto answer = solve_or_prove(clauses_of(core), variables_, {.seed = seed});
    const auto* proof = std::get_if<RupProof>(&answer);
    if (proof == nullptr) return std::nullopt;
    auto refutation = elaborated(core, *proof);
    if (!refutation) throw core::ResourceFailure("a proof ends before its contradiction");
    return refutation;
  }

  /// Asks the solver again for the premises that a proof needs, while this gives shorter ones.
  [[nodiscard]] TrimmedProof iterated(TrimmedProof proof, std::uint64_t seed) const {
    unsigned failures = 0;
    while (failures < kPatience) {
      auto next = solved(proof.premises, ++seed);
      core::ensures(next.has_value(), "shorten: the premises of a refutation are refutable");
      if (replace_if_shorter(proof, std::move(*next)))
        failures = 0;
      else
        ++failures;
    }
    return proof;
  }

  /// Leaves out single lemmas of a short proof, the last first, if this makes it shorter.
  [[nodiscard]] TrimmedProof thinned(TrimmedProof proof) const {
    if (proof.lemmas.size() > kThinnedLemmas) return proof;
    for (std::size_t i = proof.lemmas.size(); i-- > 0;) {
      if (i >= proof.lemmas.size()) continue;
      RupProof steps;
      for (std::size_t k = 0; k < proof.lemmas.size(); ++k)
        if (k != i) steps.push_back({.is_deletion = false, .clause = proof.lemmas[k].clause});
      if (auto next = elaborated(proof.premises, steps))
        replace_if_shorter(proof, std::move(*next));
    }
    return proof;
  }

 private:
  static constexpr unsigned kPatience = 4;            ///< attempts without success
  static constexpr std::size_t kThinnedLemmas = 500;  ///< the cost grows with their square

  [[nodiscard]] std::vector<Clause> clauses_of(const Core& core) const {
    std::vector<Clause> clauses;
    for (const std::uint32_t index : core) clauses.push_back(premises_[index]);
    return clauses;
  }

  [[nodiscard]] std::optional<TrimmedProof> elaborated(const Core& core,
                                                       const RupProof& steps) const {
    auto lemmas = elaborate(clauses_of(core), steps);
    if (!lemmas) return std::nullopt;
    TrimmedProof proof = trimmed(core.size(), std::move(*lemmas));
    for (std::uint32_t& index : proof.premises) index = core[index];
    return proof;
  }

  bool replace_if_shorter(TrimmedProof& proof, TrimmedProof next) const {
    if (length_of(next, premises_) >= length_of(proof, premises_)) return false;
    proof = std::move(next);
    return true;
  }

  std::span<const Clause> premises_;
  std::size_t variables_;
};

}  // namespace

std::size_t length_of(const TrimmedProof& proof, std::span<const Clause> premises) {
  std::size_t length = 0;
  for (const std::uint32_t index : proof.premises) length += premises[index].size();
  for (const certificate::Lemma& lemma : proof.lemmas)
    length += lemma.clause.size() + lemma.hints.size();
  return length;
}

std::optional<TrimmedProof> short_refutation(std::span<const Clause> premises,
                                             std::size_t variables, unsigned attempts) {
  core::expects(attempts >= 1, "shorten: at least one attempt");
  const Shortener shortener(premises, variables);
  Core all(premises.size());
  std::iota(all.begin(), all.end(), std::uint32_t{0});
  std::optional<TrimmedProof> best;
  for (unsigned attempt = 0; attempt < attempts; ++attempt) {
    const std::uint64_t seed = std::uint64_t{attempt} << 32U;
    auto proof = shortener.solved(all, seed);
    if (!proof) return std::nullopt;
    TrimmedProof next = shortener.thinned(shortener.iterated(std::move(*proof), seed));
    if (!best || length_of(next, premises) < length_of(*best, premises)) best = std::move(next);
  }
  return best;
}

}  // namespace hexatlas::solve
