#include "enum/flips/front_store.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <numeric>
#include <utility>

#include "enum/core/checks.hpp"

namespace hexatlas::flips {

std::size_t FrontStore::shard_of(const canon::Code& code) noexcept {
  return (std::hash<canon::Code>{}(code) >> 20U) % kShards;
}

std::size_t FrontStore::slot_of(const Shard& shard, const canon::Code& code) noexcept {
  const std::size_t mask = shard.slots.size() - 1;
  std::size_t slot = (std::hash<canon::Code>{}(code) >> 26U) & mask;
  while (shard.slots[slot] != 0 && shard.families[shard.slots[slot] - 1].code != code)
    slot = (slot + 1) & mask;
  return slot;
}

FrontStore::Family& FrontStore::family_for(Shard& shard, const canon::Code& code) {
  if (2 * (shard.families.size() + 1) > shard.slots.size()) {
    shard.slots.assign(std::bit_ceil(std::max<std::size_t>(16, 4 * (shard.families.size() + 1))),
                       0);
    for (std::size_t i = 0; i < shard.families.size(); ++i)
      shard.slots[slot_of(shard, shard.families[i].code)] = static_cast<std::uint32_t>(i + 1);
  }
  std::uint32_t& slot = shard.slots[slot_of(shard, code)];
  if (slot == 0) {
    shard.families.push_back({.code = code, .fronts = {}});
    slot = static_cast<std::uint32_t>(shard.families.size());
  }
  return shard.families[slot - 1];
}

void FrontStore::append_family(const canon::Code& code, std::vector<StoredFront> fronts) {
  Shard& shard = shards_[shard_of(code)];
  const std::size_t before = shard.families.size();
  Family& own = family_for(shard, code);
  core::expects(shard.families.size() == before + 1, "a family is restored once");
  shard.fronts += fronts.size();
  own.fronts = std::move(fronts);
  own.has_added = true;
  own.set_level_floor();
}

void FrontStore::Family::set_level_floor() noexcept {
  level_floor = 65535;
  for (const StoredFront& front : fronts) level_floor = std::min(level_floor, front.level);
}

void FrontStore::set_scars(FrontId id, const Scars& scars) noexcept {
  StoredFront& front = shards_[id.family % kShards].families[id.family / kShards].fronts[id.place];
  front.scars = scars;
  front.size = static_cast<std::uint16_t>(scars.size());
}

std::optional<std::uint32_t> FrontStore::find(const canon::Code& code) const noexcept {
  const std::size_t number = shard_of(code);
  const Shard& shard = shards_[number];
  if (shard.slots.empty()) return std::nullopt;
  const std::uint32_t slot = shard.slots[slot_of(shard, code)];
  if (slot == 0) return std::nullopt;
  return number_of(number, slot - 1);
}

std::uint64_t FrontStore::rank(const StoredFront& front) const noexcept {
  return front.size * kScar | front.scars.hash(limits_.seed + front.level) >> 16U;
}

bool FrontStore::is_dominated(const Family& own, const Offer& offer) const noexcept {
  const Scars& scars = offer.state.scars;
  return std::any_of(own.fronts.begin(), own.fronts.end(), [&](const StoredFront& f) {
    // A front that was passed over does not stand in for one that may yet be expanded.
    if (f.level > offer.level || (f.mark == FrontMark::waiting && f.level < offer.level))
      return false;
    return limits_.use_dominance ? f.scars.is_subset_of(scars) : f.scars == scars;
  });
}

bool FrontStore::is_full(const Shard& shard) const noexcept {
  return shard.fronts >= limits_.max_fronts / kShards;
}

/// Whether `wanted` may come; removes the worst fresh front if there are too many.
bool FrontStore::make_room(Shard& shard, Family& own, const StoredFront& wanted) {
  const auto fresh = own.fronts.begin() + own.fresh_begin;
  const bool family_is_full =
      own.fronts.end() - fresh >= static_cast<std::ptrdiff_t>(limits_.fronts_per_family);
  if (!family_is_full && !is_full(shard)) return true;
  shard.truncated = true;
  const auto worst = std::max_element(
      fresh, own.fronts.end(),
      [&](const StoredFront& a, const StoredFront& b) { return rank(a) < rank(b); });
  if (worst == own.fronts.end() || rank(*worst) <= rank(wanted)) return false;
  own.fronts.erase(worst);
  --shard.fronts;
  return true;
}

void FrontStore::offer(std::size_t number, const Offer& offer) {
  Shard& shard = shards_[number];
  if (is_full(shard) && !find(offer.state.code)) {
    shard.truncated = true;
    return;
  }
  Family& own = family_for(shard, offer.state.code);
  if (own.pass != pass_) {
    own.pass = pass_;
    own.fresh_begin = static_cast<std::uint32_t>(own.fronts.size());
  }
  if (is_dominated(own, offer)) return;
  const StoredFront made{.scars = offer.state.scars,
                         .parent = offer.parent,
                         .flip = offer.flip,
                         .level = offer.level,
                         .size = static_cast<std::uint16_t>(offer.state.scars.size())};
  bool takes_a_place = false;
  if (limits_.use_dominance) {
    const auto kept =
        std::remove_if(own.fronts.begin() + own.fresh_begin, own.fronts.end(),
                       [&](const StoredFront& f) { return made.scars.is_subset_of(f.scars); });
    takes_a_place = kept != own.fronts.end();
    shard.fronts -= static_cast<std::size_t>(own.fronts.end() - kept);
    own.fronts.erase(kept, own.fronts.end());
  }
  if (!takes_a_place && !make_room(shard, own, made)) return;
  own.level_floor = std::min(own.level_floor, made.level);
  own.fronts.push_back(made);
  ++shard.fronts;
}

void FrontStore::end_pass(std::size_t number) {
  Shard& shard = shards_[number];
  for (Family& own : shard.families) {
    if (own.pass != pass_) continue;
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(1, own.fresh_begin);
    if (first >= std::ssize(own.fronts)) continue;
    const auto kept =
        std::remove_if(own.fronts.begin() + first, own.fronts.end(),
                       [](const StoredFront& f) { return f.mark == FrontMark::waiting; });
    shard.fronts -= static_cast<std::size_t>(own.fronts.end() - kept);
    own.fronts.erase(kept, own.fronts.end());
    own.fronts.shrink_to_fit();
    own.set_level_floor();
  }
}

FrontId FrontStore::add(const Offer& offer, FrontOrigin origin) {
  const std::size_t number = shard_of(offer.state.code);
  Shard& shard = shards_[number];
  Family& own = family_for(shard, offer.state.code);
  const auto family = number_of(number, static_cast<std::size_t>(&own - shard.families.data()));
  for (std::size_t place = 0; place < own.fronts.size(); ++place)
    if (own.fronts[place].level <= offer.level &&
        own.fronts[place].scars.is_subset_of(offer.state.scars))
      return {family, static_cast<std::uint32_t>(place)};
  own.level_floor = std::min(own.level_floor, offer.level);
  own.has_added = true;
  own.fronts.push_back({.scars = offer.state.scars,
                        .parent = offer.parent,
                        .flip = offer.flip,
                        .level = offer.level,
                        .size = static_cast<std::uint16_t>(offer.state.scars.size()),
                        .origin = origin});
  ++shard.fronts;
  return {family, static_cast<std::uint32_t>(own.fronts.size() - 1)};
}

void FrontStore::set_mark(FrontId id, FrontMark mark) noexcept {
  shards_[id.family % kShards].families[id.family / kShards].fronts[id.place].mark = mark;
}

std::size_t FrontStore::fronts() const noexcept {
  return std::accumulate(shards_.begin(), shards_.end(), std::size_t{0},
                         [](std::size_t sum, const Shard& s) { return sum + s.fronts; });
}

std::size_t FrontStore::families() const noexcept {
  return std::accumulate(shards_.begin(), shards_.end(), std::size_t{0},
                         [](std::size_t sum, const Shard& s) { return sum + s.families.size(); });
}

bool FrontStore::is_truncated() const noexcept {
  return truncated_ ||
         std::any_of(shards_.begin(), shards_.end(), [](const Shard& s) { return s.truncated; });
}

}  // namespace hexatlas::flips
