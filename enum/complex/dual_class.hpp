#pragma once
/// \file
/// The class of a hexahedral mesh of a ball among all meshes with the same boundary, modulo 8.
///
/// Definition. The three squares in the middle of each hexahedron, glued along facets, are the
/// *dual surface* of a mesh: a surface that crosses itself. Two meshes of one boundary make a
/// 3-sphere with a closed dual surface. How often bands on it are twisted is a quadratic form with
/// values modulo 4; Brown's invariant of that form (brown.hpp) is the *dual class* of the one mesh
/// relative to the other. It is additive, and the difference of the numbers of hexahedra modulo 2.
///
/// Theorem (docs/theory/proofs/dual-class.md). If a part of a mesh is exchanged for another one
/// with the same boundary, the class changes by that of the parts relative to each other, whatever
/// surrounds them. In particular flips of a cube's facets, within the mesh, never change it: the
/// meshes of one boundary fall into eight parts that no such flips connect.
///
/// Sources. Quadratic form of an immersed surface: Pinkall (Topology 24, 1985); its invariant and
/// cobordism: Brown (Annals of Mathematics 95, 1972). Flips and cobordism of dual surfaces: Funar
/// (1999), Adiprasito, Liu (2020).

#include <vector>

#include "enum/complex/hex_complex.hpp"

namespace hexatlas::complex {

/// The dual class of `ball` relative to `other`, in [0, 8). Requires two balls glued of
/// right-handed hexahedra, each quad in at most two, with one boundary on the vertices
/// 0 .. shared-1; they need not obey the strict rule. Cost: cubic in their number of hexahedra with
/// a small constant: about a millisecond for two of 50.
[[nodiscard]] int dual_class(const HexComplex& ball, const HexComplex& other, VertexId shared);

/// Meshes of one boundary, as dual_class() wants them, in an order in which the first ones are of
/// many classes: the least one of each class, least ones first, then the second ones of each, and
/// so on. Equal ones stay in order.
[[nodiscard]] std::vector<HexComplex> spread_over_dual_classes(std::vector<HexComplex> meshes,
                                                               VertexId shared);

}  // namespace hexatlas::complex
