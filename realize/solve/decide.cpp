#include "realize/solve/decide.hpp"

#include <optional>

#include "realize/solve/final_polynomial.hpp"
#include "realize/solve/refute.hpp"

namespace hexatlas::solve {
namespace {

using certificate::Answer;
using certificate::Open;

Answer refutation_or_open(const SignSearch& search, unsigned attempts) {
  if (auto refutation = search.refutation(attempts)) return std::move(*refutation);
  return Open{};
}

}  // namespace

Answer decide(const complex::Triangulation& triangulation, std::span<const int> signs,
              certificate::Condition condition, const Effort& effort) {
  SignSearch search(triangulation, signs, condition);
  std::uint64_t seed = effort.coordinates.seed;
  std::optional<chirotope::Signs> model = search.next(seed);
  if (!model) return refutation_or_open(search, effort.proof_attempts);
  if (auto points = find_realization(triangulation, signs, condition, effort.coordinates))
    return std::move(*points);
  for (int tried = 0; tried < effort.models; ++tried) {
    if (const auto polynomial = find_final_polynomial(triangulation.vertices, *model, condition))
      search.exclude(*polynomial);
    else if (auto points =
                 find_realization_of(*model, triangulation, signs, condition, effort.coordinates))
      return std::move(*points);
    model = search.next(++seed);
    if (!model) return refutation_or_open(search, effort.proof_attempts);
  }
  return Open{};
}

}  // namespace hexatlas::solve
