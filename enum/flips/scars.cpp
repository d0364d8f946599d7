#include "enum/flips/scars.hpp"

#include "enum/core/checks.hpp"

namespace hexatlas::flips {

using complex::Vertex;

std::vector<Position> positions_of(const complex::Quadrangulation& boundary,
                                   const canon::CanonicalFlags& flags, const Relation& related) {
  const Relation quads = relation_of_quads(boundary);
  std::vector<Position> result(static_cast<std::size_t>(flags.count));
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].label = canon::labelling_from(boundary, flags.flags[i]);
    result[i].is_mirrored = flags.flags[i].mirrored;
    result[i].scars = scars_of(related, quads, boundary.vertices(), result[i].label);
  }
  return result;
}

template <int kQuads>
ScarSet<kQuads> ScarSet<kQuads>::renamed(const canon::Labelling& label) const noexcept {
  ScarSet result;
  for (std::size_t high = 1; high < kQuads + 2; ++high)
    for (std::size_t low = 0; low < high; ++low) {
      const auto a = static_cast<Vertex>(low);
      const auto b = static_cast<Vertex>(high);
      if (has(a, b)) result.add(label[a], label[b]);
    }
  return result;
}

template <int kQuads>
std::uint64_t ScarSet<kQuads>::hash(std::uint64_t seed) const noexcept {
  std::uint64_t h = seed;
  constexpr std::size_t kAlways = 6;  // as many as boundaries in searches need
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if (i >= kAlways && words_[i] == 0) continue;
    h = (h ^ words_[i]) * 0x9E3779B97F4A7C15ULL;
    h ^= h >> 32U;
  }
  return h;
}

template class ScarSet<kMaxStateQuads>;
template class ScarSet<kMaxSymmetricQuads>;

CanonicalState canonical_state(const Front& front) {
  core::expects(front.boundary.quads() <= kMaxStateQuads, "a state has at most 30 quads");
  canon::CanonicalFlags flags;
  canon::canonical_flags(front.boundary, flags);
  const Relation quads = relation_of_quads(front.boundary);
  CanonicalState result;
  result.state.code = flags.code;
  for (int i = 0; i < flags.count; ++i) {
    const canon::Flag flag = flags.flags[static_cast<std::size_t>(i)];
    const canon::Labelling label = canon::labelling_from(front.boundary, flag);
    const Scars scars = scars_of(front.related, quads, front.boundary.vertices(), label);
    if (i > 0 && !(scars < result.state.scars)) continue;
    result.state.scars = scars;
    result.label = label;
    result.is_mirrored = flag.mirrored;
  }
  return result;
}

Front front_of(const State& state) {
  const auto boundary = canon::decode(state.code);
  core::expects(boundary.has_value(), "the code of a state can be decoded");
  return front_with(*boundary, state.scars);
}

}  // namespace hexatlas::flips
