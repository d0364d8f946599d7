#pragma once
/// \file
/// The size of a search tree, estimated before the search.
///
/// Method. D. E. Knuth, "Estimating the efficiency of backtrack programs" (Math. Comp. 29, 1975): a
/// random path from the root, each time to one of the accepted choices; a node on it stands for as
/// many as the product of their numbers says. The mean over all paths is the size. Here paths begin
/// below the top of the tree, which is explored as a whole: that takes most of the variance away.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "enum/core/random.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "enum/search/depth_first.hpp"

namespace hexatlas::search {

struct Estimate {
  double nodes = 0;           ///< the mean: Counts::nodes of the whole search
  double standard_error = 0;  ///< of the mean; too small while rare large branches were missed
  std::uint64_t probes = 0;
  bool is_exact = false;  ///< the top was everything
};

namespace detail {

/// The nodes of the subtree of a root, by one path. `problem` is in its initial state before and
/// after.
template <BacktrackProblem P>
double probe(P& problem, const Root<typename P::Choice>& root, core::Random& random) {
  using Choice = typename P::Choice;
  std::size_t applied = 0;
  for (const Choice& choice : root) {
    if (!problem.apply(choice)) break;  // only the last one can be refused
    ++applied;
  }
  double nodes = 1, weight = 1;
  std::vector<Choice> accepted;
  for (bool go_on = applied == root.size(); go_on && !problem.is_complete();) {
    accepted.clear();
    std::size_t tried = 0;
    for (const Choice& choice : problem.choices()) {
      ++tried;
      if (!problem.apply(choice)) continue;
      problem.undo();
      accepted.push_back(choice);
    }
    nodes += weight * static_cast<double>(tried);
    go_on = !accepted.empty() && problem.apply(accepted[random.below(accepted.size())]);
    weight *= static_cast<double>(accepted.size());
    if (go_on) ++applied;
  }
  for (; applied > 0; --applied) problem.undo();
  return nodes;
}

}  // namespace detail

/// The result depends on the seed, not on the number of threads. make() gives a problem in its
/// initial state. Requires probes >= 2.
template <class Make>
[[nodiscard]] Estimate estimate_nodes(Make&& make, std::uint64_t probes, std::uint64_t seed,
                                      int threads) {
  constexpr std::size_t kTopRoots = 2000;
  auto problem = make();
  const auto go_on = [](const auto&) { return true; };
  auto top = explore(problem, {}, {.depth = 1}, go_on);
  for (std::size_t depth = 2; !top.unexplored.empty() && top.unexplored.size() < kTopRoots; ++depth)
    top = explore(problem, {}, {.depth = depth}, go_on);
  const auto exact = static_cast<double>(top.counts.nodes);
  if (top.unexplored.empty()) return {.nodes = exact, .is_exact = true};
  std::vector<double> sizes(probes);
  constexpr std::size_t kBatch = 64;
  parallel::parallel_for(threads, (sizes.size() + kBatch - 1) / kBatch, [&](std::size_t batch) {
    auto own = make();
    for (std::size_t i = batch * kBatch; i < std::min(sizes.size(), (batch + 1) * kBatch); ++i) {
      core::Random random(seed * 0x9E3779B97F4A7C15ULL + i);
      sizes[i] = detail::probe(own, top.unexplored[random.below(top.unexplored.size())], random);
    }
  });
  double sum = 0, squares = 0;
  for (const double size : sizes) sum += size;
  const double mean = sum / static_cast<double>(probes);
  for (const double size : sizes) squares += (size - mean) * (size - mean);
  const auto roots = static_cast<double>(top.unexplored.size());
  const auto count = static_cast<double>(probes);
  return {.nodes = exact + roots * mean,
          .standard_error = roots * std::sqrt(squares / (count - 1) / count),
          .probes = probes,
          .is_exact = false};
}

}  // namespace hexatlas::search
