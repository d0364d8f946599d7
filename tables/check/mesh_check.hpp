#pragma once
/// \file
/// The judge of hexahedral meshes. It decides by labels alone, without geometry, in code that
/// shares nothing with what made the mesh.
///
/// A mesh is accepted if all laws of Law (verdict.hpp) hold. Without a surface the boundary may be
/// any sphere. With a surface, its points must be the first points of the mesh, and its quads the
/// boundary quads of the mesh seen from outside, as cycles up to rotation: all of them or, if the
/// hexahedra are oriented inwards, all reversed. A point of the surface that no quad of it uses may
/// be unused in the mesh.
///
/// Sources: the strict rule of K. Verhetsel, J. Pellerin, J.-F. Remacle, Finding hexahedrizations
/// for small quadrangulations of the sphere, 2019; links and shellings as in the theory of
/// 3-manifolds. Cost: O(H * degree), and at worst 90 greedy searches for a proof of ball.
/// Not promised: that every ball is accepted (see ball.hpp; then `undecided` is set); anything
/// about the shape of the hexahedra in space, of which valid_in_space() tells.

#include <cstdint>

#include "tables/check/mesh.hpp"
#include "tables/check/verdict.hpp"

namespace hexatlas::check {

/// `boundary` may be null.
[[nodiscard]] Verdict check_mesh(const Mesh& mesh, const Surface* boundary);

/// Hexahedra whose Jacobian determinant is positive everywhere, by exact arithmetic, and those of
/// which it was not decided. Requires a mesh that is accepted, with finite points. Cost: a
/// microsecond for each hexahedron; where it is close, up to a second.
struct ValidInSpace {
  std::uint64_t valid = 0;
  std::uint64_t undecided = 0;
};
[[nodiscard]] ValidInSpace valid_in_space(const Mesh& mesh);

}  // namespace hexatlas::check
