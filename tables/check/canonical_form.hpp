#pragma once
/// \file
/// Internal to the judge: forms that two triangulations share exactly if they are equivalent.
///
/// In a cell: the least list that all symmetries of the cell with all permutations of the interior
/// vertices yield, as the format says. Of balls: the least list over numberings of the vertices,
/// each of which is determined by the images 0, 1, 2, 3 of the vertices of one tetrahedron:
/// neighbours are visited breadth first, in the order of the numbers of the opposite vertices, and
/// a new vertex gets the next number. An isomorphism maps such numberings to such numberings, so
/// isomorphic balls have the same form, and equal forms give an isomorphism. The automorphisms are
/// as many as the permutations, or numberings, that yield the least list.

#include <cstdint>
#include <vector>

#include "tables/check/catalogue_read.hpp"
#include "tables/check/cell_laws.hpp"

namespace hexatlas::check {

struct CanonicalForm {
  Tetrahedra least;  ///< ascending
  std::uint64_t automorphisms = 0;
};

/// Symmetries combined with all permutations of the `interior` vertices from `boundary_vertices`
/// on. Requires interior <= 6. Memory: 16 bytes times symmetries * interior!.
[[nodiscard]] std::vector<VertexPermutation> with_interior_permutations(
    const std::vector<VertexPermutation>& symmetries, int boundary_vertices, int interior);

/// Cost: O(permutations * t log t).
[[nodiscard]] CanonicalForm form_in_cell(const Tetrahedra& tetrahedra,
                                         const std::vector<VertexPermutation>& permutations);

/// Requires that any two tetrahedra are joined by a chain of common triangles and no triangle lies
/// in three. Cost: O(24 t * t log t).
[[nodiscard]] CanonicalForm form_of_ball(const Tetrahedra& tetrahedra);

}  // namespace hexatlas::check
