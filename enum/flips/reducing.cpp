#include "enum/flips/reducing.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"

namespace hexatlas::flips {
namespace {

using Patch = Peeling::Patch;

/// Sets of sides by how many quads their flips add: one side adds two; two sides keep the number;
/// three take two away, and four take four.
constexpr std::array<std::uint8_t, 4> kGrowing{1, 2, 4, 8};
constexpr std::array<std::uint8_t, 6> kKeeping{3, 5, 6, 9, 10, 12};
constexpr std::array<std::uint8_t, 5> kReducing{7, 11, 13, 14, 15};

class Reducer {
 public:
  Reducer(Peeling& peeling, const ReducingOptions& options)
      : peeling_(peeling), options_(options), open_(static_cast<std::size_t>(options.depth) + 1) {
    core::expects(options.depth >= 1, "a sequence has at least one flip");
  }

  void run() {
    std::vector<std::uint32_t> order = peeling_.live_quads();
    core::Random random(options_.seed);
    for (std::size_t i = order.size(); options_.seed != 0 && i > 1; --i)
      std::swap(order[i - 1], order[random.below(i)]);
    for (const std::uint32_t q : order) open(q, 1);
    while (const std::size_t length = least_open()) try_next(length);
  }

 private:
  /// Sequences of `length` flips are to be sought at the quad, unless shorter ones are already.
  void open(std::uint32_t quad, std::size_t length) {
    if (length >= open_.size()) return;
    waits_for_.resize(peeling_.quad_numbers(), 0);
    std::uint8_t& waits = waits_for_[quad];
    if (waits != 0 && waits <= length) return;
    waits = static_cast<std::uint8_t>(length);
    open_[length].push_back(quad);
  }
  [[nodiscard]] std::size_t least_open() const {
    for (std::size_t length = 1; length < open_.size(); ++length)
      if (!open_[length].empty()) return length;
    return 0;
  }

  void try_next(std::size_t length) {
    const std::uint32_t quad = open_[length].front();
    open_[length].pop_front();
    if (!peeling_.is_live(quad) || waits_for_[quad] != length) return;
    waits_for_[quad] = 0;
    best_.clear();
    best_is_most_ = false;
    looks_ = 0;
    first_new_ = peeling_.quad_numbers();
    look_at(quad, length);
    if (best_.empty())
      open(quad, length + 1);
    else
      apply();
  }

  void apply() {
    for (const Patch& patch : best_) {
      Peeling::Prism prism;
      core::expects(peeling_.may_take(patch, prism), "a sequence that was found can be repeated");
      peeling_.take(patch, prism);
    }
    for (std::uint32_t q = first_new_; q < peeling_.quad_numbers(); ++q) {
      if (!peeling_.is_live(q)) continue;
      open(q, 1);
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t near = neighbour(q, i);
        open(near, 1);
        for (unsigned k = 0; k < 4; ++k) open(neighbour(near, k), 1);
      }
    }
  }
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t quad, unsigned side) const {
    return peeling_.twin(4 * quad + side) / 4;
  }

  /// Sets of sides where neighbouring ones meet in an edge.
  [[nodiscard]] bool is_patch(unsigned sides, unsigned joined) const {
    const unsigned both = sides & (sides << 1U | sides >> 3U);  // side i and the one before it
    return (both & ~joined & 15U) == 0;
  }

  /// Flips with this bottom, `left` more to make. But for the first they take away a new quad.
  void look_at(std::uint32_t bottom, std::size_t left) {
    unsigned fresh = 0;
    unsigned joined = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (neighbour(bottom, i) >= first_new_) fresh |= 1U << i;
      if (peeling_.degree(peeling_.origin(4 * bottom + i)) == 3) joined |= 1U << i;
    }
    if (now_.empty() || bottom >= first_new_) fresh = 15;
    if (left == 1) {
      for (const std::uint8_t sides : kReducing)
        if ((sides & fresh) != 0 && is_patch(sides, joined)) end_with({bottom, sides});
      return;
    }
    if (options_.may_grow && !has_grown_) {
      has_grown_ = true;
      for (const std::uint8_t sides : kGrowing)
        if ((sides & fresh) != 0) go_on_with({bottom, sides}, left - 1);
      has_grown_ = false;
    }
    for (const std::uint8_t sides : kKeeping)
      if ((sides & fresh) != 0 && is_patch(sides, joined)) go_on_with({bottom, sides}, left - 1);
  }

  void end_with(Patch patch) {
    const bool is_most = patch.sides == kReducing.back();
    if (has_grown_ && !is_most) return;
    if (looks_ > options_.looks || !(best_.empty() || (is_most && !best_is_most_))) return;
    Peeling::Prism prism;
    ++looks_;
    if (!peeling_.may_take(patch, prism)) return;
    best_ = now_;
    best_.push_back(patch);
    best_is_most_ = is_most;
  }

  void go_on_with(Patch patch, std::size_t left) {
    if (looks_ > options_.looks) return;
    Peeling::Prism prism;
    ++looks_;
    if (!peeling_.may_take(patch, prism)) return;
    now_.push_back(patch);
    peeling_.take(patch, prism);
    look_around(left);
    peeling_.put_back();
    now_.pop_back();
  }

  void look_around(std::size_t left) {
    std::vector<std::uint32_t> bottoms;
    bottoms.reserve(32);
    for (std::uint32_t q = first_new_; q < peeling_.quad_numbers(); ++q) {
      if (!peeling_.is_live(q)) continue;
      bottoms.push_back(q);
      for (unsigned i = 0; i < 4; ++i)
        if (neighbour(q, i) < first_new_) bottoms.push_back(neighbour(q, i));
    }
    std::sort(bottoms.begin(), bottoms.end());
    bottoms.erase(std::unique(bottoms.begin(), bottoms.end()), bottoms.end());
    for (const std::uint32_t q : bottoms) look_at(q, left);
  }

  Peeling& peeling_;
  const ReducingOptions& options_;
  std::vector<std::deque<std::uint32_t>> open_;  ///< by length
  std::vector<std::uint8_t> waits_for_;          ///< length, of each quad; 0: for none
  std::vector<Patch> now_, best_;
  bool best_is_most_ = false;
  bool has_grown_ = false;
  std::size_t looks_ = 0;
  std::uint32_t first_new_ = 0;  ///< quads from here on are made by the sequence
};

}  // namespace

void reduce(Peeling& peeling, const ReducingOptions& options) { Reducer(peeling, options).run(); }

}  // namespace hexatlas::flips
