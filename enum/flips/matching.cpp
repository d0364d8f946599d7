#include "enum/flips/matching.hpp"

#include <algorithm>

#include "enum/core/checks.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {

std::vector<Automorphism> automorphisms_of(const canon::Code& code) {
  const auto boundary = canon::decode(code).value();
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  std::vector<Automorphism> result;
  for (std::size_t i = 0; i < static_cast<std::size_t>(flags.count); ++i)
    result.push_back({canon::labelling_from(boundary, flags.flags[i]), flags.flags[i].mirrored});
  return result;
}

std::optional<Meeting> Matcher::match(std::span<const Cavity> cavities) {
  for (const Cavity& cavity : cavities) add_class(cavity);
  std::vector<std::optional<Meeting>> found((cavities.size() + kCavitiesPerTask - 1) /
                                            kCavitiesPerTask);
  parallel::parallel_for(threads_, found.size(), [&](std::size_t c) {
    int below = below_;
    const std::size_t end = std::min(cavities.size(), kCavitiesPerTask * (c + 1));
    for (std::size_t i = kCavitiesPerTask * c; i < end; ++i)
      if (const auto meeting = match_one(cavities[i], below)) {
        found[c] = meeting;
        found[c]->cavity = i;
        below = meeting->hexahedra;
      }
  });
  std::optional<Meeting> best;
  for (const auto& meeting : found)
    if (meeting && meeting->hexahedra < below_) {
      best = meeting;
      below_ = meeting->hexahedra;
    }
  return best;
}

/// Most classes have no ball that is small enough, and leave nothing.
void Matcher::add_class(const Cavity& cavity) {
  const canon::Code& code = cavity.state.code;
  const auto least = balls_.least_with(code);
  if (!least || cavity.collar + *least >= below_) return;
  const auto [place, is_new] = known_.try_emplace(code);
  if (!is_new) return;
  Fillings& own = place->second;
  own.balls = balls_.balls_with(code);
  own.automorphisms = automorphisms_of(code);
  for (std::uint32_t ball = 0; ball < own.balls.size(); ++ball)
    for (std::uint32_t turn = 0; turn < own.automorphisms.size(); ++turn)
      own.positions.push_back(
          {own.balls[ball].scars.renamed(own.automorphisms[turn].label), ball, turn});
}

std::optional<Meeting> Matcher::match_one(const Cavity& cavity, int below) const {
  const auto known = known_.find(cavity.state.code);
  if (known == known_.end()) return std::nullopt;
  const Fillings& own = known->second;
  for (const Fillings::Position& position : own.positions) {
    const int hexahedra = cavity.collar + own.balls[position.ball].hexahedra;
    if (hexahedra >= below) return std::nullopt;
    if (!position.scars.is_disjoint_from(cavity.state.scars)) continue;
    const auto& [label, is_mirrored] = own.automorphisms[position.turn];
    return Meeting{cavity.state.code, position.ball, 0, label, is_mirrored, hexahedra};
  }
  return std::nullopt;
}

std::vector<Promise> Matcher::promises(std::span<const Cavity> cavities, int price) const {
  std::vector<Promise> result(cavities.size());
  parallel::parallel_for(
      threads_, (cavities.size() + kCavitiesPerTask - 1) / kCavitiesPerTask, [&](std::size_t c) {
        const std::size_t end = std::min(cavities.size(), kCavitiesPerTask * (c + 1));
        for (std::size_t i = kCavitiesPerTask * c; i < end; ++i)
          result[i] = promise_of(cavities[i], price);
      });
  return result;
}

Promise Matcher::promise_of(const Cavity& cavity, int price) const {
  const auto known = known_.find(cavity.state.code);
  if (known == known_.end()) return kNoPromise;
  Promise least = kNoPromise;
  for (const Fillings::Position& position : known->second.positions) {
    const int hexahedra = cavity.collar + known->second.balls[position.ball].hexahedra;
    if (static_cast<Promise>(hexahedra) >= least) break;
    const int common = position.scars.size_in_common(cavity.state.scars);
    least = std::min(least, static_cast<Promise>(hexahedra + price * common));
  }
  return least;
}

complex::Quadrangulation boundary_of(const canon::Code& target) {
  const auto boundary = canon::decode(target);
  core::expects(boundary && boundary->is_three_connected(),
                "only a 3-connected boundary has a filling");
  return *boundary;
}

complex::HexComplex filled(const Layers& collar, const Layers& ball, const canon::Labelling& turn,
                           bool is_mirrored, int quads) {
  complex::HexComplex mesh{collar.vertices, collar.hexahedra};
  std::vector<complex::VertexId> rim(collar.rim.size());
  for (std::size_t v = 0; v < rim.size(); ++v) rim[v] = collar.rim[turn[v]];
  append_ball(mesh, ball, rim, collar.is_mirrored != is_mirrored);
  return complex::compacted(std::move(mesh), quads + 2);
}

Filling assembled(const BallSource& balls, const Layers& collar, const Meeting& meeting,
                  int quads) {
  return {filled(collar, balls.layers_of(meeting.boundary, meeting.ball), meeting.turn,
                 meeting.is_mirrored, quads)};
}

}  // namespace hexatlas::flips
