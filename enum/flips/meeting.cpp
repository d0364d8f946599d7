#include "enum/flips/meeting.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/symmetric_beam.hpp"

namespace hexatlas::flips {
namespace {

using complex::Hexahedron;

/// The cavities that the frontier of a beam leaves.
std::vector<Cavity> cavities_of(const Beam& collars) {
  std::vector<Cavity> result;
  for (const FrontId id : collars.frontier())
    result.push_back({collars.state(id), collars.level_of(id)});
  return result;
}

/// Those of them that may be the boundary of a known ball.
struct SymmetricCavities {
  std::vector<Cavity> cavities;
  std::vector<std::size_t> node;  ///< of each
};
SymmetricCavities cavities_of(const SymmetricBeam& collars) {
  SymmetricCavities result;
  for (std::size_t i = 0; i < collars.nodes().size(); ++i) {
    const SymmetricState& state = collars.nodes()[i].state;
    if (state.code.quads > kMaxStateQuads) continue;
    result.cavities.push_back({{state.code, state.scars.as<kMaxStateQuads>()}, collars.level()});
    result.node.push_back(i);
  }
  return result;
}

std::optional<Filling> symmetric_meeting(const BallSource& balls, const SymmetricFront& start,
                                         const MeetingOptions& options, Matcher& matcher) {
  SymmetricBeam collars(start, options.collars);
  std::optional<Filling> best;
  for (bool has_more = true; has_more; has_more = collars.expand_level()) {
    if (collars.level() + 1 >= matcher.below() || (options.first && best)) break;
    const SymmetricCavities here = cavities_of(collars);
    if (const auto meeting = matcher.match(here.cavities))
      best = assembled(balls, collars.layers_to(collars.nodes()[here.node[meeting->cavity]]),
                       *meeting, start.front.boundary.quads());
    if (collars.level() == options.max_collar) break;
  }
  return best;
}

}  // namespace

Filling filling_of(const Beam& balls, FrontId id) {
  Layers layers = layers_along(balls, id, Growth::outward);
  if (layers.is_mirrored)
    for (Hexahedron& cell : layers.hexahedra) cells::exchange_axes(cell);
  std::reverse(layers.hexahedra.begin(), layers.hexahedra.end());
  return {complex::renumbered({layers.vertices, std::move(layers.hexahedra)}, layers.rim)};
}

std::optional<int> BeamBalls::least_with(const canon::Code& boundary) const {
  const auto level = beam_.first_level(boundary);
  if (!level) return std::nullopt;
  return *level + 1;
}

std::vector<KnownBall> BeamBalls::balls_with(const canon::Code& boundary) const {
  std::vector<KnownBall> result;
  for (const FrontRecord& front : beam_.fronts_of(boundary))
    result.push_back({front.level + 1, front.scars});
  return result;
}

Layers BeamBalls::layers_of(const canon::Code& boundary, std::size_t ball) const {
  return layers_along(beam_, beam_.fronts_of(boundary)[ball].id, Growth::outward);
}

Scars scars_of(const complex::HexComplex& mesh, const complex::Quadrangulation& boundary) {
  const auto on_boundary = static_cast<std::uint32_t>(boundary.vertices());
  Relation related{};
  for (const Hexahedron& cell : mesh.hexahedra)
    for (const std::uint32_t a : cell)
      for (const std::uint32_t b : cell)
        if (a < on_boundary && b < on_boundary) related[a] |= bit(static_cast<complex::Vertex>(b));
  canon::Labelling same{};
  std::iota(same.begin(), same.end(), complex::Vertex{0});
  return scars_of(related, relation_of_quads(boundary), boundary.vertices(), same);
}

std::optional<Filling> best_meeting(const BallSource& balls, const canon::Code& target,
                                    const MeetingOptions& options) {
  const auto boundary = canon::decode(target);
  core::expects(boundary && boundary->is_three_connected(),
                "only a 3-connected boundary has a filling");
  Beam collars(State{target, options.apart}, options.collars);
  Matcher matcher(balls, options.below, options.collars.threads);
  std::optional<Filling> best;
  std::size_t size = 1;
  for (int depth = 0; depth <= options.max_collar && size > 0; ++depth) {
    if (depth > 0) size = collars.expand_level();
    if (depth + 1 >= matcher.below() || (options.first && best)) break;
    if (const auto meeting = matcher.match(cavities_of(collars)))
      best = assembled(balls,
                       layers_along(collars, collars.frontier()[meeting->cavity], Growth::inward),
                       *meeting, target.quads);
  }
  return best;
}

std::optional<Filling> best_symmetric_meeting(const BallSource& balls, const canon::Code& target,
                                              const MeetingOptions& options) {
  const auto boundary = canon::decode(target);
  core::expects(boundary && boundary->is_three_connected(),
                "only a 3-connected boundary has a filling");
  const auto apart = options.apart.as<kMaxSymmetricQuads>();
  Matcher matcher(balls, options.below, options.collars.threads);
  std::optional<Filling> best;
  for (const Involution& involution : involutions_of(*boundary)) {
    if (apart.renamed(involution.image) != apart) continue;
    const SymmetricFront start{front_with(*boundary, apart), involution.image};
    if (auto filling = symmetric_meeting(balls, start, options, matcher)) best = std::move(filling);
  }
  return best;
}

}  // namespace hexatlas::flips
