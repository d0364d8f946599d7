#pragma once
/// \file
/// Internal to the judge: the rule of a certificate of a lower bound that refutes a state because
/// an image of it comes before (docs/formats/bound.md).
///
/// Errors: none. Cost: the number of automorphisms times the square of that of the hexahedra.

#include <cstdint>
#include <span>
#include <vector>

#include "tables/check/bound_state.hpp"

namespace hexatlas::check {

/// The image of each vertex of the boundary.
using BoundAutomorphism = std::vector<std::uint8_t>;

/// Whether the image of the state under one of the automorphisms has a lesser path.
[[nodiscard]] bool has_lesser_image(const BoundState& state,
                                    std::span<const BoundAutomorphism> automorphisms);

}  // namespace hexatlas::check
