#pragma once
/// \file
/// A backtracking search on several threads that can be stopped, saved and gone on with.
///
/// What is left of a search is a list of roots (depth_first.hpp). It is worked off in rounds: the
/// first roots are dealt out to kSlots, each of which has a slice of nodes for its own, and what
/// the slots leave takes the places of their roots. The rounds depend on the list alone, so the
/// results do not depend on the number of threads, nor on where the search was stopped and resumed,
/// but for the order in which solutions are listed.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "enum/parallel/parallel_for.hpp"
#include "enum/search/depth_first.hpp"

namespace hexatlas::search {

/// What is done of a search, and what is left.
template <class Choice, class Found>
struct Frontier {
  Counts counts;
  std::vector<Found> found;
  std::vector<Root<Choice>> pending{Root<Choice>{}};  ///< the next one last

  [[nodiscard]] bool is_finished() const noexcept { return pending.empty(); }
};

struct PoolOptions {
  int threads = 1;
  /// Nodes in this call, at most.
  std::uint64_t max_nodes = std::numeric_limits<std::uint64_t>::max();
  /// Set to true by another thread or a signal handler to stop early; may be null.
  const std::atomic<bool>* stop = nullptr;
};

inline constexpr std::size_t kSlots = 64;           ///< of a round
inline constexpr std::size_t kRootsEach = 64;       ///< of a slot, at most
inline constexpr std::uint64_t kSlice = 50'000;     ///< nodes of a slot in a round: some 25 ms
inline constexpr std::uint64_t kFirstSlice = 1000;  ///< while there are fewer roots than slots

namespace detail {

template <class Choice, class Found>
struct Slot {
  std::vector<Root<Choice>> roots;  ///< what is left of them, the next one last
  Counts counts;
  std::vector<Found> found;
};

/// The slots of the next round, and the nodes that each gets; none if `left` is 0.
template <class Choice, class Found>
std::vector<Slot<Choice, Found>> take_round(std::vector<Root<Choice>>& pending, std::uint64_t left,
                                            std::uint64_t& slice) {
  const auto slots =
      static_cast<std::size_t>(std::min<std::uint64_t>(std::min(kSlots, pending.size()), left));
  if (slots == 0) return {};
  slice = std::min(pending.size() < kSlots ? kFirstSlice : kSlice, left / slots);
  const std::size_t each = std::min(kRootsEach, pending.size() / slots);
  std::vector<Slot<Choice, Found>> round(slots);
  for (Slot<Choice, Found>& slot : round) {
    const auto first = pending.end() - static_cast<std::ptrdiff_t>(each);
    slot.roots.assign(std::make_move_iterator(first), std::make_move_iterator(pending.end()));
    pending.erase(first, pending.end());
  }
  return round;
}

/// Works off the roots of a slot until its nodes are spent.
template <class P, class Collect, class Choice, class Found>
void work_off(P& problem, std::uint64_t nodes, Collect& collect, Slot<Choice, Found>& slot) {
  while (!slot.roots.empty() && slot.counts.nodes < nodes) {
    const Root<Choice> root = std::move(slot.roots.back());
    slot.roots.pop_back();
    auto result =
        explore(problem, root, {.nodes = nodes - slot.counts.nodes}, [&](const auto& solution) {
          if (std::optional<Found> kept = collect(solution)) slot.found.push_back(std::move(*kept));
          return true;
        });
    slot.counts += result.counts;
    std::move(result.unexplored.rbegin(), result.unexplored.rend(), std::back_inserter(slot.roots));
  }
}

}  // namespace detail

/// Goes on with a search until it is finished, stopped, out of nodes, or `after_round`, which may
/// save the frontier, says false. make() gives a problem in its initial state; collect(problem),
/// for each solution, what is to be kept of it, if anything. Both are called by several threads at
/// once. Cost: nothing worth mentioning beside the search, if a problem is made in less than a
/// millisecond. An exception of theirs ends the call; the frontier then is useless.
template <class Found, class Make, class Collect, class Choice>
void explore_pending(Frontier<Choice, Found>& frontier, const PoolOptions& options, Make&& make,
                     Collect&& collect, const std::function<bool()>& after_round) {
  const auto is_stopped = [&] {
    return options.stop != nullptr && options.stop->load(std::memory_order_relaxed);
  };
  std::uint64_t left = options.max_nodes;
  while (!frontier.is_finished() && !is_stopped()) {
    std::uint64_t slice = 0;
    auto round = detail::take_round<Choice, Found>(frontier.pending, left, slice);
    if (round.empty()) return;
    parallel::parallel_for(options.threads, round.size(), [&](std::size_t i) {
      auto problem = make();
      detail::work_off(problem, slice, collect, round[i]);
    });
    for (auto slot = round.rbegin(); slot != round.rend(); ++slot)
      std::move(slot->roots.begin(), slot->roots.end(), std::back_inserter(frontier.pending));
    for (auto& slot : round) {
      frontier.counts += slot.counts;
      left -= slot.counts.nodes;
      std::move(slot.found.begin(), slot.found.end(), std::back_inserter(frontier.found));
    }
    if (after_round && !after_round()) return;
  }
}

/// Part `index` of `parts` of a new search: the counts and solutions of all parts add up to those
/// of the whole. The top of the tree, which is the same for all, belongs to part 0. Requires 0 <=
/// index < parts.
template <class Found, class Make, class Collect>
auto shard(std::size_t index, std::size_t parts, Make&& make, Collect&& collect) {
  auto problem = make();
  using Choice = typename decltype(problem)::Choice;
  Frontier<Choice, Found> result;
  if (parts == 1) return result;
  constexpr std::size_t kRootsOfPart = 50;       // so that the parts are about alike
  constexpr std::uint64_t kMostNodes = 100'000;  // of the top, which all parts go through
  Exploration<Choice> top;
  const auto explore_to = [&](std::size_t depth) {
    result.found.clear();
    top = explore(problem, {}, {.depth = depth}, [&](const auto& solution) {
      if (std::optional<Found> kept = collect(solution)) result.found.push_back(std::move(*kept));
      return true;
    });
  };
  // To the first depth with enough roots, or else to the one with most: there are few where choices
  // are forced, and none below the last one.
  std::size_t depth = 0, most = 0, best = 1;
  do {
    explore_to(++depth);
    if (top.unexplored.size() > most) {
      most = top.unexplored.size();
      best = depth;
    }
  } while (!top.unexplored.empty() && top.counts.nodes < kMostNodes && most < kRootsOfPart * parts);
  if (best != depth) explore_to(best);
  if (index == 0)
    result.counts = top.counts;
  else
    result.found.clear();
  result.pending.clear();
  for (std::size_t i = 0; i < top.unexplored.size(); ++i)
    if (i % parts == index) result.pending.push_back(std::move(top.unexplored[i]));
  std::reverse(result.pending.begin(), result.pending.end());
  return result;
}

}  // namespace hexatlas::search
