#pragma once
/// \file
/// Triangulations of a cell from the triangulated 3-spheres: the second road beside a search inside
/// the cell.
///
/// The cone over the boundary of a triangulation with b boundary and k interior vertices is a
/// 3-sphere with b + k + 1 vertices in which the apex has degree b. Conversely, a vertex of degree
/// b is removed with its open star from each such sphere, once per orbit; its link is compared with
/// the cell cut by diagonals, one choice of them per orbit under the symmetries of the cell; each
/// isomorphism gives a triangulation, which is kept if no tetrahedron has all four vertices on one
/// facet. Definition: docs/theory/triangulation-definition.txt.

#include <cstdint>
#include <vector>

#include "enum/balls/spheres.hpp"
#include "enum/complex/cell.hpp"

namespace hexatlas::balls {

struct CellClass {
  /// Least list of tetrahedra, compared lexicographically, over all members of the class.
  complex::Triangulation triangulation;
  std::uint64_t automorphisms = 0;
};

struct CellClasses {
  /// Ascending by number of tetrahedra, then by the list.
  std::vector<CellClass> classes;
  /// Sum of the class sizes: order of the group of the cell by automorphisms.
  std::uint64_t labelled = 0;
};

struct CellRules {
  bool boundary_tetrahedra = false;  ///< allow four vertices on one facet
};

/// The triangulations of the cell with spheres.vertices - 1 - cell.vertices interior vertices. As
/// complete as the list of spheres. Requires a number >= 0 of these and threads >= 1. The result
/// does not depend on the number of threads. Cost: for the hexahedron and the 10-vertex spheres
/// tens of seconds.
[[nodiscard]] CellClasses triangulations_from(const Spheres& list, const complex::Cell& cell,
                                              CellRules rules = {}, int threads = 1);

}  // namespace hexatlas::balls
