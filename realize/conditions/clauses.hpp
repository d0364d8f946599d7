#pragma once
/// \file
/// What the signs of points must obey if the points are to realize a triangulation: the premise
/// clauses of docs/formats/catalogue.md.
///
/// A set of signs that satisfies the clauses is an acyclic uniform oriented matroid in which the
/// tetrahedra have their signs and any two meet properly. Whether points have these signs is
/// another question; if the clauses are unsatisfiable, no points realize the triangulation. Source:
/// J. Pellerin, K. Verhetsel, J.-F. Remacle, "There are 174 subdivisions of the hexahedron into
/// tetrahedra" (2018); conditions on circuits after Bjoerner et al., "Oriented Matroids" (1999).
///
/// Requires throughout: a triangulation with vertices below kMaxTriangulationVertices and sets of
/// four as tetrahedra, else PreconditionViolated.

#include <span>
#include <vector>

#include "enum/complex/triangulation.hpp"
#include "realize/certificate/certificate.hpp"

namespace hexatlas::conditions {

/// The unit clauses of the signs of the tetrahedra, +1 or -1 each, vertices ascending. Requires one
/// sign per tetrahedron.
[[nodiscard]] std::vector<certificate::Clause> sign_clauses(
    const complex::Triangulation& triangulation, std::span<const int> signs);

/// Any two tetrahedra meet in their common face: for tetrahedra s, t and five points C of their
/// union, not (those of C in s only on one side of the Radon partition of C, those in t only on the
/// other).
[[nodiscard]] std::vector<certificate::Clause> proper_clauses(
    const complex::Triangulation& triangulation);

/// The corner determinants of the trilinear hexahedron are positive; vertices as in
/// docs/theory/conventions.md. Eight unit clauses, necessary for a positive Jacobian.
[[nodiscard]] std::vector<certificate::Clause> corner_clauses();

/// All clauses of a condition, in the order of the format. `signs` as for sign_clauses(). Requires
/// eight vertices for `jacobian`. About 9,000 clauses for 8 vertices, 60,000 for 10.
[[nodiscard]] std::vector<certificate::Clause> premises(const complex::Triangulation& triangulation,
                                                        std::span<const int> signs,
                                                        certificate::Condition condition);

}  // namespace hexatlas::conditions
