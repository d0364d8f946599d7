#pragma once
/// \file
/// A first place for free points. Private to realize/untangle.

#include <cstdint>
#include <vector>

#include "realize/untangle/problem.hpp"

namespace hexatlas::untangle {

/// Each free point of a hexahedron goes to the weighted mean of its neighbours along edges. The
/// weights are 1 for seed 0, else they lie between 1/8 and 8 and depend on seed and edge. Free
/// points that no path of free points connects with a fixed one stay where they are.
///
/// Method. A sparse Cholesky factorization up to 30,000 free points, above them conjugate gradients
/// with a limited number of iterations (Eigen). Deterministic.
void place_harmonically(Points& points, const std::vector<Cell>& cells,
                        const std::vector<std::uint8_t>& is_free, std::uint64_t seed);

/// Places that keep the spacing of the boundary: as above, an edge weighing the inverse of the mean
/// length of the edges of its sheet between fixed points. A *sheet* has all edges that lie opposite
/// each other in quads of hexahedra, one after the other; one without such an edge has the mean
/// length of all that there are. So a block is what its boundary is: if that is an affine image of
/// three series of steps, each free point is where these say.
void place_by_sheets(Points& points, const std::vector<Cell>& cells,
                     const std::vector<std::uint8_t>& is_free);

}  // namespace hexatlas::untangle
