#pragma once
/// \file
/// Triangulated 3-spheres by bistellar flips, and the 3-balls that are spheres less a vertex.
///
/// A bistellar flip takes a face A whose link is the boundary of a simplex B, B no face, and
/// replaces A * dB by dA * B (U. Pachner, "P.L. homeomorphic manifolds are equivalent by elementary
/// shellings", European J. Combin. 12, 1991). A tetrahedron A is subdivided by a new vertex B
/// (1-4); a triangle gives way to an edge (2-3), an edge to a triangle (3-2).
///
/// The spheres with n + 1 vertices are sought as the closure of all subdivisions of those with n
/// under 2-3 and 3-2 flips. All of them are spheres, no two are isomorphic. That none is missing
/// rests on the flip graph with n + 1 vertices, and the subdivided spheres among its nodes, being
/// connected, which is not proven; hence the member is called `found`. The numbers for 5 .. 10
/// vertices agree with the literature: 1, 2, 5, 39, 1296, 247882 (A. Altshuler, J. Bokowski,
/// L. Steinberg, "The classification of simplicial 3-spheres with nine vertices into polytopes and
/// nonpolytopes", Discrete Math. 31, 1980; F. H. Lutz, "Combinatorial 3-manifolds with 10
/// vertices", Beitr. Algebra Geom. 49, 2008).

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "enum/complex/triangulation.hpp"

namespace hexatlas::balls {

inline constexpr int kMinSphereVertices = 5;
/// Every sphere is checked by a shelling, and only with up to this number of vertices all have one.
inline constexpr int kMaxSphereVertices = 10;

/// The order of all lists here: by number of tetrahedra, then lexicographically.
[[nodiscard]] bool is_before(const complex::Triangulation& a, const complex::Triangulation& b);

/// All complexes that a 2-3 or a 3-2 flip makes of a closed one, tetrahedra ascending, in no stated
/// order. Requires tetrahedra that form a closed 3-manifold on at most kMaxSphereVertices vertices.
[[nodiscard]] std::vector<complex::Triangulation> flipped(const complex::Triangulation& sphere);

/// All 1-4 subdivisions, one per tetrahedron; the new vertex has the greatest number.
[[nodiscard]] std::vector<complex::Triangulation> subdivided(const complex::Triangulation& sphere);

struct Spheres {
  int vertices = 0;
  /// One per class, mirror images identified, in the labels of canon::triangulation_form();
  /// ascending by number of tetrahedra, then lexicographically.
  std::vector<complex::Triangulation> found;
};

/// Called now and then, always on the calling thread: spheres found and spheres of them whose flips
/// have been made, both with `vertices` vertices.
using SphereProgress = std::function<void(int vertices, std::size_t found, std::size_t flipped)>;

struct SphereOptions {
  int threads = 1;
  SphereProgress progress{};
};

/// Requires kMinSphereVertices <= vertices <= kMaxSphereVertices and threads >= 1. The result does
/// not depend on the number of threads. Throws InternalError if a complex found has no shelling.
/// Cost: a fraction of a second for 9 vertices; tens of seconds and 200 MB for 10.
[[nodiscard]] Spheres spheres(int vertices, const SphereOptions& options = {});

/// The one list that follows another: spheres(n + 1) from spheres(n). Requires a list that
/// spheres() has made, with fewer than kMaxSphereVertices vertices.
[[nodiscard]] Spheres next_spheres(const Spheres& list, const SphereOptions& options = {});

/// What is left of a sphere without the open star of a vertex: a ball whose boundary is the link.
/// `labels` maps the vertices of the sphere to those of the ball: boundary first, then
/// interior, both ascending; the removed vertex to the number of vertices of the ball.
struct PuncturedSphere {
  complex::Triangulation ball;
  int boundary_vertices = 0;
  complex::VertexMap labels{};
};

/// Requires a sphere and 0 <= vertex < sphere.vertices.
[[nodiscard]] PuncturedSphere punctured(const complex::Triangulation& sphere, int vertex);

struct Ball {
  complex::Triangulation triangulation;  ///< in the labels of canon::triangulation_form()
  int boundary_vertices = 0;
  std::uint64_t automorphisms = 0;
};

/// All 3-balls with one vertex less than the spheres, up to isomorphism: one per sphere and orbit
/// of its vertices, for the cone over the boundary of a ball is a sphere and gives it back.
/// Ascending by number of tetrahedra, then lexicographically. As complete as the list of spheres.
[[nodiscard]] std::vector<Ball> balls(const Spheres& list, int threads = 1);

}  // namespace hexatlas::balls
