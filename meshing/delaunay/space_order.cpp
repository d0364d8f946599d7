#include "meshing/delaunay/space_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include "enum/core/random.hpp"
#include "meshing/delaunay/parts.hpp"

namespace hexatlas::delaunay {

/// Each thread counts and moves a part of the list; the places of a part follow those of the parts
/// before it.
void sort_by_key(PlacedList& points, unsigned bits, int threads) {
  constexpr unsigned kDigit = 11;
  constexpr std::size_t kDigits = std::size_t{1} << kDigit;
  PlacedList other(points.size());
  std::vector<std::array<std::size_t, kDigits>> places(static_cast<std::size_t>(threads));
  for (unsigned shift = 0; shift < bits; shift += kDigit) {
    const auto digit = [shift](const Placed& p) { return p.key >> shift & (kDigits - 1); };
    for_each_part(threads, points.size(),
                  [&](std::size_t part, std::size_t begin, std::size_t end) {
                    places[part].fill(0);
                    for (std::size_t i = begin; i < end; ++i) ++places[part][digit(points[i])];
                  });
    std::size_t place = 0;
    for (std::size_t d = 0; d < kDigits; ++d)
      for (auto& of_part : places) place += std::exchange(of_part[d], place);
    for_each_part(threads, points.size(),
                  [&](std::size_t part, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                      other[places[part][digit(points[i])]++] = points[i];
                  });
    points.swap(other);
  }
}

namespace {

constexpr unsigned kMostLevels = 19;      // so that a key and the number of a round fit
constexpr unsigned kExtraLevels = 3;      // finer than one point per cell, for uneven inputs
constexpr unsigned kFirstRoundBits = 10;  // about 2^10 points in the first round
constexpr unsigned kRoundBits = 3;        // a round has 2^3 times as many as all before

template <class Visit>
void for_each_group(std::span<const Placed> points, Visit&& visit) {
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && points[end].key == points[begin].key) ++end;
    visit(begin, end);
  }
}

/// Points in one cell of the grid, along a curve through a grid of their own. The keys stay.
void refine(std::span<Placed> group, std::span<const mesh::Point> points) {
  constexpr std::size_t kFew = 32;
  constexpr unsigned kLevels = 10;
  if (group.size() <= kFew) return;
  const auto at = [&](const Placed& p) -> const mesh::Point& { return points[p.point]; };
  const Curves curves(std::span<const Placed>(group), at, kLevels);
  PlacedList sorted;
  sorted.reserve(group.size());
  for (const Placed& p : group) sorted.push_back({curves.key_of(at(p)), p.point});
  sort_by_key(sorted, curves.key_bits(), 1);
  if (sorted.front().key == sorted.back().key) return;
  for (std::size_t i = 0; i < group.size(); ++i) group[i].point = sorted[i].point;
  for_each_group(std::span<const Placed>(sorted), [&](std::size_t begin, std::size_t end) {
    refine(group.subspan(begin, end - begin), points);
  });
}

/// Each group by the thread in whose part of the list it begins.
void refine_groups(std::span<Placed> sorted, std::span<const mesh::Point> points, int threads) {
  for_each_part(threads, sorted.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    const auto continues = [&](std::size_t i) {
      return i > 0 && i < sorted.size() && sorted[i].key == sorted[i - 1].key;
    };
    while (continues(begin)) ++begin;
    while (continues(end)) ++end;
    if (begin >= end) return;
    const auto part = sorted.subspan(begin, end - begin);
    for_each_group(std::span<const Placed>(part), [&](std::size_t from, std::size_t to) {
      refine(part.subspan(from, to - from), points);
    });
  });
}

}  // namespace

SpaceOrder space_order(std::span<const mesh::Point> points, std::uint64_t seed, int threads) {
  SpaceOrder order;
  if (points.empty()) return {{}, {0}, {}};
  const auto bits = static_cast<unsigned>(std::bit_width(points.size()));
  const unsigned levels = std::min(kMostLevels, bits / 3 + kExtraLevels);
  const unsigned rounds = 1 + (bits > kFirstRoundBits ? (bits - kFirstRoundBits) / kRoundBits : 0);
  order.curves = Curves(points, std::identity(), levels);
  const unsigned key_bits = order.curves.key_bits();
  order.points.resize(points.size());
  const auto place = [&](std::size_t i) {
    const auto zeros = static_cast<unsigned>(std::countl_zero(core::mixed(seed + i)));
    const std::uint64_t round = rounds - 1 - std::min(rounds - 1, zeros / kRoundBits);
    order.points[i] = {round << key_bits | order.curves.key_of(points[i]),
                       static_cast<std::uint32_t>(i)};
  };
  for_each_part(threads, points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) place(i);
  });
  sort_by_key(order.points, key_bits + static_cast<unsigned>(std::bit_width(rounds - 1)), threads);
  refine_groups(order.points, points, threads);
  const auto is_before = [key_bits](const Placed& p, std::uint64_t round) {
    return p.key >> key_bits < round;
  };
  for (std::uint64_t round = 0; round <= rounds; ++round)
    order.rounds.push_back(static_cast<std::size_t>(
        std::lower_bound(order.points.begin(), order.points.end(), round, is_before) -
        order.points.begin()));
  for_each_part(threads, points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      order.points[i].key &= (std::uint64_t{1} << key_bits) - 1;
  });
  return order;
}

}  // namespace hexatlas::delaunay
