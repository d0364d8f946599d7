#pragma once
/// \file
/// Pieces of a cavity one layer thick, between quads of its boundary that face each other; and what
/// of angles makes hexahedra good. For sharp_zones.hpp, where the angles are explained.

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "enum/core/checks.hpp"
#include "enum/flips/sharp_zones.hpp"
#include "enum/flips/zone.hpp"

namespace hexatlas::flips {

/// How far an angle of a hexahedron may be from a right one: at the rim of a disc, where what is
/// nearly right goes first, and between quads of a zone, where another zone would have it as well.
inline constexpr float kRightAtRim = 0.3F, kSharpAtRim = 0.6F, kAlongZone = 0.85F;
/// What is left of the cavity beyond a hexahedron.
inline constexpr float kLeastLeft = 0.5F;

[[nodiscard]] inline bool is_good(float angle, float within) {
  return std::abs(angle - 1) <= within;
}
/// Two hexahedra share it. At a sharp fold both would be thin for their whole length.
[[nodiscard]] inline bool is_good_fold(float angle) { return angle >= 1.4F && angle <= 2.6F; }

inline void expect_one_each(const Peeling& peeling, const Angles& angles) {
  core::expects(angles.size() == 4 * std::size_t{peeling.quad_numbers()},
                "an angle for each side of a quad");
}

/// The two sides of a zone.
enum class Side : std::uint8_t { left, right };

/// The side of a zone's quad at which a disc begins, by the dart at which the curve comes in.
[[nodiscard]] inline Peeling::Dart rim(Peeling::Dart in, Side side) {
  return side == Side::left ? Peeling::prev(in) : Peeling::next(in);
}

/// Two quads, opposite each other in a hexahedron to be: side i of the one, counted from its dart
/// 0, faces that of the other which facing(i) gives.
struct FacingQuads {
  std::uint32_t left = 0;        ///< the quad
  Peeling::Dart right_of_0 = 0;  ///< faces dart 0 of it

  [[nodiscard]] Peeling::Dart side(unsigned i) const { return 4 * left + (i & 3U); }
  /// The other one is seen from the other side.
  [[nodiscard]] Peeling::Dart facing(unsigned i) const {
    return (right_of_0 & ~3U) | ((right_of_0 - i) & 3U);
  }
};

/// What lies beyond two sides that face each other.
enum class Beyond : std::uint8_t {
  more,    ///< two quads that have to face each other as well
  end,     ///< nothing of this piece
  nothing  ///< that is allowed, so that there is no such piece
};

/// The quads beside a zone that face each other across it, those beyond them, and so on as far as
/// `beyond` says. Those beside the zone come first. nullopt if quads that have to do not face each
/// other. Requires a zone that does not cross itself.
[[nodiscard]] std::optional<std::vector<FacingQuads>> facing_quads(
    const Peeling& peeling, const Zone& zone,
    const std::function<Beyond(Peeling::Dart, Peeling::Dart)>& beyond);

}  // namespace hexatlas::flips
