#include "enum/flips/faulty_meeting.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/sub_ball.hpp"
#include "enum/flips/symmetric_beam.hpp"

namespace hexatlas::flips {
namespace {

/// Meshes of what is drawn at random, as many as are wanted. `mesh_of(one)`: its mesh.
template <class One, class MeshOf>
std::vector<FaultyMesh> drawn(FaultyKinds<One>& kinds, const FaultyMeetingOptions& options,
                              int quads, MeshOf&& mesh_of) {
  core::Random random(options.collars.seed);
  std::vector<FaultyMesh> result;
  while (result.size() < options.wanted.count) {
    const auto next = kinds.draw(random);
    if (!next) break;
    complex::HexComplex mesh = mesh_of(next->first);
    if (SubBall::neighbours_if_complex(mesh, quads))
      result.push_back({std::move(mesh), next->second});
  }
  return result;
}

/// Balls in cavities, by kind. A cavity goes by its place in a list of the caller's.
class Pairings {
 public:
  Pairings(const Beam& balls, const FaultyMeetingOptions& options)
      : balls_(balls), options_(options) {}

  struct Added {
    bool any = false;              ///< whether there are any
    Promise promise = kNoPromise;  ///< as of Matcher::promises()
  };
  /// Adds the pairings with one cavity.
  Added add(const State& cavity, int collar, std::size_t place);

  /// Meshes drawn at random. `collar_to(place)`: the hexahedra around the cavity.
  template <class CollarTo>
  [[nodiscard]] std::vector<FaultyMesh> drawn(int quads, CollarTo&& collar_to);

 private:
  /// A ball in a cavity, turned by one of the automorphisms_of() the cavity's boundary. There may
  /// be millions.
  struct Pairing {
    std::size_t cavity = 0;
    FrontId ball;
    std::uint32_t turn = 0;
  };

  const Beam& balls_;
  const FaultyMeetingOptions& options_;
  FaultyKinds<Pairing> kinds_;
};

Pairings::Added Pairings::add(const State& cavity, int collar, std::size_t place) {
  const FaultyWanted& wanted = options_.wanted;
  const auto number = balls_.store().find(cavity.code);
  Added result;
  if (!number) return result;
  const FrontStore::Family& family = balls_.store().family(*number);
  if (collar + family.level_floor + 1 >= wanted.below) return result;
  const std::vector<Automorphism> turns = automorphisms_of(cavity.code);
  for (std::uint32_t t = 0; t < turns.size(); ++t) {
    // The scars of the cavity as the ball sees them.
    const Scars seen =
        cavity.scars.renamed(canon::inverse_of(turns[t].label, cavity.code.quads + 2));
    for (std::uint32_t k = 0; k < family.fronts.size(); ++k) {
      const StoredFront& ball = family.fronts[k];
      const int hexahedra = collar + ball.level + 1;
      if (hexahedra >= wanted.below) continue;
      const int faults = ball.scars.size_in_common(seen);
      result.promise =
          std::min(result.promise, static_cast<Promise>(hexahedra + options_.guided * faults));
      if (faults == 0 || !wanted.includes(hexahedra, faults)) continue;
      kinds_.add(faults, hexahedra, {place, {*number, k}, t});
      result.any = true;
    }
  }
  return result;
}

template <class CollarTo>
std::vector<FaultyMesh> Pairings::drawn(int quads, CollarTo&& collar_to) {
  return flips::drawn(kinds_, options_, quads, [&](const Pairing& one) {
    const Automorphism turn = automorphisms_of(balls_.state(one.ball).code)[one.turn];
    return filled(collar_to(one.cavity), layers_along(balls_, one.ball, Growth::outward),
                  turn.label, turn.is_mirrored, quads);
  });
}

/// Faulty meetings with the collars of these starts.
std::vector<FaultyMesh> faulty_meetings_from(const std::vector<SymmetricFront>& starts,
                                             const Beam& balls, int quads,
                                             const FaultyMeetingOptions& options,
                                             const SymmetricBalls* symmetric_balls) {
  struct CavityAt {
    const SymmetricBeam* collars;
    SymmetricBeam::Node node;
  };
  struct InCavity {
    std::uint32_t cavity;
    SymmetricPairing pairing;
  };
  Pairings pairings(balls, options);
  FaultyKinds<InCavity> symmetric;
  std::deque<SymmetricBeam> searches;  // one for each involution
  std::vector<CavityAt> cavities;
  const auto add_symmetric = [&](const SymmetricBeam::Node& node) {
    bool has_any = false;
    symmetric_balls->for_each_pairing(
        node, options.wanted, [&](const SymmetricPairing& pairing, int hexahedra, int faults) {
          symmetric.add(faults, hexahedra, {static_cast<std::uint32_t>(cavities.size()), pairing});
          has_any = true;
        });
    return has_any;
  };
  for (const SymmetricFront& start : starts) {
    SymmetricBeam& collars = searches.emplace_back(std::vector{start_of_collars(start)},
                                                   Growth::inward, options.collars);
    for (bool has_more = true; has_more;) {
      std::vector<Promise> promises;
      for (const SymmetricBeam::Node& node : collars.nodes()) {
        const auto cavity = state_without_symmetry(node.state);
        Pairings::Added added;
        if (cavity) added = pairings.add(*cavity, collars.level(), cavities.size());
        if (options.guided != 0) promises.push_back(added.promise);
        bool has_any = added.any;
        if (symmetric_balls != nullptr && add_symmetric(node)) has_any = true;
        if (has_any) cavities.push_back({&collars, node});
      }
      if (collars.level() == options.max_collar) break;
      has_more = collars.expand_level(promises);
    }
  }
  auto result = pairings.drawn(quads, [&](std::size_t place) {
    return cavities[place].collars->layers_to(cavities[place].node);
  });
  auto others = drawn(symmetric, options, quads, [&](const InCavity& one) {
    const auto& [collars, node] = cavities[one.cavity];
    const SymmetricFit fit = symmetric_balls->fit_of(node, one.pairing);
    return filled(collars->layers_to(node), symmetric_balls->layers_of(fit), fit.turn,
                  fit.is_mirrored, quads);
  });
  std::move(others.begin(), others.end(), std::back_inserter(result));
  return result;
}

}  // namespace

std::vector<FaultyMesh> faulty_meetings(const Beam& balls, const canon::Code& target,
                                        const FaultyMeetingOptions& options) {
  const complex::Quadrangulation boundary = boundary_of(target);
  if (are_wide(options.collars))
    return faulty_meetings_from({front_without_symmetry(boundary, {})}, balls, target.quads,
                                options, nullptr);
  Beam collars(State{target, {}}, options.collars);
  Pairings pairings(balls, options);
  std::vector<FrontId> cavities;
  for (std::size_t size = 1; size > 0; size = collars.expand_level()) {
    for (const FrontId cavity : collars.frontier())
      if (pairings.add(collars.state(cavity), collars.level(), cavities.size()).any)
        cavities.push_back(cavity);
    if (collars.level() == options.max_collar) break;
  }
  return pairings.drawn(target.quads, [&](std::size_t place) {
    return layers_along(collars, cavities[place], Growth::inward);
  });
}

std::vector<FaultyMesh> faulty_symmetric_meetings(const Beam& balls, const canon::Code& target,
                                                  const FaultyMeetingOptions& options,
                                                  const SymmetricBalls* symmetric_balls) {
  return faulty_meetings_from(symmetric_fronts(boundary_of(target), {}), balls, target.quads,
                              options, symmetric_balls);
}

}  // namespace hexatlas::flips
