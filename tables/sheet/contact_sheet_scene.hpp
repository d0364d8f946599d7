#pragma once
/// \file
/// The exploded view of a triangulation with coordinates: which affine image of the points to draw,
/// how far to move the tetrahedra apart and where to look from.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"
#include "tables/format/catalogue.hpp"
#include "tables/sheet/contact_sheet_layout.hpp"
#include "tables/sheet/contact_sheet_occlusion.hpp"

namespace hexatlas::sheet {

/// What is drawn as a frame: edges of the cell, or of the boundary of a ball.
struct Frame {
  Links edges;
  std::vector<Vec> shape;  ///< a symmetric drawing of the vertices on `edges`, first facet below
};
[[nodiscard]] Frame frame_of(const complex::Cell& cell);
[[nodiscard]] Frame frame_of(const complex::Triangulation& ball);

/// Number of a tetrahedron's triangles on the boundary, for each.
[[nodiscard]] std::vector<std::size_t> boundary_triangles_per_tetrahedron(
    const complex::Triangulation& triangulation);

struct Scene {                     ///< on the screen: x to the right, y down, z towards the eye
  std::vector<std::size_t> order;  ///< of the tetrahedra, back to front
  std::vector<Corners> pieces;     ///< by tetrahedron, moved apart
  std::vector<Vec> vertices;       ///< not moved apart
};

/// The points are first deformed towards `frame.shape` (relaxed()): no tetrahedron is turned over
/// and none overlap. They do not overlap either when moved apart from the centre: a plane between
/// two goes on to be one. The eye is at that of many places, and the spread that of a few, from
/// which the most is seen of all tetrahedra. Everything is within `margin` of width x height.
/// Requires the points to be embedded.
[[nodiscard]] Scene scene_of(const Frame& frame, const complex::Triangulation& triangulation,
                             const certificate::Realization& points, double width, double height,
                             double margin);

}  // namespace hexatlas::sheet
