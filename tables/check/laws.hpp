#pragma once
/// \file
/// Internal to the judge: the laws of a hexahedral mesh, one function each. A function returns
/// nothing if its law holds, else what breaks it. Each requires that the laws before it hold.
/// Cost: O(H * degree), where the degree is the number of hexahedra at a vertex.

#include "tables/check/incidence.hpp"

namespace hexatlas::check {

/// Law::kCorners; the one law that needs no incidence.
[[nodiscard]] Finding check_corners(std::span<const Hexahedron> cells, std::uint64_t vertex_count);
[[nodiscard]] Finding check_two_hexahedra(const Incidence& incidence);
/// Any two hexahedra share nothing, one vertex, the two ends of an edge of both, or the four
/// vertices of a quad of both, in the same cyclic order. So no edge is a diagonal elsewhere.
[[nodiscard]] Finding check_strict_rule(const Incidence& incidence);
[[nodiscard]] Finding check_orientation(const Incidence& incidence);
[[nodiscard]] Finding check_connected(const Incidence& incidence);
/// The link of a vertex has a triangle per hexahedron at it. It must be a connected surface with
/// Euler characteristic 2 and without boundary (a sphere) if no boundary quad contains the vertex,
/// else of Euler characteristic 1 with boundary (a disc).
[[nodiscard]] Finding check_links(const Incidence& incidence);
/// The boundary quads form a connected closed surface with Euler characteristic 2.
[[nodiscard]] Finding check_boundary_sphere(const Incidence& incidence);

}  // namespace hexatlas::check
