#pragma once
/// \file
/// A convex polyhedron for a boundary of which only the combinatorics are given.
///
/// Definition. A Koebe polyhedron of a 3-connected planar graph has that graph, and its edges touch
/// the unit sphere. It is unique up to Moebius transformations; this is the one whose points of
/// contact have the origin as their centre.
///
/// Method. The cones from the vertices touch the sphere in circles; those, and the circles of the
/// facets, form a pattern whose circles meet at right angles at each point of contact. With one
/// such point at infinity it lies in the plane, four circles being lines, and the logarithms of the
/// radii minimize a convex function: Newton's method, Eigen's sparse Cholesky factorization. The
/// centre is reached by Lorentz boosts. Sources. A. Bobenko, B. Springborn, "Variational principles
/// for circle patterns and Koebe's theorem", Transactions of the AMS 356 (2004); B. Springborn, "A
/// unique representation of polyhedral types", Mathematische Zeitschrift 249 (2005).
///
/// Not promised: planar quads beyond rounding, or simple numbers.

#include <vector>

#include "enum/complex/quadrangulation.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::untangle {

/// The vertices; quads are counter-clockwise seen from outside. Requires a 3-connected
/// quadrangulation, else PreconditionViolated. Cost: about a millisecond for 20 quads.
[[nodiscard]] std::vector<exact::Point3> koebe_polyhedron(const complex::Quadrangulation& sphere);

}  // namespace hexatlas::untangle
