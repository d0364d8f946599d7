#include "enum/flips/symmetric_balls.hpp"

#include <algorithm>
#include <utility>

#include "enum/flips/matching.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

/// Balls with an involution that orbits and crowns build on no smaller one: up to two hexahedra,
/// and four and six around an edge (docs/theory/proofs/symmetric.md, section 6, has the others).
constexpr int kStartHexahedra = 6;

SymmetricBeam beam_of(const BeamOptions& options, bool are_mirrored) {
  std::vector<SymmetricStart> starts = small_symmetric_balls(kStartHexahedra, are_mirrored);
  std::erase_if(starts, [&](const SymmetricStart& start) {
    return start.front.front.boundary.quads() > options.max_quads;
  });
  return {std::move(starts), Growth::outward, options};
}

/// The automorphisms of a boundary that commute with the involution: the ways to see the state as
/// the canonical one, but for its scars.
std::vector<Automorphism> turns_of(const SymmetricState& state) {
  std::vector<Automorphism> result = automorphisms_of(state.code);
  std::erase_if(result, [&](const Automorphism& turn) {
    for (std::size_t v = 0; v < state.code.quads + std::size_t{2}; ++v)
      if (state.image[turn.label[v]] != turn.label[state.image[v]]) return true;
    return false;
  });
  return result;
}

}  // namespace

SymmetricBalls::SymmetricBalls(const BeamOptions& options, int max_hexahedra)
    : beams_{beam_of(options, false), beam_of(options, true)} {
  for (std::size_t k = 0; k < beams_.size(); ++k) {
    while (beams_[k].level() <= max_hexahedra && beams_[k].expand_level()) {
    }
    const auto balls = beams_[k].expanded();
    for (std::uint32_t i = 0; i < balls.size(); ++i)
      by_kind_[k].push_back({balls[i].state.hash_of_class(), i});
    std::sort(by_kind_[k].begin(), by_kind_[k].end());
  }
}

std::size_t SymmetricBalls::size() const noexcept {
  return beams_[0].expanded().size() + beams_[1].expanded().size();
}

std::optional<SymmetricFit> SymmetricBalls::least_fit(std::span<const SymmetricBeam::Node> cavities,
                                                      int below, int threads) const {
  const SymmetricFit none{.hexahedra = below};
  std::vector<SymmetricFit> found((cavities.size() + kCavitiesPerTask - 1) / kCavitiesPerTask,
                                  none);
  parallel::parallel_for(threads, found.size(), [&](std::size_t c) {
    const std::size_t end = std::min(cavities.size(), kCavitiesPerTask * (c + 1));
    for (std::size_t i = kCavitiesPerTask * c; i < end; ++i) {
      const int before = found[c].hexahedra;
      fit_one(cavities[i], found[c]);
      if (found[c].hexahedra < before) found[c].cavity = i;
    }
  });
  const auto best = std::min_element(
      found.begin(), found.end(),
      [](const SymmetricFit& a, const SymmetricFit& b) { return a.hexahedra < b.hexahedra; });
  if (best == found.end() || best->hexahedra >= below) return std::nullopt;
  return *best;
}

/// The entries of a kind ascend by their number of hexahedra.
template <class OfKind>
void SymmetricBalls::for_each_of_kind(const SymmetricBeam::Node& cavity, OfKind&& visit) const {
  const std::uint64_t kind = cavity.state.hash_of_class();
  for (std::size_t k = 0; k < beams_.size(); ++k) {
    const auto balls = beams_[k].expanded();
    for (auto at = std::lower_bound(by_kind_[k].begin(), by_kind_[k].end(), Entry{kind, 0});
         at != by_kind_[k].end() && at->kind == kind; ++at) {
      const SymmetricState& own = balls[at->ball].state;
      if (own.code != cavity.state.code || own.image != cavity.state.image) continue;
      if (!visit(k, at->ball)) break;
    }
  }
}

void SymmetricBalls::fit_one(const SymmetricBeam::Node& cavity, SymmetricFit& best) const {
  std::vector<Automorphism> turns;
  for_each_of_kind(cavity, [&](std::size_t k, std::uint32_t place) {
    const SymmetricBeam::Node& ball = beams_[k].expanded()[place];
    if (cavity.level + ball.level >= best.hexahedra) return false;
    if (turns.empty()) turns = turns_of(cavity.state);
    const auto fits = std::find_if(turns.begin(), turns.end(), [&](const Automorphism& turn) {
      return ball.state.scars.renamed(turn.label).is_disjoint_from(cavity.state.scars);
    });
    if (fits == turns.end()) return true;
    best = {0, k == 1, place, fits->label, fits->is_mirrored, cavity.level + ball.level};
    return false;
  });
}

void SymmetricBalls::for_each_pairing(const SymmetricBeam::Node& cavity, const FaultyWanted& wanted,
                                      const Visit& visit) const {
  std::vector<Automorphism> turns;
  for_each_of_kind(cavity, [&](std::size_t k, std::uint32_t place) {
    const SymmetricBeam::Node& ball = beams_[k].expanded()[place];
    const int hexahedra = cavity.level + ball.level;
    if (!wanted.includes(hexahedra, 0)) return false;
    if (turns.empty()) turns = turns_of(cavity.state);
    for (std::size_t t = 0; t < turns.size(); ++t) {
      const int faults =
          ball.state.scars.renamed(turns[t].label).size_in_common(cavity.state.scars);
      if (wanted.includes(hexahedra, faults))
        visit({place, static_cast<std::uint16_t>(t), k == 1}, hexahedra, faults);
    }
    return true;
  });
}

SymmetricFit SymmetricBalls::fit_of(const SymmetricBeam::Node& cavity,
                                    const SymmetricPairing& pairing) const {
  const Automorphism turn = turns_of(cavity.state)[pairing.turn];
  const auto& ball = beams_[pairing.is_of_mirrored ? 1 : 0].expanded()[pairing.ball];
  return {0,          pairing.is_of_mirrored, pairing.ball,
          turn.label, turn.is_mirrored,       cavity.level + ball.level};
}

Layers SymmetricBalls::layers_of(const SymmetricFit& fit) const {
  const SymmetricBeam& beam = beams_[fit.is_of_mirrored ? 1 : 0];
  return beam.layers_to(beam.expanded()[fit.ball]);
}

}  // namespace hexatlas::flips
