#include "meshing/delaunay/curves.hpp"

#include <bit>
#include <cmath>

namespace hexatlas::delaunay {
namespace {

/// A Hilbert curve, turned: entry is the corner of its cube where it comes in; it leaves at the
/// neighbour of this corner along the axis. One state for each pair.
struct Step {
  std::uint8_t digit, state;
};

constexpr unsigned rotated_left(unsigned bits, unsigned by) {
  by %= 3;
  return ((bits << by) | (bits >> (3 - by))) & 7U;
}
constexpr unsigned gray(unsigned i) { return i ^ (i >> 1U); }
constexpr unsigned gray_inverse(unsigned g) { return (g ^ (g >> 1U) ^ (g >> 2U)) & 7U; }

constexpr Step step_from(unsigned state, unsigned octant) {
  const unsigned entry = state & 7U, axis = state >> 3U;
  const unsigned digit = gray_inverse(rotated_left(octant ^ entry, 3 - (axis + 1) % 3));
  const unsigned local_entry = digit == 0 ? 0 : gray(2 * ((digit - 1) / 2));
  const unsigned turned =
      digit == 0 ? 0 : static_cast<unsigned>(std::countr_one(digit % 2 == 0 ? digit - 1 : digit));
  const unsigned next_entry = entry ^ rotated_left(local_entry, axis + 1);
  const unsigned next_axis = (axis + turned % 3 + 1) % 3;
  return {static_cast<std::uint8_t>(digit),
          static_cast<std::uint8_t>(next_entry | next_axis << 3U)};
}

constexpr auto kSteps = [] {
  std::array<std::array<Step, 8>, 24> steps{};
  for (unsigned state = 0; state < 24; ++state)
    for (unsigned octant = 0; octant < 8; ++octant) steps[state][octant] = step_from(state, octant);
  return steps;
}();

/// The closed curve: the octants in the order of a cyclic Gray code, in each a Hilbert curve that
/// leaves where the next one comes in. Searched, since there are few.
class MooreCurve {
 public:
  constexpr MooreCurve() {
    for (unsigned entry = 0; entry < 8; ++entry)
      if (is_closed_from(0, entry, entry)) return;
  }
  /// By octants.
  [[nodiscard]] constexpr const std::array<Step, 8>& steps() const { return steps_; }

 private:
  constexpr bool is_closed_from(unsigned digit, unsigned entry, unsigned first_entry) {
    if (digit == 8) return entry == first_entry;
    const unsigned octant = gray(digit), next = gray((digit + 1) % 8);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned exit = entry ^ 1U << axis;
      if (((exit ^ next) & (octant ^ next)) != 0) continue;  // not beside the next octant
      steps_[octant] = {static_cast<std::uint8_t>(digit),
                        static_cast<std::uint8_t>(entry | axis << 3U)};
      if (is_closed_from(digit + 1, exit ^ octant ^ next, first_entry)) return true;
    }
    return false;
  }
  std::array<Step, 8> steps_{};
};

constexpr MooreCurve kMoore;

std::uint64_t curve_key(const std::array<std::uint32_t, 3>& cell, unsigned levels) {
  const auto octant_at = [&](unsigned level) {
    return (cell[0] >> level & 1U) | (cell[1] >> level & 1U) << 1U | (cell[2] >> level & 1U) << 2U;
  };
  Step step = kMoore.steps()[octant_at(levels - 1)];
  std::uint64_t key = step.digit;
  for (unsigned level = levels - 1; level-- > 0;) {
    step = kSteps[step.state][octant_at(level)];
    key = key << 3U | step.digit;
  }
  return key;
}

/// How far along an axis another curve's cube is moved, of the cube's width: multiples of the
/// powers of a number with g^4 = g + 1, which spread evenly (M. Roberts, 2018).
double shift(unsigned curve, unsigned axis) {
  constexpr std::array<double, 3> kOfAxis{0.8191725133961645, 0.6710436067037893,
                                          0.5497004779019703};
  double whole = 0;
  return std::modf(kOfAxis[axis] * curve, &whole);
}

}  // namespace

std::uint64_t Curves::key_of(const mesh::Point& p, unsigned curve) const {
  std::array<std::uint32_t, 3> at{cell(p.x, low_.x), cell(p.y, low_.y), cell(p.z, low_.z)};
  if (curve == 0) return curve_key(at, levels_);
  for (unsigned axis = 0; axis < 3; ++axis)
    at[axis] += static_cast<std::uint32_t>(shift(curve, axis) * (1U << levels_));
  return curve_key(at, levels_ + 1);
}

}  // namespace hexatlas::delaunay
