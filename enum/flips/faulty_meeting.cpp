#include "enum/flips/faulty_meeting.hpp"

#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {
namespace {

/// A ball in a cavity, turned so that its canonical boundary vertex v lies at the cavity's vertex
/// labelling_from(canonical list of the cavity, turn)[v]. There may be millions.
struct Pairing {
  FrontId cavity, ball;
  canon::Flag turn;
};

canon::Labelling inverse_of(const canon::Labelling& label, int vertices) {
  canon::Labelling result{};
  for (int v = 0; v < vertices; ++v)
    result[label[static_cast<std::size_t>(v)]] = static_cast<complex::Vertex>(v);
  return result;
}

/// Adds the pairings with one cavity.
void add_pairings(const Beam& balls, const Beam& collars, FrontId cavity,
                  const FaultyMeetingOptions& options, FaultyKinds<Pairing>& result) {
  const State state = collars.state(cavity);
  const int collar = collars.level_of(cavity);
  const auto number = balls.store().find(state.code);
  if (!number) return;
  const FrontStore::Family& family = balls.store().family(*number);
  if (collar + family.level_floor + 1 >= options.wanted.below) return;
  const auto boundary = canon::decode(state.code).value();
  canon::CanonicalFlags flags;
  canon::canonical_flags(boundary, flags);
  for (std::size_t i = 0; i < static_cast<std::size_t>(flags.count); ++i) {
    const canon::Labelling turn = canon::labelling_from(boundary, flags.flags[i]);
    // The scars of the cavity as the ball sees them.
    const Scars seen = state.scars.renamed(inverse_of(turn, boundary.vertices()));
    for (std::uint32_t place = 0; place < family.fronts.size(); ++place) {
      const StoredFront& ball = family.fronts[place];
      const int hexahedra = collar + ball.level + 1;
      if (hexahedra >= options.wanted.below) continue;
      const int faults = ball.scars.size_in_common(seen);
      if (faults > 0 && options.wanted.includes(hexahedra, faults))
        result.add(faults, hexahedra, {cavity, {*number, place}, flags.flags[i]});
    }
  }
}

complex::HexComplex mesh_of(const Beam& balls, const Beam& collars, const Pairing& pairing,
                            int quads) {
  const auto cavity = canon::decode(collars.state(pairing.cavity).code).value();
  return filled(layers_along(collars, pairing.cavity, Growth::inward),
                layers_along(balls, pairing.ball, Growth::outward),
                canon::labelling_from(cavity, pairing.turn), pairing.turn.mirrored, quads);
}

}  // namespace

std::vector<FaultyMesh> faulty_meetings(const Beam& balls, const canon::Code& target,
                                        const FaultyMeetingOptions& options) {
  const auto boundary = canon::decode(target);
  core::expects(boundary && boundary->is_three_connected(),
                "only a 3-connected boundary has a filling");
  Beam collars(State{target, {}}, options.collars);
  FaultyKinds<Pairing> kinds;
  for (std::size_t size = 1; size > 0; size = collars.expand_level()) {
    for (const FrontId cavity : collars.frontier())
      add_pairings(balls, collars, cavity, options, kinds);
    if (collars.level() == options.max_collar) break;
  }
  core::Random random(options.collars.seed);
  std::vector<FaultyMesh> result;
  while (result.size() < options.wanted.count) {
    const auto drawn = kinds.draw(random);
    if (!drawn) break;
    auto mesh = mesh_of(balls, collars, drawn->first, target.quads);
    if (SubBall::neighbours_if_complex(mesh, target.quads))
      result.push_back({std::move(mesh), drawn->second});
  }
  return result;
}

}  // namespace hexatlas::flips
