#pragma once
/// \file
/// Points that show a triangulation better than the ones given.

#include <vector>

#include "enum/complex/triangulation.hpp"
#include "tables/sheet/contact_sheet_layout.hpp"
#include "tables/sheet/contact_sheet_occlusion.hpp"

namespace hexatlas::sheet {

[[nodiscard]] std::vector<Corners> corners_of(const complex::Triangulation& triangulation,
                                              const std::vector<Vec>& vertices);

/// Moves single points, as long as this helps, towards their places in the shape and away from flat
/// tetrahedra: it lowers sum |p - place|^2 + w sum 1 / volume. No tetrahedron is ever turned over
/// and no two ever overlap, up to rounding; so the orientations stay, while convexity may be lost.
/// Points beyond the shape have no place. Requires embedded points.
[[nodiscard]] std::vector<Vec> relaxed(Likeness start, const complex::Triangulation& triangulation);

}  // namespace hexatlas::sheet
