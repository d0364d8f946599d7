#include "enum/flips/meeting.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/symmetric_balls.hpp"
#include "enum/flips/symmetric_beam.hpp"

namespace hexatlas::flips {
namespace {

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

  /// Of each node of the collars' level, after a match(); none at a price of 0.
  [[nodiscard]] std::vector<Promise> promises(const Matcher& matcher, int price,
                                              const SymmetricBeam& collars) const {
    if (price == 0) return {};
    std::vector<Promise> result(collars.nodes().size(), kNoPromise);
    const std::vector<Promise> own = matcher.promises(cavities, price);
    for (std::size_t i = 0; i < own.size(); ++i) result[node[i]] = own[i];
    return result;
  }
};
SymmetricCavities cavities_of(const SymmetricBeam& collars) {
  SymmetricCavities result;
  for (std::size_t i = 0; i < collars.nodes().size(); ++i) {
    const auto state = state_without_symmetry(collars.nodes()[i].state);
    if (!state) continue;
    result.cavities.push_back({*state, collars.level()});
    result.node.push_back(i);
  }
  return result;
}

std::optional<Filling> symmetric_meeting(const BallSource& balls, const SymmetricFront& start,
                                         const MeetingOptions& options, Matcher& matcher,
                                         const SymmetricBalls* symmetric_balls) {
  SymmetricBeam collars({start_of_collars(start)}, Growth::inward, options.collars);
  std::optional<Filling> best;
  for (bool has_more = true; has_more;) {
    if (collars.level() + 1 >= matcher.below() || (options.first && best)) break;
    const SymmetricCavities here = cavities_of(collars);
    if (const auto meeting = matcher.match(here.cavities))
      best = assembled(balls, collars.layers_to(collars.nodes()[here.node[meeting->cavity]]),
                       *meeting, start.front.boundary.quads());
    if (symmetric_balls != nullptr)
      if (const auto fit = symmetric_balls->least_fit(collars.nodes(), matcher.below(),
                                                      options.collars.threads)) {
        best = Filling{filled(collars.layers_to(collars.nodes()[fit->cavity]),
                              symmetric_balls->layers_of(*fit), fit->turn, fit->is_mirrored,
                              start.front.boundary.quads())};
        matcher.look_below(fit->hexahedra);
      }
    if (collars.level() == options.max_collar) break;
    has_more = collars.expand_level(here.promises(matcher, options.guided, collars));
  }
  return best;
}

/// Those balls of a beam that have an even number of hexahedra, or an odd one.
class BallsOfParity final : public BallSource {
 public:
  BallsOfParity(const Beam& beam, int parity) : beam_(beam), parity_(parity) {}

  [[nodiscard]] std::optional<int> least_with(const canon::Code& boundary) const override {
    const auto number = beam_.store().find(boundary);
    if (!number) return std::nullopt;
    std::optional<int> least;
    for (const StoredFront& front : beam_.store().family(*number).fronts)
      if (is_one(front.level) && (!least || front.level + 1 < *least)) least = front.level + 1;
    return least;
  }
  [[nodiscard]] std::vector<KnownBall> balls_with(const canon::Code& boundary) const override {
    std::vector<KnownBall> result;
    for (const FrontRecord& front : own_fronts(boundary))
      result.push_back({front.level + 1, front.scars});
    return result;
  }
  [[nodiscard]] Layers layers_of(const canon::Code& boundary, std::size_t ball) const override {
    return layers_along(beam_, own_fronts(boundary)[ball].id, Growth::outward);
  }

 private:
  [[nodiscard]] bool is_one(int level) const noexcept { return (level + 1) % 2 == parity_; }
  [[nodiscard]] std::vector<FrontRecord> own_fronts(const canon::Code& boundary) const {
    std::vector<FrontRecord> fronts = beam_.fronts_of(boundary);
    std::erase_if(fronts, [this](const FrontRecord& front) { return !is_one(front.level); });
    return fronts;
  }

  const Beam& beam_;
  int parity_;
};

/// Of the meetings with collars of one thickness the least one with an even and the least one with
/// an odd number of hexahedra. `collar_of(i)`: the hexahedra taken off before cavity i is left.
template <class CollarOf>
void add_meetings(std::vector<Filling>& fillings, const Beam& balls, const MeetingOptions& options,
                  int quads, const std::vector<Cavity>& cavities, const CollarOf& collar_of) {
  for (int parity = 0; parity < 2; ++parity) {
    const int thickness = cavities.empty() ? 0 : cavities.front().collar;
    const BallsOfParity source(balls, (parity + thickness) % 2);
    Matcher matcher(source, options.below, options.collars.threads);
    if (const auto meeting = matcher.match(cavities))
      fillings.push_back(assembled(source, collar_of(meeting->cavity), *meeting, quads));
  }
}

void add_symmetric_meetings(std::vector<Filling>& fillings, const Beam& balls,
                            const MeetingOptions& options, const SymmetricFront& start) {
  SymmetricBeam collars({start_of_collars(start)}, Growth::inward, options.collars);
  for (bool has_more = true; has_more; has_more = collars.expand_level()) {
    const SymmetricCavities here = cavities_of(collars);
    add_meetings(
        fillings, balls, options, start.front.boundary.quads(), here.cavities,
        [&](std::size_t cavity) { return collars.layers_to(collars.nodes()[here.node[cavity]]); });
    if (collars.level() == options.max_collar) break;
  }
}

}  // namespace

Filling filling_of(const Beam& balls, FrontId id) {
  Layers layers = layers_along(balls, id, Growth::outward);
  std::reverse(layers.hexahedra.begin(), layers.hexahedra.end());
  complex::HexComplex mesh{layers.vertices, std::move(layers.hexahedra)};
  if (layers.is_mirrored) mesh = complex::mirrored(std::move(mesh));
  return {complex::renumbered(std::move(mesh), layers.rim)};
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
  for (const complex::Hexahedron& cell : mesh.hexahedra)
    for (const std::uint32_t a : cell)
      for (const std::uint32_t b : cell)
        if (a < on_boundary && b < on_boundary) related[a] |= bit(static_cast<complex::Vertex>(b));
  canon::Labelling same{};
  std::iota(same.begin(), same.end(), complex::Vertex{0});
  return scars_of(related, relation_of_quads(boundary), boundary.vertices(), same);
}

std::optional<Filling> best_meeting(const BallSource& balls, const canon::Code& target,
                                    const MeetingOptions& options) {
  const complex::Quadrangulation boundary = boundary_of(target);
  Matcher matcher(balls, options.below, options.collars.threads);
  if (are_wide(options.collars))
    return symmetric_meeting(balls, front_without_symmetry(boundary, options.apart), options,
                             matcher, nullptr);
  Beam collars(State{target, options.apart}, options.collars);
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
                                              const MeetingOptions& options,
                                              const SymmetricBalls* symmetric_balls) {
  Matcher matcher(balls, options.below, options.collars.threads);
  std::optional<Filling> best;
  for (const SymmetricFront& start : symmetric_fronts(boundary_of(target), options.apart))
    if (auto filling = symmetric_meeting(balls, start, options, matcher, symmetric_balls))
      best = std::move(filling);
  return best;
}

std::vector<Filling> varied_meetings(const Beam& balls, const canon::Code& target,
                                     const MeetingOptions& options) {
  const complex::Quadrangulation boundary = boundary_of(target);
  std::vector<Filling> result;
  if (are_wide(options.collars)) {
    add_symmetric_meetings(result, balls, options, front_without_symmetry(boundary, options.apart));
    return result;
  }
  Beam collars(State{target, options.apart}, options.collars);
  std::size_t size = 1;
  for (int depth = 0; depth <= options.max_collar && size > 0; ++depth) {
    if (depth > 0) size = collars.expand_level();
    add_meetings(result, balls, options, target.quads, cavities_of(collars),
                 [&](std::size_t cavity) {
                   return layers_along(collars, collars.frontier()[cavity], Growth::inward);
                 });
  }
  return result;
}

std::vector<Filling> varied_symmetric_meetings(const Beam& balls, const canon::Code& target,
                                               const MeetingOptions& options) {
  std::vector<Filling> result;
  for (const SymmetricFront& start : symmetric_fronts(boundary_of(target), options.apart))
    add_symmetric_meetings(result, balls, options, start);
  return result;
}

}  // namespace hexatlas::flips
