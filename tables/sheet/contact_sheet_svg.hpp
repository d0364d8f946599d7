#pragma once
/// \file
/// The drawings of a contact sheet: elements of SVG, numbers with at most one decimal.

#include <optional>
#include <string>

#include "enum/complex/cell.hpp"
#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"
#include "tables/sheet/contact_sheet_scene.hpp"

namespace hexatlas::sheet {

inline constexpr double kTileWidth = 200;
inline constexpr double kTileHeight = 176;

/// At most one decimal.
[[nodiscard]] std::string decimal(double number);
/// The members in ascending order, a hexadecimal digit each.
[[nodiscard]] std::string digits_of(complex::VertexSet set);

/// Style rules of the faces: classes k0 .. k4, by boundary triangles of the tetrahedron, times
/// three tints, times light 0 .. 7; and d0 .. d4 for what is flat.
[[nodiscard]] std::string colour_rules();

/// The tetrahedra moved apart, and the frame with its vertices where they were.
/// Requires embedded points.
[[nodiscard]] std::string exploded_drawing(const Frame& frame,
                                           const complex::Triangulation& triangulation,
                                           const certificate::Realization& points);

/// A node per tetrahedron; a line per common triangle; with a cell, a dashed line per quad whose
/// halves belong to the two. Source of this graph: S. Meshkat, D. Talmor, Generating a mixed mesh
/// of hexahedra, pentahedra and tetrahedra from an underlying tetrahedral mesh (2000).
[[nodiscard]] std::string graph_drawing(const complex::Triangulation& triangulation,
                                        const std::optional<complex::Cell>& cell);

}  // namespace hexatlas::sheet
