#pragma once
/// \file
/// Private to the filling by lattices: the points of a lattice inside a closed surface.

#include <array>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "enum/complex/broken_law.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

/// The median over the triangles of the mean of the two shorter sides.
[[nodiscard]] double usual_side(std::span<const mesh::Point> points,
                                std::span<const std::array<mesh::Index, 3>> triangles);

/// The points of the lattice (lattice.hpp) that are at least clearance * spacing away from the
/// surface, and that steps of the lattice between points at least half a step away from it do not
/// join to the outside. So none that is far from the surface is outside. Distances are computed in
/// double precision.
[[nodiscard]] std::variant<std::vector<mesh::Point>, complex::BrokenLaw> lattice_points(
    std::span<const mesh::Point> points, std::span<const std::array<mesh::Index, 3>> triangles,
    double spacing, double clearance);

}  // namespace hexatlas::hybrid
