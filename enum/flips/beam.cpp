#include "enum/flips/beam.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

constexpr std::size_t kShards = 64;
constexpr std::size_t kParentsPerChunk = 128;
constexpr std::size_t kChunksPerBatch = 256;

}  // namespace

struct Beam::Candidate {
  State state;
  FrontId parent;
  Flip flip;
  std::uint16_t size;  ///< number of scars
};

/// The classes whose codes hash to one number. Shards are merged independently, each in the
/// order of the candidates, so the result does not depend on the threads.
struct Beam::Shard {
  struct Node {
    Scars scars;
    std::uint32_t class_index;
    FrontId parent;
    Flip flip;
    std::uint16_t level;
    std::uint16_t size;
  };
  struct Class {
    canon::Code code;
    std::vector<std::uint32_t> nodes;  ///< in order of level
    std::uint32_t level_begin = 0;     ///< first place in `nodes` of level `level`
    int level = 0;
  };
  std::unordered_map<canon::Code, std::uint32_t> class_of;
  std::vector<Class> classes;
  std::vector<Node> nodes;
  std::size_t level_begin = 0;  ///< first node of the level being built
  std::uint64_t candidates = 0;
  bool truncated = false;
};

Beam::Beam(Beam&&) noexcept = default;
Beam& Beam::operator=(Beam&&) noexcept = default;
Beam::~Beam() = default;

namespace {

std::size_t shard_of(const canon::Code& code) noexcept {
  return (std::hash<canon::Code>{}(code) >> 20U) % kShards;
}

}  // namespace

Beam::Beam(const State& start, const BeamOptions& options) : options_(options), shards_(kShards) {
  core::expects(options.max_quads >= 6 && options.max_quads <= kMaxSearchQuads,
                "boundaries have from 6 to 24 quads");
  core::expects(
      options.fronts_per_class >= 1 && options.fronts_per_level >= 1 && options.threads >= 1,
      "limits of a beam are at least 1");
  const std::size_t number = shard_of(start.code);
  Shard& shard = shards_[number];
  shard.class_of.emplace(start.code, 0);
  shard.classes.push_back({.code = start.code, .nodes = {0}});
  shard.nodes.push_back(
      {start.scars, 0, {}, {}, 0, static_cast<std::uint16_t>(start.scars.size())});
  frontier_.push_back({static_cast<std::uint32_t>(number), 0});
}

std::size_t Beam::expand_level() {
  ++level_;
  for (Shard& shard : shards_) shard.level_begin = shard.nodes.size();
  const std::vector<FrontId> parents = std::exchange(frontier_, {});
  constexpr std::size_t kBatch = kParentsPerChunk * kChunksPerBatch;
  for (std::size_t begin = 0; begin < parents.size(); begin += kBatch)
    expand_batch(std::span(parents).subspan(begin, std::min(kBatch, parents.size() - begin)));
  collect_frontier();
  return frontier_.size();
}

void Beam::expand_batch(std::span<const FrontId> batch) {
  Chunks chunks((batch.size() + kParentsPerChunk - 1) / kParentsPerChunk);
  parallel::parallel_for(options_.threads, chunks.size(), [&](std::size_t c) {
    const std::size_t begin = c * kParentsPerChunk;
    const std::size_t end = std::min(batch.size(), begin + kParentsPerChunk);
    for (const FrontId parent : batch.subspan(begin, end - begin)) {
      const Front front = front_of(state(parent));
      for_each_glueable(front, options_.max_quads, [&](Flip flip, const Prism& prism) {
        const State child = canonical_state(glued(front, flip, prism).front).state;
        chunks[c].push_back({child, parent, flip, static_cast<std::uint16_t>(child.scars.size())});
      });
    }
  });
  parallel::parallel_for(options_.threads, kShards, [&](std::size_t s) {
    merge(shards_[s], static_cast<std::uint32_t>(s), chunks);
  });
  candidates_ = 0;
  for (const Shard& shard : shards_) {
    candidates_ += shard.candidates;
    truncated_ = truncated_ || shard.truncated;
  }
  if (fronts() > options_.max_fronts)
    throw core::ResourceFailure("the search needs more than " +
                                std::to_string(options_.max_fronts) +
                                " fronts in memory; lower the fronts per class or raise the limit");
}

void Beam::merge(Shard& shard, std::uint32_t number, const Chunks& chunks) {
  for (const auto& chunk : chunks)
    for (const Candidate& candidate : chunk)
      if (shard_of(candidate.state.code) == number) {
        ++shard.candidates;
        admit(shard, candidate);
      }
}

void Beam::admit(Shard& shard, const Candidate& candidate) {
  const auto [place, is_new] = shard.class_of.try_emplace(
      candidate.state.code, static_cast<std::uint32_t>(shard.classes.size()));
  if (is_new) shard.classes.push_back({.code = candidate.state.code, .nodes = {}});
  Shard::Class& own = shard.classes[place->second];
  if (own.level != level_) {
    own.level = level_;
    own.level_begin = static_cast<std::uint32_t>(own.nodes.size());
  }
  const Scars& scars = candidate.state.scars;
  const auto scars_at = [&](std::uint32_t node) -> const Scars& { return shard.nodes[node].scars; };
  for (const std::uint32_t node : own.nodes)
    if (options_.use_dominance ? scars_at(node).is_subset_of(scars) : scars_at(node) == scars)
      return;

  // Of the same level: drop what the candidate dominates, then the worst if there are too many.
  // Their slots in `nodes` are used again, so that memory follows what is kept.
  const auto rank = [&](const Scars& s, std::uint16_t size) {
    return std::pair(size, s.hash(options_.seed));
  };
  std::optional<std::uint32_t> slot;
  for (std::size_t i = own.level_begin; options_.use_dominance && i < own.nodes.size();) {
    if (!scars.is_subset_of(scars_at(own.nodes[i]))) {
      ++i;
      continue;
    }
    if (slot)
      shard.nodes[own.nodes[i]].level = 0;  // dead: level 0 is the start alone
    else
      slot = own.nodes[i];
    own.nodes.erase(own.nodes.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (own.nodes.size() - own.level_begin >= options_.fronts_per_class) {
    shard.truncated = true;
    const auto rank_at = [&](std::uint32_t node) {
      return rank(shard.nodes[node].scars, shard.nodes[node].size);
    };
    const auto worst =
        std::max_element(own.nodes.begin() + own.level_begin, own.nodes.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return rank_at(a) < rank_at(b); });
    if (!(rank(scars, candidate.size) < rank_at(*worst))) return;
    slot = *worst;
    own.nodes.erase(worst);
  }
  const Shard::Node node{scars,
                         place->second,
                         candidate.parent,
                         candidate.flip,
                         static_cast<std::uint16_t>(level_),
                         candidate.size};
  if (slot) {
    shard.nodes[*slot] = node;
  } else {
    slot = static_cast<std::uint32_t>(shard.nodes.size());
    shard.nodes.push_back(node);
  }
  own.nodes.push_back(*slot);
}

void Beam::collect_frontier() {
  frontier_.clear();
  for (std::size_t s = 0; s < kShards; ++s)
    for (std::size_t i = shards_[s].level_begin; i < shards_[s].nodes.size(); ++i)
      if (shards_[s].nodes[i].level == level_)
        frontier_.push_back({static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(i)});
  if (frontier_.size() <= options_.fronts_per_level) return;
  truncated_ = true;
  const auto rank = [&](FrontId id) {
    const Shard::Node& node = shards_[id.shard].nodes[id.index];
    return std::tuple(node.size, node.scars.hash(options_.seed + level_of(id)), id);
  };
  const auto keep = frontier_.begin() + static_cast<std::ptrdiff_t>(options_.fronts_per_level);
  std::nth_element(frontier_.begin(), keep, frontier_.end(),
                   [&](FrontId a, FrontId b) { return rank(a) < rank(b); });
  frontier_.erase(keep, frontier_.end());
  std::sort(frontier_.begin(), frontier_.end());
}

std::size_t Beam::fronts() const noexcept {
  return std::accumulate(shards_.begin(), shards_.end(), std::size_t{0},
                         [](std::size_t sum, const Shard& s) { return sum + s.nodes.size(); });
}

std::size_t Beam::classes() const noexcept {
  return std::accumulate(shards_.begin(), shards_.end(), std::size_t{0},
                         [](std::size_t sum, const Shard& s) { return sum + s.classes.size(); });
}

State Beam::state(FrontId id) const {
  const Shard& shard = shards_[id.shard];
  const Shard::Node& node = shard.nodes[id.index];
  return {shard.classes[node.class_index].code, node.scars};
}

int Beam::level_of(FrontId id) const noexcept { return shards_[id.shard].nodes[id.index].level; }

std::vector<FrontRecord> Beam::fronts_of(const canon::Code& code) const {
  std::vector<FrontRecord> result;
  const std::size_t number = shard_of(code);
  const Shard& shard = shards_[number];
  const auto place = shard.class_of.find(code);
  if (place == shard.class_of.end()) return result;
  for (const std::uint32_t index : shard.classes[place->second].nodes)
    result.push_back({{static_cast<std::uint32_t>(number), index},
                      shard.nodes[index].level,
                      shard.nodes[index].scars});
  return result;
}

std::optional<int> Beam::first_level(const canon::Code& code) const {
  const Shard& shard = shards_[shard_of(code)];
  const auto place = shard.class_of.find(code);
  if (place == shard.class_of.end()) return std::nullopt;
  const auto& nodes = shard.classes[place->second].nodes;
  if (nodes.empty()) return std::nullopt;
  return shard.nodes[nodes.front()].level;
}

std::vector<canon::Code> Beam::codes() const {
  std::vector<canon::Code> result;
  for (const Shard& shard : shards_)
    for (const auto& own : shard.classes)
      if (!own.nodes.empty()) result.push_back(own.code);
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Beam::Step> Beam::path_to(FrontId id) const {
  std::vector<Step> path;
  for (FrontId at = id; level_of(at) > 0;) {
    const Shard::Node& node = shards_[at.shard].nodes[at.index];
    path.push_back({node.parent, node.flip});
    at = node.parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace hexatlas::flips
