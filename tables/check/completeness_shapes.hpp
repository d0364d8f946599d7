#pragma once
/// \file
/// Internal to the judge: whether tetrahedra on the vertices of the cube are a triangulation of the
/// hexahedron, and whether some of them keep a set from being part of one.
///
/// Cost: microseconds, or a millisecond where no shelling is found.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tables/check/completeness_rules.hpp"

namespace hexatlas::check {

/// No triangulation has more: a ball with t tetrahedra and all eight vertices, on its boundary, has
/// t + 13 edges (Euler characteristic 1), out of 28.
inline constexpr std::size_t kMostTetrahedra = 15;

/// The 48 symmetries of the cube, each as the images of the vertices.
using CubeSymmetry = std::array<std::uint8_t, kCubeVertices>;
[[nodiscard]] const std::vector<CubeSymmetry>& cube_symmetries();
[[nodiscard]] CubeSet image_of(CubeSet set, const CubeSymmetry& symmetry) noexcept;

/// Why the tetrahedra are no triangulation of the hexahedron without interior vertex and without
/// boundary tetrahedra; the empty string if they are one. That they are a ball is proven as
/// shelling.hpp says.
[[nodiscard]] std::string fault_of_triangulation(const std::vector<CubeSet>& tetrahedra);

/// Why it is not proven that no triangulation has all these tetrahedra; the empty string if it is,
/// because they meet in the vertex, and their triangles opposite to it form a connected surface
/// that is no part of a disc: it has no boundary, or b > 0 boundary circles and an Euler
/// characteristic other than 2 - b.
[[nodiscard]] std::string fault_of_obstruction(unsigned vertex,
                                               std::span<const CubeSet> tetrahedra);

}  // namespace hexatlas::check
