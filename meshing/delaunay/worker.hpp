#pragma once
/// \file
/// Private to meshing/delaunay: one thread of a pass. It inserts the sites of a stretch of the
/// curve as far as it can within the region; when another thread waits, it gives away the second
/// half of what is left, region and sites: docs/theory/parallel-delaunay.md.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "meshing/delaunay/cells.hpp"
#include "meshing/delaunay/handover.hpp"
#include "meshing/delaunay/inserter.hpp"
#include "meshing/delaunay/region.hpp"
#include "meshing/delaunay/site.hpp"

namespace hexatlas::delaunay {

template <class Index, bool kIsWeighted>
class alignas(kApart) Worker {
 public:
  /// Of the sites of one stretch, or of as many as were not given away: those left, in its order.
  struct Piece {
    std::uint64_t first = 0;  ///< the first key of the stretch
    std::vector<Index> left;
  };

  /// Fewer sites than those worth giving are not given away. Requires two at least.
  Worker(Inserter<Index, kIsWeighted>& inserter, const Site* sites, Handover<Index>& handover,
         std::size_t worth_giving)
      : inserter_(inserter), sites_(sites), handover_(handover), worth_giving_(worth_giving) {}

  /// The stretch, and then what others give. Requires a seat at its handover, and regions that are
  /// disjoint, of all workers there.
  void work(const Stretch<Index>& stretch, typename Handover<Index>::Seat& seat);

  [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }
  /// Sites, and the vertices at the same places.
  [[nodiscard]] const std::vector<std::pair<Index, Index>>& duplicates() const noexcept {
    return duplicates_;
  }
  [[nodiscard]] bool has_inserted() const noexcept { return has_inserted_; }

 private:
  void insert_all(const Stretch<Index>& stretch);
  void insert(Index site);
  [[nodiscard]] bool give_half(std::span<const Index>& rest);

  Inserter<Index, kIsWeighted>& inserter_;
  const Site* sites_;
  Handover<Index>& handover_;
  std::size_t worth_giving_;
  std::vector<Piece> pieces_;
  std::vector<std::pair<Index, Index>> duplicates_;
  bool has_inserted_ = false;
};

template <class Index, bool kIsWeighted>
void Worker<Index, kIsWeighted>::work(const Stretch<Index>& stretch,
                                      typename Handover<Index>::Seat& seat) {
  std::optional<Stretch<Index>> next = stretch;
  for (; next; next = seat.awaited()) insert_all(*next);
  inserter_.walk().release();
}

template <class Index, bool kIsWeighted>
void Worker<Index, kIsWeighted>::insert_all(const Stretch<Index>& stretch) {
  pieces_.push_back({stretch.region.first, {}});
  if (stretch.start == kNone) {
    pieces_.back().left.assign(stretch.sites.begin(), stretch.sites.end());
    return;
  }
  // What it had before is still its own: the more, the less of a border.
  const Region mine = inserter_.walk().region();
  inserter_.walk().start_at(stretch.start);
  inserter_.walk().confine_to(stretch.region.is_before(mine) ? stretch.region.joined(mine)
                                                             : stretch.region);
  std::size_t worth_giving = worth_giving_;
  for (auto rest = stretch.sites; !rest.empty(); rest = rest.subspan(1)) {
    if (handover_.is_wanted() && rest.size() >= worth_giving && !give_half(rest))
      worth_giving = rest.size() + 1;  // never again
    insert(rest.front());
  }
}

template <class Index, bool kIsWeighted>
void Worker<Index, kIsWeighted>::insert(Index site) {
  const Outcome outcome = inserter_.insert(site);
  if (outcome == Outcome::inserted)
    has_inserted_ = true;
  else if (outcome == Outcome::duplicate)
    duplicates_.emplace_back(site, inserter_.twin());
  else if (outcome != Outcome::hidden)
    pieces_.back().left.push_back(site);
}

/// Of the sites and of the region, cut between different keys. False if there is no such place, or
/// no cell to start from on one of the two sides.
template <class Index, bool kIsWeighted>
bool Worker<Index, kIsWeighted>::give_half(std::span<const Index>& rest) {
  const auto key_at = [&](std::size_t i) { return sites_[rest[i]].key; };
  std::size_t middle = rest.size() / 2;
  while (middle < rest.size() && key_at(middle) == key_at(middle - 1)) ++middle;
  if (middle == rest.size()) return false;
  Walk<Index>& walk = inserter_.walk();
  const Index before = walk.start();
  const auto [near, far] = walk.region().cut_at(key_at(middle));
  const auto kept = rest.first(middle), behind = rest.subspan(middle);
  const Stretch<Index> given{far, behind, walk.cell_within(far, behind)};
  const Index start = given.start == kNone ? Index{kNone} : walk.cell_within(near, kept);
  walk.start_at(start == kNone ? before : start);
  if (start == kNone) return false;
  rest = kept;
  walk.confine_to(near);
  handover_.give(given);
  return true;
}

}  // namespace hexatlas::delaunay
