#pragma once
/// \file
/// Whether a triangulation can be realized under a condition: coordinates, a refutation, or
/// neither.
///
/// Method. First the signs: if no oriented matroid obeys the premises, that is the refutation. Then
/// coordinates, sought directly. Then oriented matroids in turn: one with a final polynomial is
/// excluded, together with all others to which the polynomial applies, until none is left or one
/// leads to coordinates. This follows J. Pellerin, K. Verhetsel, J.-F. Remacle, "There are 174
/// subdivisions of the hexahedron into tetrahedra" (2018), with certificates for every step.
///
/// Every answer has been checked by exact arithmetic: coordinates by conditions::..., refutations
/// by their own construction; tables/check judges both again. Deterministic. Cost: milliseconds per
/// easy class of the hexahedron, seconds for hard ones.

#include <cstdint>
#include <span>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"
#include "realize/solve/coordinates.hpp"

namespace hexatlas::solve {

struct Effort {
  SearchEffort coordinates{};
  int models = 200;             ///< oriented matroids that are looked at, at most
  unsigned proof_attempts = 8;  ///< refutations tried, of which the shortest is kept
};

/// Requires signs as conditions::premises() does.
[[nodiscard]] certificate::Answer decide(const complex::Triangulation& triangulation,
                                         std::span<const int> signs,
                                         certificate::Condition condition, const Effort& effort);

}  // namespace hexatlas::solve
