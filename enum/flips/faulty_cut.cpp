#include "enum/flips/faulty_cut.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "enum/core/checks.hpp"
#include "enum/core/random.hpp"
#include "enum/flips/cut_list.hpp"
#include "enum/flips/matching.hpp"
#include "enum/flips/meeting.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {
namespace {

using core::Random;

constexpr std::size_t kWaysEach = 60;  ///< to fill one side of a cut
/// Unions made for each mesh asked for: most have too many faults.
constexpr std::size_t kTriesEach = 20;

/// Leaves so many of them, drawn at random.
template <typename T>
void keep_some(std::vector<T>& all, std::size_t count, Random& random) {
  const std::size_t kept = std::min(count, all.size());
  for (std::size_t i = 0; i < kept; ++i) std::swap(all[i], all[i + random.below(all.size() - i)]);
  all.resize(kept);
}

class FaultyCuts {
 public:
  FaultyCuts(const Beam& balls, const canon::Code& target, const FaultyCutOptions& options)
      : source_(balls),
        max_quads_(balls.options().max_quads),
        target_(target),
        options_(options),
        collars_(State{target, {}}, options.collars),
        random_(options.collars.seed) {}

  std::vector<FaultyMesh> run() {
    for (const FrontId cavity : some_cavities()) add_unions(cavity);
    std::vector<FaultyMesh> result;
    while (result.size() < options_.wanted.count) {
      auto drawn = meshes_.draw(random_);
      if (!drawn) break;
      result.push_back({std::move(drawn->first), drawn->second});
    }
    return result;
  }

 private:
  /// Drawn without regard to how many there are of each thickness.
  std::vector<FrontId> some_cavities() {
    std::vector<std::vector<FrontId>> levels;
    for (std::size_t size = 1; size > 0; size = collars_.expand_level()) {
      const auto level = collars_.frontier();
      levels.emplace_back(level.begin(), level.end());
      if (collars_.level() == options_.max_collar) break;
    }
    std::vector<FrontId> result;
    while (!levels.empty() && result.size() < options_.cavities) {
      const auto at = levels.begin() + static_cast<std::ptrdiff_t>(random_.below(levels.size()));
      std::swap(at->back(), (*at)[random_.below(at->size())]);
      result.push_back(at->back());
      at->pop_back();
      if (at->empty()) levels.erase(at);
    }
    return result;
  }

  /// A cut of a cavity, and how its sides are filled.
  struct Union {
    std::size_t cut = 0;
    std::array<TurnedBall, 2> ways;
  };

  void add_unions(FrontId cavity) {
    const canon::Code code = collars_.state(cavity).code;
    if (code.quads > kMaxSearchQuads) return;
    // What is left to the two balls.
    FaultyWanted wanted = options_.wanted;
    wanted.below -= collars_.level_of(cavity);
    CutOptions limits;
    limits.max_circle = options_.max_circle;
    limits.max_interior = options_.max_interior;
    limits.max_quads = max_quads_;
    limits.below = wanted.below - wanted.price;  // a fault at least
    CutList list(source_, code, limits);
    FaultyKinds<Union> unions;
    for (std::size_t i = 0; i < list.cuts().size(); ++i) add_unions_along(list, i, wanted, unions);
    const Layers collar = layers_along(collars_, cavity, Growth::inward);
    for (std::size_t i = 0; i < kTriesEach * wanted.count / options_.cavities + 1; ++i) {
      const auto drawn = unions.draw(random_);
      if (!drawn) break;
      const auto& [cut, ways] = drawn->first;
      add_mesh(collar, list.assembled(list.sides_of(list.cuts()[cut]), ways), code.quads);
    }
  }

  void add_unions_along(CutList& list, std::size_t index, const FaultyWanted& wanted,
                        FaultyKinds<Union>& unions) {
    const int below = wanted.below - wanted.price;
    const Cut& cut = list.cuts()[index];
    const CutSides sides = list.sides_of(cut);
    const CutList::Pairs pairs = CutList::pairs_of(cut);
    auto first = list.turned(sides[0], pairs, below - sides[1].least);
    auto second = list.turned(sides[1], pairs, below - sides[0].least);
    keep_some(first, kWaysEach, random_);
    keep_some(second, kWaysEach, random_);
    for (const TurnedBall& one : first)
      for (const TurnedBall& other : second) {
        const int hexahedra = one.hexahedra + other.hexahedra;
        const int faults = static_cast<int>((one.pairs & other.pairs).count());
        if (wanted.includes(hexahedra, std::max(faults, 1)))
          unions.add(faults, hexahedra, {index, {one, other}});
      }
  }

  /// Puts what fills the cavity into the collar.
  void add_mesh(const Layers& collar, const complex::HexComplex& inside, int quads) {
    Layers filling{inside.hexahedra, inside.vertices, {}, false};
    filling.rim.resize(static_cast<std::size_t>(quads) + 2);
    std::iota(filling.rim.begin(), filling.rim.end(), 0U);
    canon::Labelling in_place{};
    std::iota(in_place.begin(), in_place.end(), complex::Vertex{0});
    auto mesh = filled(collar, filling, in_place, false, target_.quads);
    const auto neighbours = SubBall::neighbours_if_complex(mesh, target_.quads);
    if (!neighbours) return;
    const int faults = faults_of(mesh, *neighbours);
    const int hexahedra = static_cast<int>(mesh.hexahedra.size());
    if (faults > 0 && options_.wanted.includes(hexahedra, faults))
      meshes_.add(faults, hexahedra, std::move(mesh));
  }

  BeamBalls source_;
  int max_quads_;  // of the two balls' boundaries
  const canon::Code& target_;
  const FaultyCutOptions& options_;
  Beam collars_;
  Random random_;
  FaultyKinds<complex::HexComplex> meshes_;
};

}  // namespace

std::vector<FaultyMesh> faulty_cuts(const Beam& balls, const canon::Code& target,
                                    const FaultyCutOptions& options) {
  core::expects(target.quads <= kMaxSearchQuads && options.cavities > 0,
                "a boundary with few quads, and a cavity to cut");
  return FaultyCuts(balls, target, options).run();
}

}  // namespace hexatlas::flips
