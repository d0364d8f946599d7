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
namespace {

constexpr unsigned kMostLevels = 19;      // so that a key and the number of a round fit
constexpr unsigned kExtraLevels = 3;      // finer than one point per cell, for uneven inputs
constexpr unsigned kFirstRoundBits = 10;  // about 2^10 points in the first round
constexpr unsigned kRoundBits = 3;        // a round has 2^3 times as many as all before

/// A Hilbert curve, turned: entry is the corner of its cube where it comes in; it leaves at the
/// neighbour of this corner along the axis. One state for each pair.
struct Step {
  std::uint8_t digit, state;
};

constexpr unsigned rotated_left(unsigned bits, unsigned by) {
  by %= 3;
  return ((bits << by) | (bits >> (3 - by))) & 7U;
}
constexpr unsigned gray(unsigned i) { return i ^ (i >> 1U); }
constexpr unsigned gray_inverse(unsigned g) { return (g ^ (g >> 1U) ^ (g >> 2U)) & 7U; }

constexpr Step step_from(unsigned state, unsigned octant) {
  const unsigned entry = state & 7U, axis = state >> 3U;
  const unsigned digit = gray_inverse(rotated_left(octant ^ entry, 3 - (axis + 1) % 3));
  const unsigned local_entry = digit == 0 ? 0 : gray(2 * ((digit - 1) / 2));
  const unsigned turned =
      digit == 0 ? 0 : static_cast<unsigned>(std::countr_one(digit % 2 == 0 ? digit - 1 : digit));
  const unsigned next_entry = entry ^ rotated_left(local_entry, axis + 1);
  const unsigned next_axis = (axis + turned % 3 + 1) % 3;
  return {static_cast<std::uint8_t>(digit),
          static_cast<std::uint8_t>(next_entry | next_axis << 3U)};
}

constexpr auto kSteps = [] {
  std::array<std::array<Step, 8>, 24> steps{};
  for (unsigned state = 0; state < 24; ++state)
    for (unsigned octant = 0; octant < 8; ++octant) steps[state][octant] = step_from(state, octant);
  return steps;
}();

/// The closed curve: the octants in the order of a cyclic Gray code, in each a Hilbert curve that
/// leaves where the next one comes in. Searched, since there are few.
class MooreCurve {
 public:
  constexpr MooreCurve() {
    for (unsigned entry = 0; entry < 8; ++entry)
      if (is_closed_from(0, entry, entry)) return;
  }
  /// By octants.
  [[nodiscard]] constexpr const std::array<Step, 8>& steps() const { return steps_; }

 private:
  constexpr bool is_closed_from(unsigned digit, unsigned entry, unsigned first_entry) {
    if (digit == 8) return entry == first_entry;
    const unsigned octant = gray(digit), next = gray((digit + 1) % 8);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned exit = entry ^ 1U << axis;
      if (((exit ^ next) & (octant ^ next)) != 0) continue;  // not beside the next octant
      steps_[octant] = {static_cast<std::uint8_t>(digit),
                        static_cast<std::uint8_t>(entry | axis << 3U)};
      if (is_closed_from(digit + 1, exit ^ octant ^ next, first_entry)) return true;
    }
    return false;
  }
  std::array<Step, 8> steps_{};
};

constexpr MooreCurve kMoore;

std::uint64_t curve_key(const std::array<std::uint32_t, 3>& cell, unsigned levels) {
  const auto octant_at = [&](unsigned level) {
    return (cell[0] >> level & 1U) | (cell[1] >> level & 1U) << 1U | (cell[2] >> level & 1U) << 2U;
  };
  Step step = kMoore.steps()[octant_at(levels - 1)];
  std::uint64_t key = step.digit;
  for (unsigned level = levels - 1; level-- > 0;) {
    step = kSteps[step.state][octant_at(level)];
    key = key << 3U | step.digit;
  }
  return key;
}

/// A cube with 2^levels cells along each axis, around some points.
class Grid {
 public:
  /// at(item) is the point of an item.
  template <class Item, class At>
  Grid(std::span<const Item> items, At&& at, unsigned levels) : levels_(levels) {
    mesh::Point high = low_ = at(items.front());
    for (const Item& item : items) {
      const mesh::Point& p = at(item);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    width_ = std::max({half(high.x, low_.x), half(high.y, low_.y), half(high.z, low_.z)});
    if (width_ == 0) width_ = 1;
  }
  [[nodiscard]] std::uint64_t key_of(const mesh::Point& p) const {
    return curve_key({cell(p.x, low_.x), cell(p.y, low_.y), cell(p.z, low_.z)}, levels_);
  }

 private:
  /// Half of the difference, so that it is finite.
  [[nodiscard]] static double half(double to, double from) { return to / 2 - from / 2; }
  [[nodiscard]] std::uint32_t cell(double value, double low) const {
    const std::uint32_t cells = 1U << levels_;
    return std::min(cells - 1, static_cast<std::uint32_t>(half(value, low) / width_ * cells));
  }

  unsigned levels_;
  mesh::Point low_{};
  double width_ = 1;
};

/// By the lowest `bits` bits of the keys; equal ones stay in order. Each thread counts and moves a
/// part of the list; the places of a part follow those of the parts before it.
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
  const Grid grid(std::span<const Placed>(group), at, kLevels);
  PlacedList sorted;
  sorted.reserve(group.size());
  for (const Placed& p : group) sorted.push_back({grid.key_of(at(p)), p.point});
  sort_by_key(sorted, 3 * kLevels, 1);
  if (sorted.front().key == sorted.back().key) return;
  for (std::size_t i = 0; i < group.size(); ++i) group[i].point = sorted[i].point;
  for_each_group(std::span<const Placed>(sorted), [&](std::size_t begin, std::size_t end) {
    refine(group.subspan(begin, end - begin), points);
  });
}

}  // namespace

SpaceOrder space_order(std::span<const mesh::Point> points, std::uint64_t seed, int threads) {
  SpaceOrder order;
  if (points.empty()) return {{}, {0}};
  const auto bits = static_cast<unsigned>(std::bit_width(points.size()));
  const unsigned levels = std::min(kMostLevels, bits / 3 + kExtraLevels);
  const unsigned rounds = 1 + (bits > kFirstRoundBits ? (bits - kFirstRoundBits) / kRoundBits : 0);
  const Grid grid(points, std::identity(), levels);
  order.points.resize(points.size());
  const auto place = [&](std::size_t i) {
    const auto zeros = static_cast<unsigned>(std::countl_zero(core::mixed(seed + i)));
    const std::uint64_t round = rounds - 1 - std::min(rounds - 1, zeros / kRoundBits);
    order.points[i] = {round << (3 * levels) | grid.key_of(points[i]),
                       static_cast<std::uint32_t>(i)};
  };
  for_each_part(threads, points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) place(i);
  });
  sort_by_key(order.points, 3 * levels + static_cast<unsigned>(std::bit_width(rounds - 1)),
              threads);
  for_each_group(std::span<const Placed>(order.points), [&](std::size_t begin, std::size_t end) {
    refine(std::span(order.points).subspan(begin, end - begin), points);
  });
  order.rounds.assign(1, 0);
  for (std::size_t i = 0; i < order.points.size(); ++i) {
    const std::uint64_t round = order.points[i].key >> (3 * levels);
    while (order.rounds.size() <= round) order.rounds.push_back(i);
    order.points[i].key &= (std::uint64_t{1} << (3 * levels)) - 1;
  }
  order.rounds.push_back(points.size());
  order.key_bits = 3 * levels;
  return order;
}

}  // namespace hexatlas::delaunay
