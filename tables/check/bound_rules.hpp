#pragma once
/// \file
/// Internal to the judge: the rules by which a certificate of a lower bound refutes a state
/// (docs/formats/bound.md). `left` is the number of hexahedra that may still come.
///
/// Errors: none. Cost: quadratic in the number of open facets, except for the face budget, which
/// is cubic at worst.

#include "tables/check/bound_state.hpp"

namespace hexatlas::check {

/// e of the format, of a vertex.
[[nodiscard]] int euler_at(const BoundState& state, std::size_t v);

/// Whether two open facets with a common edge may be facets of one hexahedron to come. False if
/// they have no common edge.
[[nodiscard]] bool fit_across(const BoundState& state, const BoundFacet& f, const BoundFacet& g);

/// Whether two different open facets, f before g, are never facets of one hexahedron to come.
[[nodiscard]] bool are_apart(const BoundState& state, const BoundFacet& f, const BoundFacet& g);

/// The dimension of the space of sets of open facets that meet each edge an even number of times.
[[nodiscard]] int cycle_dimension(const BoundState& state);

[[nodiscard]] bool exceeds_face_budget(const BoundState& state, int left);

/// At most so many new vertices may come by counting corners and edges; negative if there is no
/// mesh.
[[nodiscard]] int room_of(const BoundState& state, int left);

/// How many may come: by the limit of interior vertices, `interior`, and for balls of each colour.
/// A negative number means that there is no mesh.
[[nodiscard]] BoundNewVertices may_come(const BoundState& state, int interior);
/// With the room too.
[[nodiscard]] BoundNewVertices within_room(const BoundState& state, int interior, int left);
[[nodiscard]] bool is_negative(const BoundNewVertices& number) noexcept;

/// For balls: a vertex of the last hexahedron whose link is part of no sphere.
[[nodiscard]] bool has_bad_link(const BoundState& state);

}  // namespace hexatlas::check
