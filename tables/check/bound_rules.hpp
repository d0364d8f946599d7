#pragma once
/// \file
/// Internal to the judge: the rules by which a certificate of a lower bound refutes a state
/// (docs/formats/bound.md). `left` is the number of hexahedra that may still come.
///
/// Errors: none. Cost: quadratic in the number of open facets, except for the face budget, which
/// is cubic at worst.

#include <cstdint>
#include <span>
#include <vector>

#include "tables/check/bound_state.hpp"

namespace hexatlas::check {

/// The image of each vertex of the boundary.
using BoundAutomorphism = std::vector<std::uint8_t>;

/// Whether two open facets with a common edge may be facets of one hexahedron to come. False if
/// they have no common edge.
[[nodiscard]] bool fit_across(const BoundState& state, const BoundFacet& f, const BoundFacet& g);

/// Whether two different open facets are never facets of one hexahedron to come.
[[nodiscard]] bool are_apart(const BoundState& state, const BoundFacet& f, const BoundFacet& g);

/// The dimension of the space of sets of open facets that meet each edge an even number of times.
[[nodiscard]] int cycle_dimension(const BoundState& state);

[[nodiscard]] bool exceeds_face_budget(const BoundState& state, int left);

/// At most so many new vertices may come; negative if there is no mesh.
[[nodiscard]] int room_of(const BoundState& state, int left);

/// For balls: a vertex of the last hexahedron whose link is part of no sphere.
[[nodiscard]] bool has_bad_link(const BoundState& state);

/// Whether the last hexahedron has, on some quad of the boundary, a type less than that of the
/// first one, which lies on quad `first`.
[[nodiscard]] bool is_less_by_symmetry(const BoundState& state,
                                       std::span<const BoundAutomorphism> automorphisms,
                                       std::size_t first);

}  // namespace hexatlas::check
