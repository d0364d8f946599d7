#pragma once
/// \file
/// Bilinear patches: the facets of trilinear hexahedra, and segments that meet them.
///
/// Definition. The corners p0, p1, p2, p3 in cyclic order define the map of the unit square
/// x(s, t) = p0 + s a + t c + st e, a = p1 - p0, c = p3 - p0, e = p0 - p1 + p2 - p3; its image is
/// the *patch*. The quad is *folded* if dx/ds x dx/dt is zero at some point of the closed square.
///
/// Method. With D = det(a, c, e): if D is not zero, then a, c, e are a basis in which the patch is
/// the part of the surface "third = first * second" over the unit square: the map is injective and
/// nowhere singular. If D is zero, all is in one plane, and the quad is not folded exactly if it is
/// strictly convex; then the patch is its convex hull. In both cases being over the square, or
/// inside the four edges, are four linear inequalities. On a segment they leave an interval with
/// rational ends, in which a root of a polynomial of degree 2, or 1 if D = 0, is asked for; that
/// takes rational numbers only. Proofs: docs/theory/self-meeting.md.
///
/// Requires. Finite coordinates, else PreconditionViolated; rounding to nearest.
/// Cost. Some microseconds; more if exponents are far apart.

#include <array>

#include "realize/exact/sign.hpp"

namespace hexatlas::exact {

/// The corners, in cyclic order.
using Patch = std::array<Point3, 4>;

/// Whether the map is singular somewhere on the closed square: exactly if the quad is flat and not
/// strictly convex, which includes equal corners and corners of 180 degrees. No hexahedron with
/// a folded facet has a positive Jacobian on the closed cube.
[[nodiscard]] bool is_folded(const Patch& patch);

/// A closed segment, possibly without its ends.
struct Segment {
  Point3 from, to;
  bool without_from = false, without_to = false;
};

/// Whether the segment and the patch have a common point. Requires a patch that is not folded, else
/// PreconditionViolated; different ends; and that an end which is left out is a point of the patch.
[[nodiscard]] bool meets(const Segment& segment, const Patch& patch);

}  // namespace hexatlas::exact
