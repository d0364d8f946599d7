#pragma once
/// \file
/// Validity and shape of one tetrahedron, prism or pyramid. Hexahedra: hexahedron.hpp.
///
/// Validity. A tetrahedron is *valid* if its vertices are positively oriented. Prisms and pyramids,
/// and the proofs: realize/exact/prism.hpp. Nothing is `undecided` here. *Inverted*: the
/// determinant of the three edges at a corner is not positive; of a pyramid, at a corner of the
/// base.
///
/// Shape. The least over the corners of a number in [-1, 1] that has the sign of the determinant
/// of the edges there, decided exactly; so the least is positive exactly if the cell is not
/// inverted. A corner with an edge of length zero counts 0. u, v, w are the edges at the corner.
///
/// Tetrahedron: sqrt 2 det(u, v, w) / (|u| |v| |w|), the least in absolute value. The product of
/// the four values is 4 d^4 / (product of the edges)^2, d being the determinant, and sqrt 2 d is at
/// most the square root of the product of the edges: at most 1, for regular tetrahedra only.
///
/// Prism: 2 / (3 sqrt 3) det(u, v, w) (1/(|u| |v|) + 1/(|v| |t|) + 1/(|u| |t|)) / |w|, where w is
/// the lateral edge and t the third edge of the triangle. Up to the factor it is the sum of the
/// sines of the triangle's angles times the cosine of the angle of w with its normal: 1 for right
/// prisms over equilateral triangles, of any height.
///
/// Pyramid, at a corner of the base with the edge w to the apex: with z = sqrt 2 (w - (u + v) / 2)
/// and D = det(u, v, z), 3 D^(2/3) / (|u|^2 + |v|^2 + |z|^2). By the inequality of the means at
/// most 1, and 1 for the square base with equilateral sides, where u, v, z are orthonormal up to a
/// factor.
///
/// Requires. Finite coordinates, else PreconditionViolated. No scale makes a shape overflow.
/// Cost. Below a microsecond where double precision decides; some microseconds otherwise.
/// Not promised. That a shape proves validity inside: of a prism it does not.

#include <array>

#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/hexahedron.hpp"

namespace hexatlas::quality {

using TetrahedronCorners = std::array<mesh::Point, 4>;
/// Bottom 0 1 2, top 3 4 5, as mesh::Prism.
using PrismCorners = std::array<mesh::Point, 6>;
/// Base 0 1 2 3, apex 4, as mesh::Pyramid.
using PyramidCorners = std::array<mesh::Point, 5>;

[[nodiscard]] Verdict verdict_of_tetrahedron(const TetrahedronCorners& corners);
[[nodiscard]] Verdict verdict_of_prism(const PrismCorners& corners);
[[nodiscard]] Verdict verdict_of_pyramid(const PyramidCorners& corners);

[[nodiscard]] double scaled_jacobian(const TetrahedronCorners& p);
[[nodiscard]] double scaled_jacobian(const PrismCorners& p);
[[nodiscard]] double scaled_jacobian(const PyramidCorners& p);

/// Whether the shape, computed as above, is in truth greater than the threshold: decided exactly,
/// so that no rounding, and no numbering of the corners, has a say; what equals it is not greater.
/// Requires 0 <= threshold <= 1.
[[nodiscard]] bool exceeds(const PrismCorners& p, double shape, double threshold);
[[nodiscard]] bool exceeds(const PyramidCorners& p, double shape, double threshold);

}  // namespace hexatlas::quality
