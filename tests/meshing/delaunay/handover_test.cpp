// Claim. A thread that waits gets what another gives, once, and is told when no one works any more.
// A stretch of which half was given away has the same tetrahedra in the end as without; what is
// left of both halves is every site that is no vertex. Each site is in the region of its stretch,
// and in no other.
// Oracle. One thread, which inserts all sites one after the other.
#include "meshing/delaunay/handover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "enum/parallel/parallel_for.hpp"
#include "meshing/delaunay/division.hpp"
#include "meshing/delaunay/inserter.hpp"
#include "meshing/delaunay/worker.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/sites.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Region;
using delaunay::Site;
using Index = std::uint32_t;
using Handover = delaunay::Handover<Index>;
using Stretch = delaunay::Stretch<Index>;

void wait_until_wanted(const Handover& handover) {
  while (!handover.is_wanted()) std::this_thread::yield();
}

TEST(Handover, EndsWhereNoOneWorks) {
  Handover handover;
  for (int i = 0; i < 3; ++i) {  // as where one thread is all there are
    Handover::Seat seat(handover);
    EXPECT_FALSE(handover.is_wanted());
    EXPECT_FALSE(seat.awaited());
  }
  EXPECT_FALSE(handover.is_wanted());
}

TEST(Handover, DoesNotWaitForOneThatThrew) {
  Handover handover;
  const auto throws = [&] {
    const Handover::Seat seat(handover);
    throw 1;
  };
  EXPECT_THROW(throws(), int);
  Handover::Seat seat(handover);
  EXPECT_FALSE(seat.awaited());
}

TEST(Handover, GivesEachStretchOnce) {
  Handover handover;
  const std::vector<Index> sites{5, 7};
  std::atomic<int> got = 0;
  const auto take = [&](Handover::Seat& seat) {
    while (const std::optional<Stretch> given = seat.awaited()) {
      EXPECT_EQ(given->sites.data(), sites.data());
      got += static_cast<int>(given->start);
    }
  };
  const auto wait = [&] {
    Handover::Seat seat(handover);
    take(seat);
  };
  Handover::Seat working(handover);
  std::array<std::jthread, 2> others{std::jthread(wait), std::jthread(wait)};
  for (const Index start : {1U, 10U, 100U, 1000U}) {
    wait_until_wanted(handover);
    handover.give({{}, sites, start});
  }
  take(working);  // what the others have not come to take
  for (std::jthread& other : others) other.join();
  EXPECT_EQ(got, 1111);
}

TEST(Region, IsCutAndJoinedRoundTheCircle) {
  const Region whole{6, 5, 7};  // of 8 keys those from 6 to 2
  const auto keys = [](const Region& region) {
    std::vector<std::uint64_t> result;
    for (std::uint64_t key = 0; key <= region.last_key; ++key)
      if (region.has(Site{0, 0, 0, key})) result.push_back(key);
    return result;
  };
  ASSERT_EQ(keys(whole), (std::vector<std::uint64_t>{0, 1, 2, 6, 7}));
  for (const std::uint64_t cut : keys(whole)) {
    const auto [near, far] = whole.cut_at(cut);
    EXPECT_TRUE(near.is_before(far));
    EXPECT_EQ(keys(near).size() + keys(far).size(), 5U);
    EXPECT_TRUE(far.has(Site{0, 0, 0, cut}));
    EXPECT_EQ(keys(near.joined(far)), keys(whole));
    EXPECT_EQ(far.is_before(near), far.length == 8);
  }
}

TEST(Division, GivesEachSiteToTheOneRegionThatHasIt) {
  constexpr unsigned kKeyBits = 9;
  Random random(20261292);
  std::vector<Site> sites(1000);
  for (Site& site : sites) site.key = static_cast<std::uint64_t>(unit(random) * (1U << kKeyBits));
  std::vector<Index> pending(sites.size());
  for (Index s = 0; s < sites.size(); ++s) pending[s] = s;
  const auto has_less = [&](Index a, Index b) { return sites[a].key < sites[b].key; };
  const auto expect_divided = [&](const std::vector<Stretch>& stretches) {
    std::size_t count = 0;
    for (const Stretch& stretch : stretches)
      for (const Index s : stretch.sites) {
        ++count;
        for (const Stretch& other : stretches)
          ASSERT_EQ(other.region.has(sites[s]), &other == &stretch);
      }
    EXPECT_EQ(count, sites.size());
  };
  const auto begin_again = [&] {
    std::sort(pending.begin(), pending.end(), has_less);
    return delaunay::Division<Index>(sites.data(), kKeyBits, pending);
  };
  for (const std::size_t threads : {1U, 2U, 3U, 16U}) {
    const std::vector<std::uint64_t> cuts = begin_again().cuts(threads);
    ASSERT_EQ(cuts.size(), 2 * threads);
    for (const std::size_t first : {std::size_t{0}, threads}) {
      const auto stretches = begin_again().between(std::span(cuts).subspan(first, threads));
      ASSERT_EQ(stretches.size(), threads);
      expect_divided(stretches);
      for (const Stretch& stretch : stretches)
        EXPECT_NEAR(static_cast<double>(stretch.sites.size()),
                    1000.0 / static_cast<double>(threads), 12);
    }
  }
  expect_divided(begin_again().crosswise());
}

/// Sites along a curve, which is the first axis: so many are inserted, the others pending.
class Line {
 public:
  using Inserter = delaunay::Inserter<Index, false>;
  using Worker = delaunay::Worker<Index, false>;
  static constexpr std::size_t kWorkers = 4;
  static constexpr unsigned kKeyBits = 20;
  static constexpr std::uint64_t kLastKey = (1U << kKeyBits) - 1;

  Line(std::size_t count, std::size_t inserted) : claims_(count + 2) {
    Random random(20261291);
    sites_ = sites_of(uniform(count, random), [](const mesh::Point& p) {
      return static_cast<std::uint64_t>(p.x * (kLastKey + 1));
    });
    cells_.reserve(10 * sites_.size());
    for (std::size_t t = 0; t < kWorkers; ++t)
      inserters_.emplace_back(cells_, sites_.data(), claims_.data(), nullptr);
    inserters_[0].begin(first_four<Index>(sites_));
    for (Index s = 6; s < inserted + 2; ++s) insert(s);
    for (auto s = static_cast<Index>(inserted + 2); s < sites_.size(); ++s) pending_.push_back(s);
    const auto has_less = [&](Index a, Index b) { return sites_[a].key < sites_[b].key; };
    std::sort(pending_.begin(), pending_.end(), has_less);
  }

  void insert(Index site) { ASSERT_EQ(inserters_[0].insert(site), delaunay::Outcome::inserted); }
  [[nodiscard]] const std::vector<Index>& pending() const { return pending_; }
  [[nodiscard]] Worker worker(std::size_t t, Handover& handover, std::size_t worth_giving) {
    return {inserters_[t], sites_.data(), handover, worth_giving};
  }
  /// All keys; the start is where the last insertion was.
  [[nodiscard]] Stretch all() {
    return {{0, kLastKey + 1, kLastKey}, pending_, inserters_[0].walk().start()};
  }
  /// With starts.
  [[nodiscard]] std::vector<Stretch> between(const std::vector<std::uint64_t>& cuts) {
    auto result = delaunay::Division<Index>(sites_.data(), kKeyBits, pending_).between(cuts);
    for (auto& [region, sites, start] : result)
      start = inserters_[0].walk().cell_within(region, sites);
    return result;
  }
  [[nodiscard]] std::set<std::array<Index, 4>> tetrahedra() const {
    std::set<std::array<Index, 4>> result;
    for (Index c = 1; c < cells_.size(); ++c)
      if (cells_[c].is_tetrahedron()) {
        auto vertices = cells_[c].vertices;
        std::sort(vertices.begin(), vertices.end());
        result.insert(vertices);
      }
    return result;
  }

 private:
  delaunay::Cells<Index> cells_;
  std::vector<Site> sites_;
  std::vector<Inserter::Claim> claims_;
  std::deque<Inserter> inserters_;
  std::vector<Index> pending_;
};

void append_left(const Line::Worker& worker, std::vector<Index>& left) {
  for (const auto& piece : worker.pieces())
    left.insert(left.end(), piece.left.begin(), piece.left.end());
}

std::set<std::array<Index, 4>> tetrahedra_of_one(std::size_t count, std::size_t inserted) {
  Line line(count, inserted);
  for (const Index s : line.pending()) line.insert(s);
  return line.tetrahedra();
}

TEST(Worker, GivesHalfOfItsStretchAway) {
  constexpr std::size_t kCount = 6000, kInserted = 500;
  Line line(kCount, kInserted);
  Handover handover;
  Line::Worker busy = line.worker(0, handover, 100), idle = line.worker(1, handover, 100);
  {
    Handover::Seat of_idle(handover);
    std::jthread waits;
    Handover::Seat of_busy(handover);  // ends before the other is waited for
    waits = std::jthread([&] {
      idle.work({{0, 0, Line::kLastKey}, {}, delaunay::kNone}, of_idle);
    });
    wait_until_wanted(handover);
    busy.work(line.all(), of_busy);
  }
  // The first of which the half was given, the empty one, and that half, whoever came to take it.
  EXPECT_GE(busy.pieces().size() + idle.pieces().size(), 3U);
  EXPECT_TRUE(busy.has_inserted());
  std::vector<Index> left;
  append_left(busy, left);
  append_left(idle, left);
  EXPECT_LT(left.size(), line.pending().size());
  for (const Index s : left) line.insert(s);
  EXPECT_EQ(line.tetrahedra(), tetrahedra_of_one(kCount, kInserted));
}

/// One of four workers has most of the sites, another those round the end of the curve. Gifts come
/// from neighbours and from others; a region that was joined wrongly would be that of two threads.
TEST(Worker, GetsWorkFromNeighboursAndOthers) {
  constexpr std::size_t kCount = 8000, kInserted = 1000;
  const auto expected = tetrahedra_of_one(kCount, kInserted);
  constexpr std::uint64_t kKeys = Line::kLastKey + 1;
  const std::vector<std::uint64_t> cuts{kKeys / 16, kKeys / 8, kKeys / 16 * 14, kKeys / 16 * 15};
  std::size_t pieces = 0;
  for (int run = 0; run < 5; ++run) {
    Line line(kCount, kInserted);
    Handover handover;
    std::vector<Index> left;
    {
      const std::vector<Stretch> stretches = line.between(cuts);
      std::deque<Line::Worker> workers;
      for (std::size_t t = 0; t < cuts.size(); ++t) workers.push_back(line.worker(t, handover, 40));
      parallel::parallel_for(static_cast<int>(cuts.size()), cuts.size(), [&](std::size_t t) {
        Handover::Seat seat(handover);
        workers[t].work(stretches[t], seat);
      });
      for (const Line::Worker& worker : workers) {
        pieces += worker.pieces().size();
        append_left(worker, left);
      }
    }
    for (const Index s : left) line.insert(s);
    ASSERT_EQ(line.tetrahedra(), expected);
  }
  EXPECT_GE(pieces, 20U);
}

}  // namespace
