#pragma once
/// \file
/// Tetrahedra inside a closed surface, with interior points on a lattice.
///
/// What for. Tetrahedra of a lattice combine into cubes (candidates.hpp), those of points spread
/// otherwise into few hexahedra; compare T. C. Baudouin et al., "A frontal approach to hex-dominant
/// mesh generation", AMSES 1:8 (2014). A surface whose triangles are halves of squares of the same
/// size continues the lattice.
///
/// Method.
/// - Lattice: parallel to the greatest flat part of the surface and to the greatest at right angles
///   to it, or to the axes if there are no such parts of a twentieth of its area, or no greater
///   parts along them than along the axes; from one side of the bounding box in these directions to
///   the other, in as many steps as come nearest to the spacing; a plane of it goes through the
///   points of the surface that are on it up to rounding. Points nearer to the surface than the
///   clearance are left out.
/// - The Delaunay triangulation (meshing/delaunay) of the points, and of eight corners of a great
///   box around them. Its ties are cut in the same way in all cubes of a lattice that is parallel
///   to the axes.
/// - The surface is recovered: diagonals of flat pairs of triangles are exchanged for those that
///   the triangulation has; edges and triangles that it still lacks are made by exchanging the
///   tetrahedra at an edge or at a facet for others with the same union (J. R. Shewchuk, "Two
///   discrete optimization algorithms for the topological improvement of tetrahedral meshes",
///   2002); where this fails, points are added in the middle of edges, and all begins again.
/// - Tetrahedra outside are reached from the great box through an even number of triangles of the
///   surface, those inside through an odd number; these are kept.
///
/// What is exact. All tetrahedra are right-handed, they overlap nowhere, and their boundary is the
/// surface *as it ended up*: the input, with diagonals exchanged and with edges split at points
/// that are on them up to rounding. So it encloses the same volume up to rounding, and exactly the
/// same if no point was added and no diagonal was exchanged whose triangles are flat up to rounding
/// only. Distances, in double precision, decide which points the lattice has and nothing else.
///
/// Requires. Finite coordinates, indices below points.size(), threads >= 1, spacing >= 0 and
/// clearance > 0, both finite, flatness >= 0, rounds >= 1; else PreconditionViolated.
/// Refused, as a broken law: quads, no triangles, triangles without area, points at one place, an
/// edge that is not in two triangles, surfaces that meet themselves; coordinates above 2^240 and
/// surfaces smaller than 2^-240; lattices of more than 2^28
/// places; surfaces that could not be recovered, which have sharp angles or parts that are
/// much nearer to each other than their triangles are wide: finer triangles there are the remedy.
/// The orientation of the triangles is of no account. Several closed surfaces inside each other
/// are allowed: holes. Surfaces that touch at a point are allowed, at an edge not.
/// Cost. Some 20 microseconds per point and round, few rounds; a byte for each place of the lattice
/// in the bounding box. Not promised: shape of the tetrahedra.

#include <cstddef>
#include <variant>

#include "enum/complex/broken_law.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

struct LatticeOptions {
  /// Of the lattice; 0: the median over the triangles of the mean of the two shorter sides, which
  /// is the side of the squares if the triangles are halves of squares.
  double spacing = 0;
  /// Times the spacing. Hexahedra are most for 0.45 to 0.5, but near curved surfaces flatter.
  double clearance = 0.5;
  bool keeps_diagonals = false;  ///< exchange none: the input's triangles stay, or are split
  /// A pair of triangles is flat if it leaves a plane by at most this times its diagonal.
  double flatness = 1e-8;
  int rounds = 10;  ///< of adding points to the surface
  int threads = 1;
};

struct Filled {
  /// Points: those of triangles of the surface, in their order; points added on it; lattice points.
  /// Triangles: the surface as it ended up, counter-clockwise from outside. Colours: two triangles
  /// at an edge have the same one if their planes differ there by less than 40 degrees, or if a
  /// path of such edges leads around. One region.
  mesh::TetModel model;
  std::size_t added_on_surface = 0;
  std::size_t lattice_points = 0;
  std::size_t exchanged_diagonals = 0;
  double spacing = 0;  ///< that was used
};

/// In degrees: a greater angle between the planes of two triangles separates two colours.
inline constexpr double kSharpAngle = 40;

[[nodiscard]] std::variant<Filled, complex::BrokenLaw> fill_with_lattice(
    const mesh::FacetMesh& surface, const LatticeOptions& options = {});

}  // namespace hexatlas::hybrid
