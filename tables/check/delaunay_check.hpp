#pragma once
/// \file
/// The judge of Delaunay triangulations of points in space, and of regular triangulations of points
/// with weights, in code that shares nothing with what made them.
///
/// A mesh is accepted if all laws of DelaunayLaw hold. Then it is a Delaunay triangulation of its
/// points: its tetrahedra meet face to face, cover the convex hull of the points exactly once, and
/// no point is strictly inside the sphere through the vertices of a tetrahedron. The proof is in
/// docs/theory/proofs/delaunay-judge.md; in short: the boundary is seen from the centroid of one
/// tetrahedron, which no other one contains, without folds, so it is star-shaped, and as all its
/// edges are convex it is the boundary of the hull; facets that are locally Delaunay make the whole
/// Delaunay (B. Delaunay, "Sur la sphere vide", 1934). Convex edges alone do not suffice: a
/// bipyramid over a pentagram has them too.
///
/// With weights the sphere is the orthosphere: each point p is lifted to |p|^2 less its weight, and
/// the tetrahedra are the lower side of the hull of the lifted points. Points that are in no
/// tetrahedron and are no duplicates of a vertex, in place and weight, must be hidden: no point is
/// below the affine function of the tetrahedron in which it lies.
///
/// All signs are exact (signs.hpp). Points that are in no tetrahedron are allowed if they have the
/// coordinates of one that is. Where more than four points are on one sphere, any of the
/// triangulations is accepted; so is a point that is on an orthosphere, hidden or not.
///
/// Preconditions: finite coordinates; fewer than 2^30 tetrahedra. Errors: none; the judgement is a
/// value. Cost: O(T log d) with the d of tetrahedron_facets.hpp, and one sign per tetrahedron and
/// interior facet; some 60 bytes per tetrahedron besides the mesh. Hidden points: O(log n) each and
/// per tetrahedron, if boxes overlap few others.
/// Not promised: anything about a mesh of other shape than the hull, or with facets prescribed.

#include <cstdint>
#include <span>
#include <string>

#include "tables/check/mesh.hpp"
#include "tables/check/signs.hpp"

namespace hexatlas::check {

/// In the order in which they are tested.
enum class DelaunayLaw : std::uint8_t {
  kNone,             ///< no law is broken
  kCorners,          ///< some tetrahedra; four distinct vertices each, all among the points
  kPositive,         ///< each tetrahedron is positively oriented
  kTwoTetrahedra,    ///< each facet lies in at most two tetrahedra
  kOppositeSides,    ///< two tetrahedra at a facet are on opposite sides of it
  kConnected,        ///< the mesh is connected through facets
  kBoundarySurface,  ///< the boundary is a closed surface with Euler characteristic 2
  kConvexEdges,      ///< no boundary facet is visible from its neighbours
  kNoFolds,          ///< no boundary facet faces away from the base tetrahedron
  kCoveredOnce,      ///< the centroid of the base tetrahedron is in no other one
  kGivenPoints,      ///< the points are the given ones, in the same order
  kUnusedPoint,      ///< without weights: each point is a vertex, or has the coordinates of one
  kHiddenPoint,      ///< with weights: or is not below the tetrahedron in which it lies
  kEmptySpheres,     ///< the vertex behind an interior facet is not inside the sphere before it
};

/// A short name for programs, such as "empty-spheres".
[[nodiscard]] const char* name_of(DelaunayLaw law);

struct DelaunayVerdict {
  bool accepted = false;
  DelaunayLaw broken = DelaunayLaw::kNone;
  std::string reason;  ///< the first counterexample; points and tetrahedra are numbered from 0

  std::uint64_t points = 0;
  std::uint64_t duplicates = 0;  ///< of vertices, in no tetrahedron; this and the rest if accepted
  std::uint64_t hidden = 0;      ///< the other points that are in no tetrahedron
  std::uint64_t tetrahedra = 0;
  std::uint64_t facets = 0;
  std::uint64_t boundary_facets = 0;
  std::uint64_t boundary_vertices = 0;
  std::uint64_t cospherical = 0;  ///< interior facets whose two tetrahedra have one sphere
  SignCounts signs;
};

/// `given` may be null. Its points must be those of the mesh by value: -0 is 0.
[[nodiscard]] DelaunayVerdict check_delaunay(const TetrahedralMesh& mesh,
                                             const std::vector<Point>* given);
/// The points must be the given ones, whose weights decide.
[[nodiscard]] DelaunayVerdict check_regular(const TetrahedralMesh& mesh,
                                            const WeightedPoints& given);

}  // namespace hexatlas::check
