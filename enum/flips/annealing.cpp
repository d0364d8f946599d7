#include "enum/flips/annealing.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "enum/cells/cube.hpp"
#include "enum/flips/exchange.hpp"
#include "enum/parallel/parallel_for.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;
using core::Random;

/// exp(-1/T) and exp(-p/T) for temperatures T from 0.8 to 1.9 and prices p from 7 to 3: where
/// meshes of boundaries with 20 quads freeze, and where they melt (decision 0019). As numbers, so
/// that no two libraries' exponentials differ.
constexpr std::array<Climate, 8> kClimates{{{0.2865, 0.000158},
                                            {0.3313, 0.00082},
                                            {0.3767, 0.00327},
                                            {0.4220, 0.0104},
                                            {0.4666, 0.0276},
                                            {0.5098, 0.0614},
                                            {0.5513, 0.1193},
                                            {0.5908, 0.2062}}};
constexpr int kStepsPerRound = 500;
constexpr std::size_t kLargestBall = 22;  ///< hexahedra; hardly a larger one is exchanged
constexpr int kClimb = 10;                ///< hexahedra that one exchange may add

double uniform(Random& random) { return static_cast<double>(random.number() >> 11U) * 0x1p-53; }

double power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? 1 / result : result;
}

/// Powers of one base with exponents from -kLimit to kLimit; beyond that those of the limits.
class Powers {
 public:
  explicit Powers(double base) {
    for (int i = -kLimit; i <= kLimit; ++i)
      values_[static_cast<std::size_t>(i + kLimit)] = power(base, i);
  }
  [[nodiscard]] double operator()(int exponent) const noexcept {
    return values_[static_cast<std::size_t>(std::clamp(exponent, -kLimit, kLimit) + kLimit)];
  }

 private:
  static constexpr int kLimit = 32;
  std::array<double, 2 * kLimit + 1> values_{};
};

/// The vertices of a facet, ascending, 16 bits each.
std::uint64_t key_of(const complex::Hexahedron& cell, std::size_t facet) {
  std::array<std::uint64_t, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = cell[cells::kFacetVertices[facet][i]];
  std::sort(v.begin(), v.end());
  return v[0] << 48U | v[1] << 32U | v[2] << 16U | v[3];
}

/// As SubBall::neighbours_of(), nullopt if not each facet is in one or two hexahedra, in one as
/// often as the boundary has quads. Most of a step's time would go into sorting.
std::optional<SubBall::Neighbours> neighbours_if_complex(const HexComplex& mesh, int quads) {
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t cell = 0, facet = 0;
    int hexahedra = 0;
  };
  std::size_t size = 64;
  while (size < 2 * cells::kCubeFacets * mesh.hexahedra.size()) size *= 2;
  std::vector<Slot> slots(size);
  SubBall::Neighbours result(mesh.hexahedra.size());
  int in_one = 0;
  for (std::uint32_t c = 0; c < mesh.hexahedra.size(); ++c)
    for (std::uint32_t f = 0; f < cells::kCubeFacets; ++f) {
      result[c][f] = SubBall::kOutside;
      const std::uint64_t key = key_of(mesh.hexahedra[c], f);
      std::size_t at = core::mixed(key) & (size - 1);
      while (slots[at].hexahedra > 0 && slots[at].key != key) at = (at + 1) & (size - 1);
      Slot& slot = slots[at];
      if (++slot.hexahedra == 1) {
        slot = {key, c, f, 1};
        ++in_one;
        continue;
      }
      if (slot.hexahedra > 2) return std::nullopt;
      --in_one;
      result[c][f] = slot.cell;
      result[slot.cell][slot.facet] = c;
    }
  if (in_one != quads) return std::nullopt;
  return result;
}

/// An exchange, and what it does to the number of faults.
struct Draw {
  Fit fit;
  int faults = 0;
};

/// One of the balls that fit in place of the sub-ball, in all positions, drawn by their weights;
/// nullopt for the sub-ball itself, which has weight 1.
std::optional<Draw> draw(const SubBall& ball, const Beam& balls, const Climate& climate,
                         Random& random) {
  const Front& front = ball.front();
  canon::CanonicalFlags flags;
  canon::canonical_flags(front.boundary, flags);
  const auto number = balls.store().find(flags.code);
  const int size = static_cast<int>(ball.cells().size());
  if (!number || balls.store().family(*number).level_floor + 1 > size + kClimb) return std::nullopt;
  const auto positions = positions_of(front.boundary, flags, ball.related_outside());
  const int own = scars_of(front.related, relation_of_quads(front.boundary),
                           front.boundary.vertices(), positions[0].label)
                      .size_in_common(positions[0].scars);
  const auto& known = balls.store().family(*number).fronts;
  const Powers per_hexahedron(climate.per_hexahedron), per_fault(climate.per_fault);
  std::optional<Draw> drawn;
  double total = 1;
  for (const Position& position : positions)
    for (std::uint32_t place = 0; place < known.size(); ++place) {
      const int more = known[place].level + 1 - size;
      if (more > kClimb) continue;
      const int faults = known[place].scars.size_in_common(position.scars) - own;
      const double weight = per_hexahedron(more) * per_fault(faults);
      total += weight;
      if (uniform(random) * total >= weight) continue;
      drawn = Draw{{{*number, place}, position.label, position.is_mirrored}, faults};
    }
  return drawn;
}

}  // namespace

Walk::Walk(HexComplex mesh, int quads, const Beam& balls, std::uint64_t seed)
    : mesh_(std::move(mesh)),
      quads_(quads),
      balls_(&balls),
      random_(seed),
      neighbours_(SubBall::neighbours_of(mesh_)) {}

bool Walk::step(const Climate& climate) {
  constexpr std::size_t kSmallestBall = 2;
  SubBall ball(mesh_, neighbours_,
               static_cast<std::uint32_t>(random_.below(mesh_.hexahedra.size())));
  const std::size_t size = kSmallestBall + random_.below(kLargestBall - kSmallestBall + 1);
  const int weight = static_cast<int>(random_.below(5));
  while (ball.cells().size() < size)
    if (!ball.grow_somewhere(random_, weight)) return false;
  const auto drawn = draw(ball, *balls_, climate, random_);
  if (!drawn) return false;
  HexComplex made = complex::compacted(exchanged(mesh_, ball, *balls_, drawn->fit), quads_ + 2);
  auto neighbours = neighbours_if_complex(made, quads_);
  if (!neighbours) return false;
  mesh_ = std::move(made);
  neighbours_ = *std::move(neighbours);
  faults_ += drawn->faults;
  return true;
}

namespace {

/// A walk and the least mesh under the strict rule that it saw.
struct Walker {
  Walk walk;
  std::optional<HexComplex> best;
  std::size_t least = 0;

  void go_on(const Climate& climate) {
    for (int i = 0; i < kStepsPerRound; ++i) {
      if (!walk.step(climate) || walk.faults() > 0) continue;
      if (walk.mesh().hexahedra.size() >= least) continue;
      least = walk.mesh().hexahedra.size();
      best = walk.mesh();
    }
  }
};

/// Whether two walks trade places, so that each mesh has its probability in each climate.
bool trade(const Walk& cold, const Climate& of_cold, const Walk& hot, const Climate& of_hot,
           Random& random) {
  const auto size = [](const Walk& walk) { return static_cast<int>(walk.mesh().hexahedra.size()); };
  const double ratio =
      power(of_cold.per_hexahedron / of_hot.per_hexahedron, size(hot) - size(cold)) *
      power(of_cold.per_fault / of_hot.per_fault, hot.faults() - cold.faults());
  return uniform(random) < ratio;
}

}  // namespace

std::optional<HexComplex> smaller_by_annealing(const HexComplex& mesh, int quads, const Beam& balls,
                                               const AnnealingOptions& options) {
  Random random(options.seed);
  std::vector<Walker> walkers;
  for (std::size_t i = 0; i < kClimates.size(); ++i)
    walkers.push_back({{mesh, quads, balls, random.number()}, {}, mesh.hexahedra.size()});
  std::array<std::size_t, kClimates.size()> at{};  // the walker in each climate
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = i;
  for (int round = 0; round < options.rounds; ++round) {
    parallel::parallel_for(options.threads, at.size(),
                           [&](std::size_t i) { walkers[at[i]].go_on(kClimates[i]); });
    for (std::size_t i = at.size() - 1; i-- > 0;)
      if (trade(walkers[at[i]].walk, kClimates[i], walkers[at[i + 1]].walk, kClimates[i + 1],
                random))
        std::swap(at[i], at[i + 1]);
  }
  const auto least =
      std::min_element(walkers.begin(), walkers.end(),
                       [](const Walker& a, const Walker& b) { return a.least < b.least; });
  return std::move(least->best);
}

}  // namespace hexatlas::flips
