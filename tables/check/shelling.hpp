#pragma once
/// \file
/// Internal to the judge: proofs that tetrahedra are a ball.
///
/// A shelling is an order in which each tetrahedron after the first meets the union of those before
/// it in one, two or three of its triangles and in no vertex or edge outside these. One to three
/// triangles of a tetrahedron form a disc, and if no triangle lies in three tetrahedra, then this
/// disc is in the boundary of the union; two balls glued along a disc in both boundaries are a
/// ball. If the last tetrahedron meets the union in all its four triangles, the whole is a sphere
/// (G. Danaraj, V. Klee, "Which spheres are shellable?", 1978).

#include <cstdint>

#include "tables/check/catalogue_read.hpp"

namespace hexatlas::check {

/// Requires: no triangle lies in three tetrahedra, none is listed twice. Cost: O(t).
[[nodiscard]] bool is_shelling(const Tetrahedra& order);

/// Whether a shelling of the tetrahedra was found, or one of the sphere that the cone from a new
/// vertex to their boundary makes of them: in a triangulated 3-sphere, the complement of the open
/// star of a vertex is a ball. Searches depth first, in at most kShellingSteps steps each, taken
/// from `steps_left`. Not promised: that one is found; there are balls without.
/// Requires: as above; at most 15 vertices for the second way.
[[nodiscard]] bool find_ball_proof(const Tetrahedra& tetrahedra, std::uint64_t& steps_left);

inline constexpr std::uint64_t kShellingSteps = 200'000;

}  // namespace hexatlas::check
