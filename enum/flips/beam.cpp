#include "enum/flips/beam.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/errors.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

constexpr std::size_t kParentsPerChunk = 64;
constexpr std::size_t kChunksPerBatch = 256;

FrontStore::Limits limits_of(const BeamOptions& options) {
  return {options.fronts_per_class, options.max_fronts, options.seed, options.use_dominance};
}

}  // namespace

std::uint64_t price_of(const canon::Code& code, const BeamOptions& options, int max_quads) {
  std::uint64_t price = std::uint64_t{options.scars_per_quad} * code.quads;
  if (options.scars_per_irregularity == 0 && options.scars_per_simple_zone == 0) return price;
  // Of the trapezohedron with so many quads; no boundary, 3-connected as all are, has more
  // (docs/theory/proofs/irregularity.md).
  const int most_irregular = 2 * (max_quads / 2 - 4) * (max_quads / 2 - 4) + max_quads;
  const auto boundary = canon::decode(code).value();
  price += std::uint64_t{options.scars_per_irregularity} *
           static_cast<std::uint64_t>(most_irregular - boundary.irregularity());
  price += std::uint64_t{options.scars_per_simple_zone} *
           static_cast<std::uint64_t>(boundary.simple_zones());
  return price;
}

/// The children of a few parents, and in which order each shard is to see its own.
struct Beam::Chunk {
  std::vector<FrontStore::Offer> offers;
  std::vector<std::uint32_t> order;  ///< indices into `offers`, by shard, else ascending
  std::array<std::uint32_t, FrontStore::kShards + 1> begin{};

  void deal() {
    std::vector<std::uint8_t> shard(offers.size());
    begin.fill(0);
    for (std::size_t i = 0; i < offers.size(); ++i) {
      shard[i] = static_cast<std::uint8_t>(FrontStore::shard_of(offers[i].state.code));
      ++begin[shard[i] + std::size_t{1}];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    auto next = begin;
    order.resize(offers.size());
    for (std::uint32_t i = 0; i < offers.size(); ++i) order[next[shard[i]]++] = i;
  }
};

Beam::Beam(const State& start, const BeamOptions& options)
    : options_(options), store_(limits_of(options)) {
  core::expects(options.max_quads >= 6 && options.max_quads <= kMaxStateQuads,
                "boundaries have from 6 to 30 quads");
  core::expects(
      options.fronts_per_class >= 1 && options.fronts_per_level >= 1 && options.threads >= 1,
      "limits of a beam are at least 1");
  core::expects(options.scars_per_irregularity <= kMaxPerIrregularity,
                "a unit of irregularity counts as at most kMaxPerIrregularity scars");
  core::expects(options.scars_per_simple_zone <= kMaxPerSimpleZone,
                "a simple zone counts as at most kMaxPerSimpleZone scars");
  const FrontId id = store_.add({start, {}, {}, 0}, FrontOrigin::grown);
  store_.set_mark(id, FrontMark::chosen);
  frontier_.push_back(id);
}

std::size_t Beam::expand_level() {
  ++level_;
  const std::vector<FrontId> parents = std::exchange(frontier_, {});
  store_.begin_pass();
  constexpr std::size_t kBatch = kParentsPerChunk * kChunksPerBatch;
  for (std::size_t begin = 0; begin < parents.size(); begin += kBatch)
    expand_batch(std::span(parents).subspan(begin, std::min(kBatch, parents.size() - begin)));
  choose_frontier();
  return frontier_.size();
}

void Beam::rewind() {
  level_ = 0;
  store_.begin_sweep();
  for (const FrontId id : frontier_) store_.set_mark(id, FrontMark::waiting);
  frontier_.clear();
}

void Beam::expand_batch(std::span<const FrontId> batch) {
  std::vector<Chunk> chunks((batch.size() + kParentsPerChunk - 1) / kParentsPerChunk);
  const auto level = static_cast<std::uint16_t>(level_);
  parallel::parallel_for(options_.threads, chunks.size(), [&](std::size_t c) {
    const std::size_t begin = c * kParentsPerChunk;
    const std::size_t end = std::min(batch.size(), begin + kParentsPerChunk);
    for (const FrontId parent : batch.subspan(begin, end - begin)) {
      const Front front = front_of(state(parent));
      for_each_glueable(front, options_.max_quads, [&](Flip flip, const Prism& prism) {
        chunks[c].offers.push_back(
            {canonical_state(glued(front, flip, prism).front).state, parent, flip, level});
      });
    }
    chunks[c].deal();
  });
  for (const FrontId parent : batch) store_.set_mark(parent, FrontMark::expanded);
  parallel::parallel_for(options_.threads, FrontStore::kShards, [&](std::size_t shard) {
    for (const Chunk& chunk : chunks)
      for (std::uint32_t i = chunk.begin[shard]; i < chunk.begin[shard + 1]; ++i)
        store_.offer(shard, chunk.offers[chunk.order[i]]);
  });
  for (const Chunk& chunk : chunks) candidates_ += chunk.offers.size();
}

/// A state of this level that may be chosen.
struct Beam::Waiting {
  std::uint32_t turn;
  std::uint64_t rank;
  FrontId id;
};

/// Those of a shard, with their places in the order of preference of their class.
std::vector<Beam::Waiting> Beam::waiting(std::size_t shard) const {
  std::vector<Waiting> result;
  const auto families = store_.families(shard);
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (!store_.may_have_current(families[f])) continue;
    const auto& fronts = families[f].fronts;
    const std::size_t first = result.size();
    for (std::uint32_t place = 0; place < fronts.size(); ++place)
      if (fronts[place].level == level_ && fronts[place].mark == FrontMark::waiting)
        result.push_back({0, store_.rank(fronts[place]), {FrontStore::number_of(shard, f), place}});
    if (result.size() == first) continue;
    const std::uint64_t price =
        price_of(families[f].code, options_, kMaxStateQuads) * FrontStore::kScar;
    for (std::size_t i = first; i < result.size(); ++i) result[i].rank += price;
    std::sort(result.begin() + static_cast<std::ptrdiff_t>(first), result.end(),
              [](const Waiting& a, const Waiting& b) {
                return std::tie(a.rank, a.id) < std::tie(b.rank, b.id);
              });
    for (std::size_t i = first; i < result.size(); ++i)
      result[i].turn = static_cast<std::uint32_t>(i - first);
  }
  return result;
}

/// Chooses among the waiting states of this level: by their place in the order of preference of
/// their class, then by the number of scars. Every class gets its turn before any gets another.
void Beam::choose_frontier() {
  std::vector<Waiting> all;
  {
    std::array<std::vector<Waiting>, FrontStore::kShards> by_shard;
    parallel::parallel_for(options_.threads, FrontStore::kShards,
                           [&](std::size_t shard) { by_shard[shard] = waiting(shard); });
    std::size_t count = 0;
    for (const auto& own : by_shard) count += own.size();
    all.reserve(count);
    for (auto& own : by_shard) {
      all.insert(all.end(), own.begin(), own.end());
      own = {};
    }
  }
  if (!all.empty()) last_level_ = std::max(last_level_, level_);
  if (all.size() > options_.fronts_per_level) {
    store_.set_truncated();
    const auto keep = all.begin() + static_cast<std::ptrdiff_t>(options_.fronts_per_level);
    std::nth_element(all.begin(), keep, all.end(), [](const Waiting& a, const Waiting& b) {
      return std::tie(a.turn, a.rank, a.id) < std::tie(b.turn, b.rank, b.id);
    });
    all.erase(keep, all.end());
  }
  for (const Waiting& w : all) store_.set_mark(w.id, FrontMark::chosen);
  all = {};
  parallel::parallel_for(options_.threads, FrontStore::kShards,
                         [&](std::size_t shard) { store_.end_pass(shard); });
  collect_chosen();
}

void Beam::collect_chosen() {
  for (std::size_t shard = 0; shard < FrontStore::kShards; ++shard) {
    const auto families = store_.families(shard);
    for (std::size_t f = 0; f < families.size(); ++f) {
      if (!store_.may_have_current(families[f])) continue;
      for (std::uint32_t place = 0; place < families[f].fronts.size(); ++place)
        if (families[f].fronts[place].mark == FrontMark::chosen)
          frontier_.push_back({FrontStore::number_of(shard, f), place});
    }
  }
}

std::vector<FrontRecord> Beam::fronts_of(const canon::Code& code) const {
  std::vector<FrontRecord> result;
  const auto number = store_.find(code);
  if (!number) return result;
  const auto& fronts = store_.family(*number).fronts;
  for (std::uint32_t place = 0; place < fronts.size(); ++place)
    result.push_back({{*number, place}, fronts[place].level, fronts[place].scars});
  std::stable_sort(result.begin(), result.end(),
                   [](const FrontRecord& a, const FrontRecord& b) { return a.level < b.level; });
  return result;
}

std::optional<FrontId> Beam::smallest(const canon::Code& code) const {
  const auto family = store_.find(code);
  if (!family) return std::nullopt;
  const auto& fronts = store_.family(*family).fronts;
  const auto least = std::min_element(
      fronts.begin(), fronts.end(),
      [](const StoredFront& a, const StoredFront& b) { return a.level < b.level; });
  return FrontId{*family, static_cast<std::uint32_t>(least - fronts.begin())};
}

std::optional<int> Beam::first_level(const canon::Code& code) const {
  const auto id = smallest(code);
  if (!id) return std::nullopt;
  return level_of(*id);
}

std::vector<canon::Code> Beam::codes() const {
  std::vector<canon::Code> result;
  for (std::size_t shard = 0; shard < FrontStore::kShards; ++shard)
    for (const auto& own : store_.families(shard)) result.push_back(own.code);
  std::sort(result.begin(), result.end());
  return result;
}

FrontId Beam::add(FrontId from, Flip flip, FrontOrigin origin, canon::Labelling& label) {
  const Front front = front_of(state(from));
  const auto prism = prism_of(front.boundary, flip);
  core::expects(prism && may_glue(front, flip, *prism), "the hexahedron may be glued on");
  const CanonicalState made = canonical_state(glued(front, flip, *prism).front);
  label = made.label;
  const int level = level_of(from) + 1;
  last_level_ = std::max(last_level_, level);
  return store_.add({made.state, from, flip, static_cast<std::uint16_t>(level)}, origin);
}

std::vector<Beam::Step> Beam::path_to(FrontId id) const {
  std::vector<Step> path;
  for (FrontId at = id; level_of(at) > 0;) {
    const StoredFront& front = store_.at(at);
    path.push_back({front.parent, front.flip});
    at = front.parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace hexatlas::flips
