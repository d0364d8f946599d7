#include "enum/flips/draw.hpp"

#include <algorithm>
#include <cmath>

namespace hexatlas::flips {
namespace {

constexpr std::size_t kSmallestBall = 2;  ///< hexahedra
constexpr std::size_t kLargestBall = 22;  ///< hardly a larger one is exchanged
constexpr std::size_t kSameState = 16;    ///< of so many exchanges for the same state one is made

}  // namespace

std::size_t size_of_exchange(core::Random& random) {
  return kSmallestBall + random.below(kLargestBall - kSmallestBall + 1);
}

std::optional<std::size_t> drawn_by_weight(const std::vector<double>& sums, double to_stay,
                                           core::Random& random) {
  const double total = sums.empty() ? to_stay : sums.back();
  if (total == 0) return std::nullopt;
  const double at = std::min(random.uniform() * total, std::nextafter(total, 0.0));
  if (at < to_stay) return std::nullopt;
  return static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin());
}

std::optional<Draw> draw(const SubBall& ball, const Beam& balls, const Climate& climate,
                         std::optional<Walk::Leap> leap, core::Random& random,
                         std::vector<double>& sums) {
  const Front& front = ball.front();
  canon::CanonicalFlags flags;
  canon::canonical_flags(front.boundary, flags);
  const auto number = balls.store().find(flags.code);
  const int size = static_cast<int>(ball.cells().size());
  if (!number || balls.store().family(*number).level_floor + 1 > size + kMostClimb)
    return std::nullopt;
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
    if (other.level + 1 > size + kMostClimb) return false;
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
  const auto drawn = drawn_by_weight(sums, to_stay, random);
  if (!drawn) return std::nullopt;
  const Position& position = positions[*drawn / known.size()];
  const std::size_t place = *drawn % known.size();
  const StoredFront& ball_drawn = known[place];
  if (is_same(ball_drawn, position) && random.below(kSameState) != 0) return std::nullopt;
  return Draw{{{*number, static_cast<std::uint32_t>(place)}, position.label, position.is_mirrored},
              ball_drawn.scars.size_in_common(position.scars) - own};
}

}  // namespace hexatlas::flips
