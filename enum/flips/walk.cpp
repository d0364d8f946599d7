#include "enum/flips/walk.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "enum/flips/exchange.hpp"

namespace hexatlas::flips {
namespace {

using complex::HexComplex;
using core::Random;

constexpr std::size_t kSmallestBall = 2;  ///< hexahedra
constexpr std::size_t kLargestBall = 22;  ///< hardly a larger one is exchanged
constexpr int kClimb = 10;                ///< hexahedra that one exchange may add
constexpr std::size_t kSameState = 16;    ///< of so many such exchanges one is made
constexpr std::size_t kLayersKept = 10'000;

/// An exchange, and what it does to the number of faults.
struct Draw {
  Fit fit;
  int faults = 0;
};

/// One of the balls that fit in place of the sub-ball, in all positions, drawn by their weights;
/// nullopt for the sub-ball itself, which has weight 1. Mostly nullopt, too, for a ball with as
/// many hexahedra and the same scars: nearly always it is the sub-ball again, and most draws are
/// such. In a leap, only balls of its kind are drawn. `sums` is made use of.
std::optional<Draw> draw(const SubBall& ball, const Beam& balls, const Climate& climate,
                         std::optional<Walk::Leap> leap, Random& random,
                         std::vector<double>& sums) {
  const Front& front = ball.front();
  canon::CanonicalFlags flags;
  canon::canonical_flags(front.boundary, flags);
  const auto number = balls.store().find(flags.code);
  const int size = static_cast<int>(ball.cells().size());
  if (!number || balls.store().family(*number).level_floor + 1 > size + kClimb) return std::nullopt;
  const auto positions = positions_of(front.boundary, flags, ball.related_outside());
  const Relation quads = relation_of_quads(front.boundary);
  const auto own_scars = [&](const Position& position) {
    return scars_of(front.related, quads, front.boundary.vertices(), position.label);
  };
  const int own = own_scars(positions[0]).size_in_common(positions[0].scars);
  const auto& known = balls.store().family(*number).fronts;
  const auto is_same = [&](const StoredFront& other, const Position& position) {
    return other.level + 1 == size && other.scars == own_scars(position);
  };
  const auto is_allowed = [&](const StoredFront& other, const Position& position) {
    if (other.level + 1 > size + kClimb) return false;
    if (!leap) return true;
    return *leap == Walk::Leap::any_other ? !is_same(other, position)
                                          : (other.level + 1 - size) % 2 != 0;
  };
  const double to_stay = leap ? 0 : 1;
  double total = to_stay;
  sums.clear();
  for (const Position& position : positions)
    for (const StoredFront& other : known) {
      if (is_allowed(other, position))
        total += climate.factor(other.level + 1 - size,
                                other.scars.size_in_common(position.scars) - own);
      sums.push_back(total);
    }
  if (total == 0) return std::nullopt;
  const double at = std::min(random.uniform() * total, std::nextafter(total, 0.0));
  if (at < to_stay) return std::nullopt;
  const auto drawn =
      static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin());
  const Position& position = positions[drawn / known.size()];
  const std::size_t place = drawn % known.size();
  const StoredFront& ball_drawn = known[place];
  if (is_same(ball_drawn, position) && random.below(kSameState) != 0) return std::nullopt;
  return Draw{{{*number, static_cast<std::uint32_t>(place)}, position.label, position.is_mirrored},
              ball_drawn.scars.size_in_common(position.scars) - own};
}

}  // namespace

const Layers& BallLayers::of(FrontId ball) {
  if (known_.size() >= kLayersKept) known_.clear();
  const auto [at, is_new] = known_.try_emplace(ball);
  if (is_new) at->second = layers_along(balls_, ball, Growth::outward);
  return at->second;
}

Walk::Walk(HexComplex mesh, int quads, const Beam& balls, std::uint64_t seed, int faults)
    : mesh_(std::move(mesh)),
      quads_(quads),
      balls_(balls),
      random_(seed),
      neighbours_(SubBall::neighbours_of(mesh_)),
      ball_(mesh_, neighbours_, 0, widest_on_the_way(balls)),
      faults_(faults) {}

/// Grows a ball somewhere. Returns whether it came to that size.
bool Walk::grow_to(std::size_t size, int weight) {
  while (ball_.cells().size() < size)
    if (!ball_.grow_somewhere(random_, weight)) return false;
  return true;
}

bool Walk::exchange(const Climate& climate, BallLayers& layers, std::optional<Leap> leap) {
  if (ball_.quads() > balls_.options().max_quads) return false;
  const auto drawn = draw(ball_, balls_, climate, leap, random_, sums_);
  if (!drawn) return false;
  HexComplex made = complex::compacted(
      exchanged(mesh_, ball_, layers.of(drawn->fit.ball), drawn->fit), quads_ + 2);
  auto neighbours = SubBall::neighbours_if_complex(made, quads_);
  if (!neighbours) return false;
  mesh_ = std::move(made);
  neighbours_ = *std::move(neighbours);
  faults_ += drawn->faults;
  return true;
}

bool Walk::step(const Climate& climate, BallLayers& layers) {
  ball_.restart(static_cast<std::uint32_t>(random_.below(mesh_.hexahedra.size())));
  const std::size_t size = kSmallestBall + random_.below(kLargestBall - kSmallestBall + 1);
  const int weight = static_cast<int>(random_.below(5));
  return grow_to(size, weight) && exchange(climate, layers, std::nullopt);
}

bool Walk::leap(const Climate& climate, BallLayers& layers, int tries, Leap kind) {
  const std::size_t all = mesh_.hexahedra.size();
  const std::size_t least = (all + 1) / 2;  // smaller balls have hardly any of the other parity
  for (int i = 0; i < tries && least < all; ++i) {
    ball_.restart(static_cast<std::uint32_t>(random_.below(all)));
    const std::size_t size = least + random_.below(all - least);
    const int weight = 1 + static_cast<int>(random_.below(8));
    (void)grow_to(size, weight);  // whatever size it came to
    if (exchange(climate, layers, kind)) return true;
  }
  return false;
}

}  // namespace hexatlas::flips
