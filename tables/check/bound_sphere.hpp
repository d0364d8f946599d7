#pragma once
/// \file
/// Internal to the judge: the boundary that a certificate of a lower bound names, and its
/// symmetries, found by trying all.
///
/// Errors: none; refusals are values. Cost: O(n^2).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tables/check/bound_paths.hpp"
#include "tables/check/mesh.hpp"

namespace hexatlas::check {

/// Why the quads, each read in either direction, are no 3-connected quadrangulation of the sphere
/// with this code; empty if they are.
[[nodiscard]] std::string fault_of_boundary(std::span<const Quad> quads, std::string_view code);

/// The permutations of the vertices that take quads to quads, mirror symmetries and the identity
/// included, for quads without fault and at most 255 vertices.
[[nodiscard]] std::vector<BoundAutomorphism> automorphisms_of(std::span<const Quad> quads);

}  // namespace hexatlas::check
