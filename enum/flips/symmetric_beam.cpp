#include "enum/flips/symmetric_beam.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/crown.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

constexpr std::uint32_t kParentsPerChunk = 64;
constexpr std::uint32_t kChunksPerBatch = 64;

/// The same with its rim in the canonical numbering.
Layers in_canonical_numbers(Layers layers, const CanonicalSymmetricState& canonical) {
  const std::vector<std::uint32_t> rim = layers.rim;
  for (std::size_t v = 0; v < rim.size(); ++v) layers.rim[canonical.label[v]] = rim[v];
  layers.is_mirrored = layers.is_mirrored != canonical.is_mirrored;
  return layers;
}

}  // namespace

SymmetricStart start_of_collars(const SymmetricFront& front) {
  SymmetricStart result{front, {}};
  result.layers.vertices = static_cast<std::uint32_t>(front.front.boundary.vertices());
  result.layers.rim.resize(result.layers.vertices);
  std::iota(result.layers.rim.begin(), result.layers.rim.end(), 0U);
  return result;
}

std::vector<SymmetricStart> small_symmetric_balls(int max_hexahedra, bool are_mirrored) {
  constexpr std::size_t kAll = 100'000'000;
  Beam balls(canonical_state(single_hexahedron()).state,
             {.max_quads = kMaxStateQuads, .fronts_per_class = kAll, .fronts_per_level = kAll});
  std::vector<SymmetricStart> result;
  for (int hexahedra = 1; hexahedra <= max_hexahedra; ++hexahedra) {
    if (hexahedra > 1) (void)balls.expand_level();
    for (const FrontId id : balls.frontier()) {
      const State state = balls.state(id);
      const auto boundary = canon::decode(state.code).value();
      for (const Involution& involution : involutions_of(boundary, state.scars))
        if (involution.is_mirrored == are_mirrored)
          result.push_back({symmetric_front(boundary, state.scars, involution),
                            layers_along(balls, id, Growth::outward)});
    }
  }
  return result;
}

std::size_t SymmetricBeam::NodeSet::slot_of(const SymmetricState& state) const noexcept {
  std::size_t slot = state.hash(1) % slots_.size();
  while (slots_[slot] != 0 && nodes_[slots_[slot] - 1].state != state)
    slot = slot + 1 == slots_.size() ? 0 : slot + 1;
  return slot;
}

bool SymmetricBeam::NodeSet::contains(const SymmetricState& state) const noexcept {
  return !slots_.empty() && slots_[slot_of(state)] != 0;
}

void SymmetricBeam::NodeSet::make_slots(std::size_t count) {
  slots_.assign(count, 0);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) slots_[slot_of(nodes_[i].state)] = i + 1;
}

void SymmetricBeam::NodeSet::insert(const Node& node) {
  constexpr std::size_t kFewest = 64;
  if (2 * (nodes_.size() + 1) > slots_.size()) make_slots(std::max(kFewest, 2 * slots_.size()));
  const std::size_t slot = slot_of(node.state);
  if (slots_[slot] != 0) return;
  nodes_.push_back(node);
  slots_[slot] = static_cast<std::uint32_t>(nodes_.size());
}

void SymmetricBeam::NodeSet::remove_those_of(const NodeSet& other) {
  const std::size_t before = nodes_.size();
  std::erase_if(nodes_, [&](const Node& node) { return other.contains(node.state); });
  if (nodes_.size() < before) make_slots(slots_.size());
}

SymmetricBeam::SymmetricBeam(std::vector<SymmetricStart> starts, Growth growth,
                             const BeamOptions& options)
    : options_(options), growth_(growth), open_(kMostInOrbit + 1) {
  core::expects(options.max_quads >= 6 && options.max_quads <= kMaxSymmetricQuads,
                "boundaries have from 6 to 40 quads");
  core::expects(
      options.fronts_per_class >= 1 && options.fronts_per_level >= 1 && options.threads >= 1,
      "limits of a beam are at least 1");
  for (SymmetricStart& start : starts) {
    const CanonicalSymmetricState canonical = canonical_state(start.front);
    const std::size_t level = start.layers.hexahedra.size();
    if (open_.size() <= level) open_.resize(level + 1);
    open_[level].insert({canonical.state, static_cast<std::uint32_t>(starts_.size()),
                         Orbit{.size = 0}, static_cast<std::uint16_t>(level)});
    starts_.push_back(in_canonical_numbers(std::move(start.layers), canonical));
  }
}

/// The nodes of this level to be expanded, ascending.
std::vector<std::uint32_t> SymmetricBeam::choose(std::span<const Promise> promises) {
  struct Waiting {
    std::uint64_t kind = 0;
    std::uint64_t scars = 0;  ///< and the price of the boundary
    std::uint64_t tie = 0;
    std::uint32_t index = 0;
    std::uint32_t turn = 0;
  };
  const auto nodes = this->nodes();
  std::vector<Waiting> all(nodes.size());
  parallel::parallel_for(options_.threads, (nodes.size() + 1023) / 1024, [&](std::size_t chunk) {
    for (std::size_t i = 1024 * chunk; i < std::min(nodes.size(), 1024 * (chunk + 1)); ++i) {
      const SymmetricState& state = nodes[i].state;
      const std::uint64_t price = price_of(state.code, options_, kMaxSymmetricQuads);
      all[i] = {state.hash_of_class(), static_cast<std::uint64_t>(state.scars.size()) + price,
                state.hash(options_.seed), static_cast<std::uint32_t>(i)};
    }
  });
  std::sort(all.begin(), all.end(), [](const Waiting& a, const Waiting& b) {
    return std::tie(a.kind, a.scars, a.tie, a.index) < std::tie(b.kind, b.scars, b.tie, b.index);
  });
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].kind == all[i - 1].kind) all[i].turn = all[i - 1].turn + 1;
  std::erase_if(all, [&](const Waiting& w) { return w.turn >= options_.fronts_per_class; });
  if (all.size() > options_.fronts_per_level) {
    const auto half = all.begin() + static_cast<std::ptrdiff_t>(options_.fronts_per_level / 2);
    auto first = all.begin();  // of those that the other order decides about
    if (!promises.empty()) {
      std::nth_element(all.begin(), half, all.end(), [&](const Waiting& a, const Waiting& b) {
        return std::tie(promises[a.index], a.scars, a.tie, a.index) <
               std::tie(promises[b.index], b.scars, b.tie, b.index);
      });
      first = std::partition(all.begin(), half,
                             [&](const Waiting& w) { return promises[w.index] != kNoPromise; });
    }
    const auto keep = all.begin() + static_cast<std::ptrdiff_t>(options_.fronts_per_level);
    std::nth_element(first, keep, all.end(), [](const Waiting& a, const Waiting& b) {
      return std::tie(a.turn, a.scars, a.tie, a.index) < std::tie(b.turn, b.scars, b.tie, b.index);
    });
    all.erase(keep, all.end());
  }
  is_truncated_ = is_truncated_ || all.size() < nodes.size();
  std::vector<std::uint32_t> result(all.size());
  std::transform(all.begin(), all.end(), result.begin(), [](const Waiting& w) { return w.index; });
  std::sort(result.begin(), result.end());
  return result;
}

bool SymmetricBeam::expand_level(std::span<const Promise> promises) {
  core::expects(promises.empty() || promises.size() == nodes().size(), "one promise for each node");
  const auto begin = static_cast<std::uint32_t>(expanded_.nodes().size());
  for (const std::uint32_t i : choose(promises)) expanded_.insert(nodes()[i]);
  std::rotate(open_.begin(), open_.begin() + 1, open_.end());
  open_.back() = {};
  ++level_;
  expand(begin, static_cast<std::uint32_t>(expanded_.nodes().size()));
  open_[0].remove_those_of(expanded_);
  return std::any_of(open_.begin(), open_.end(),
                     [](const NodeSet& level) { return !level.nodes().empty(); });
}

void SymmetricBeam::expand(std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t kBatch = kParentsPerChunk * kChunksPerBatch;
  for (; begin < end; begin += std::min(kBatch, end - begin)) {
    const std::uint32_t count = std::min(kBatch, end - begin);
    std::vector<std::vector<Node>> made((count + kParentsPerChunk - 1) / kParentsPerChunk);
    parallel::parallel_for(options_.threads, made.size(), [&](std::size_t c) {
      const std::uint32_t first = begin + kParentsPerChunk * static_cast<std::uint32_t>(c);
      for (std::uint32_t i = first; i < std::min(begin + count, first + kParentsPerChunk); ++i) {
        const SymmetricFront front = front_of(expanded_.nodes()[i].state);
        const auto make = [&](const GluedOrbit& next) {
          made[c].push_back({canonical_state(next.made).state, i, next.orbit,
                             static_cast<std::uint16_t>(level_ - 1 + next.orbit.size)});
        };
        for_each_glueable_orbit(front, options_.max_quads, make);
        for_each_glueable_crown(front, options_.max_quads, make);
      }
    });
    for (const auto& chunk : made)
      for (const Node& node : chunk) {
        if (expanded_.contains(node.state)) continue;
        if (states() >= options_.max_fronts) {
          is_truncated_ = true;
          return;
        }
        open_[node.orbit.size - std::size_t{1}].insert(node);
      }
  }
}

std::size_t SymmetricBeam::states() const noexcept {
  return std::accumulate(
      open_.begin(), open_.end(), expanded_.nodes().size(),
      [](std::size_t sum, const NodeSet& level) { return sum + level.nodes().size(); });
}

Layers SymmetricBeam::layers_to(const Node& node) const {
  std::vector<const Node*> path;
  const Node* first = &node;
  for (; !first->is_start(); first = &expanded_.nodes()[first->parent]) path.push_back(first);
  std::reverse(path.begin(), path.end());

  Layers result = starts_[first->parent];
  // The hexahedra of an orbit lie inside of the front on which they are glued.
  const bool is_outward = growth_ == Growth::outward;
  for (const Node* at : path) {
    const SymmetricFront front = front_of(expanded_.nodes()[at->parent].state);
    const GluedOrbit next = glued(front, at->orbit);
    std::vector<std::uint32_t> vertex_of = result.rim;  // of each name
    for (int i = 0; i < 4 * at->orbit.size; ++i) vertex_of.push_back(result.vertices++);
    for (std::size_t k = 0; k < at->orbit.size; ++k) {
      complex::Hexahedron cell{};
      for (std::size_t c = 0; c < cell.size(); ++c) cell[c] = vertex_of[next.cell[k][c]];
      if (result.is_mirrored != is_outward) cells::exchange_axes(cell);
      result.hexahedra.push_back(cell);
    }
    const CanonicalSymmetricState canonical = canonical_state(next.made);
    result.rim.resize(canonical.state.code.quads + std::size_t{2});
    for (std::size_t v = 0; v < result.rim.size(); ++v)
      result.rim[canonical.label[v]] = vertex_of[next.former[v]];
    result.is_mirrored = result.is_mirrored != canonical.is_mirrored;
  }
  return result;
}

}  // namespace hexatlas::flips
