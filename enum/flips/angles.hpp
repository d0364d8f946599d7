#pragma once
/// \file
/// Angles along the edges of a cavity, which tell where hexahedra can have a good shape.
///
/// A layer below a disc has a hexahedron below each quad of the disc. Where the disc ends that
/// hexahedron also has a quad of the zone as a side; so the angle between the two is one of its
/// own, and where the boundary is flat there, no places of its other vertices make it valid. So a
/// zone is *sharp* if its disc ends in edges that are: M. Mueller-Hannemann, "Hexahedral mesh
/// generation by successive dual cycle elimination", 1999, has such a condition.
///
/// Angles are interior ones in whole degrees: 90 at an edge of a cube, 180 where the boundary is
/// flat, more where it bends inwards. They come from outside, and decide what is tried, not what is
/// allowed.

#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/peeling.hpp"
#include "enum/flips/pillow.hpp"

namespace hexatlas::flips {

/// At dart d the angle along its edge; darts that are twins have the same. There are
/// 4 * quad_numbers() of them, of which those of quads that are gone mean nothing.
using Angles = std::vector<std::int16_t>;

inline constexpr int kRightAngle = 90, kFlatAngle = 180, kFullTurn = 360;

/// How far an angle of a hexahedron may be from a right one: at the rim of a disc, where the
/// first go before the others, and between quads of a zone, where another zone would have it as
/// well.
inline constexpr int kRightAtRim = 27, kSharpAtRim = 54, kLeastAtRim = 72, kAlongZone = 76;
/// And how far one that two hexahedra share from a flat one, within a disc.
inline constexpr int kFold = 54;
/// What is left of the cavity beyond a hexahedron, at least.
inline constexpr int kLeastLeft = 45;

[[nodiscard]] inline bool is_good(int angle, int within) {
  return std::abs(angle - kRightAngle) <= within;
}
/// Two hexahedra share it. At a sharp fold both would be thin for their whole length.
[[nodiscard]] inline bool is_good_fold(int angle) { return std::abs(angle - kFlatAngle) <= kFold; }

/// What is left of the cavity at an edge where a hexahedron is taken off.
[[nodiscard]] inline std::int16_t less_a_right_angle(std::int16_t angle) {
  return static_cast<std::int16_t>(angle - kRightAngle);
}

inline void expect_one_each(const Peeling& peeling, const Angles& angles) {
  core::expects(angles.size() == 4 * std::size_t{peeling.quad_numbers()},
                "an angle for each side of a quad");
}

/// take_layer() of pillow.hpp with what is known of the angles afterwards: of the quads that come
/// up those of the quads above them, less a right angle across the zone. Says whether it was done.
bool take_layer(Peeling& peeling, std::span<const std::uint32_t> quads, Angles& angles);

}  // namespace hexatlas::flips
