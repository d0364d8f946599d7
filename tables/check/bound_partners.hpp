#pragma once
/// \file
/// Internal to the judge: the rule of a certificate of a lower bound that asks whether the vertices
/// of a ball find the partners that the hexahedra to come at them need, and which vertices are
/// saturated (docs/formats/bound.md).
///
/// Errors: none. Cost: some times the square of the number of vertices.

#include "tables/check/bound_state.hpp"

namespace hexatlas::check {

struct BoundPartners {
  bool are_too_few = false;
  VertexSet saturated = 0;  ///< those of the state, and further ones
};

/// Requires a state of kind `ball`; `may_come`: how many new vertices, whatever the room.
[[nodiscard]] BoundPartners partners_of(const BoundState& state, const BoundNewVertices& may_come);

}  // namespace hexatlas::check
