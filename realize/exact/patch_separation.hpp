#pragma once
/// \file
/// A quick proof that two bilinear patches have nothing in common but what they share.
///
/// Claim. If a plane contains the shared corners, at most two, and strictly on one side of it are
/// the other corners of one quad, strictly on the other side those of the other, then the patches
/// have no common point but the shared corners, and those of an edge that both quads have.
/// Proof. Each point of a patch is a mean of its corners with weights (1-s)(1-t), s(1-t), st,
/// (1-s)t. It is on the plane only if the other corners have weight zero, and a common point is.
/// That leaves nothing, one corner, an edge, or, if two opposite corners are shared, these.
///
/// Method. The planes are guessed in double precision, each through three points with double
/// coordinates; on which side a corner lies is decided by filtered_sign_of_orientation().
///
/// Cost. About a microsecond. Not promised: that a plane is found where there is one.

#include <array>
#include <cstddef>
#include <cstdint>

#include "realize/exact/patch.hpp"

namespace hexatlas::exact {

/// Which corner of the second quad corner i of the first one is.
using Twins = std::array<std::uint8_t, 4>;
inline constexpr std::uint8_t kNoTwin = 4;

/// True is a proof that the patches have no common point but those claimed above; false says
/// nothing. Requires finite coordinates, and equal points of twins.
[[nodiscard]] bool separated(const Patch& first, const Patch& second, const Twins& twin);

}  // namespace hexatlas::exact
