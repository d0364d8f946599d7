#pragma once
/// \file
/// The judge of hybrid meshes: tetrahedra, hexahedra, prisms and pyramids together, in code that
/// shares nothing with what made them.
///
/// A mesh is accepted if all laws of HybridLaw hold. Then its cells are right-handed and valid as
/// finite elements (positive Jacobian determinant everywhere, by exact arithmetic), meet facet to
/// facet, and cover the neighbourhood of each inner point of the mesh exactly once. How often a
/// point of space is covered is how often the boundary winds around it; so if the boundary is that
/// of a given tetrahedral mesh that covers its domain once, the hybrid mesh does, up to what lies
/// between the warped quads of its boundary and the two triangles of each. The proof is in
/// docs/theory/proofs/hybrid-judge.md.
///
/// Cells: tetrahedra affine, hexahedra trilinear, prisms linear in the triangle times linear in the
/// height, pyramids the cones from the apex over the bilinear patch of the base.
///
/// Preconditions: finite coordinates; fewer than 2^29 cells. Errors: none; the judgement is a
/// value. Cost: O(C log C) for C cells, some 7 us and 800 bytes per hexahedron.
///
/// Not promised: without a boundary given, that parts of the mesh far from each other are disjoint,
/// or cells at a vertex of the boundary that share no edge; with one, that its tetrahedra are;
/// that the boundary is a manifold (singular_boundary_edges); that two cells meet in a single face.

#include <cstdint>
#include <string>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

/// In the order in which they are tested.
enum class HybridLaw : std::uint8_t {
  kNone,           ///< no law is broken
  kCorners,        ///< some cells; distinct vertices in each, all among the points
  kPositive,       ///< the Jacobian determinant of each cell is positive everywhere
  kTwoCells,       ///< each facet lies in at most two cells
  kSameCycle,      ///< two quads with the same vertices list them in the same cyclic order
  kOppositeSides,  ///< two cells at a facet are on opposite sides of it
  kDiagonal,       ///< no edge joins two vertices that are opposite in a quad
  kAroundEdge,     ///< no two cells overlap around an edge, at either end of it
  kAroundVertex,   ///< the cells at an inner vertex hang together through facets that contain it
  kGivenMesh,      ///< the given tetrahedral mesh obeys the laws before
  kGivenBoundary,  ///< the boundary is that of the given mesh, two triangles for each quad
};

/// A short name for programs, such as "around-edge".
[[nodiscard]] const char* name_of(HybridLaw law);

struct HybridVerdict {
  bool accepted = false;
  /// No law is broken, but subdivision did not decide whether all hexahedra are valid.
  bool undecided = false;
  HybridLaw broken = HybridLaw::kNone;  ///< the first law that is broken, or not decided
  std::string reason;  ///< the first counterexample; points and cells are numbered from 0

  std::uint64_t points = 0;
  std::uint64_t unused_points = 0;  ///< in no cell; this and what is below the cells if accepted
  std::uint64_t tetrahedra = 0;
  std::uint64_t hexahedra = 0;
  std::uint64_t prisms = 0;
  std::uint64_t pyramids = 0;
  std::uint64_t boundary_triangles = 0;
  std::uint64_t boundary_quads = 0;
  std::uint64_t warped_boundary_quads = 0;    ///< whose four vertices are in no plane
  std::uint64_t singular_boundary_edges = 0;  ///< in more than two boundary facets
};

/// `given` may be null; tetrahedra that are all inside out stand for themselves turned over. Its
/// points and those of the mesh are the same if their coordinates are.
[[nodiscard]] HybridVerdict check_hybrid(const HybridMesh& mesh, const TetrahedralMesh* given);

}  // namespace hexatlas::check
