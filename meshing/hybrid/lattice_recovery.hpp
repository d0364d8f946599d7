#pragma once
/// \file
/// Private to the filling by lattices: edges and triangles of a surface are made ones of a
/// tetrahedral mesh that has its points.
///
/// Tetrahedra are exchanged for others with the same union: three at an edge for two at a facet,
/// two for three, and in general those at an edge for those of a triangulation of the polygon
/// around it, the one of best shape of those with the edge or triangle that is wanted (by dynamic
/// programming, as J. R. Shewchuk, "Two discrete optimization algorithms ...", 2002). Edges and
/// triangles of the surface are never removed, so what is recovered stays.

#include <optional>
#include <span>
#include <vector>

#include "enum/complex/broken_law.hpp"
#include "meshing/hybrid/lattice_surface.hpp"
#include "meshing/hybrid/lattice_tets.hpp"

namespace hexatlas::hybrid {

/// What could not be recovered.
struct Missing {
  std::vector<ClosedSurface::Edge> edges;
  std::vector<ClosedSurface::Triangle> triangles;
  /// An edge or triangle crosses another one, or goes through a vertex, by exact signs.
  std::optional<complex::BrokenLaw> crossing;
};

/// Exchanges diagonals of flat pairs that are no edges for those that are; the answer is how many.
std::size_t adopt_diagonals(ClosedSurface& surface, const FlippedTets& tets);

/// Recovers what exchanges of tetrahedra can. Vertex i of the surface is vertex i of the mesh.
[[nodiscard]] Missing recover(FlippedTets& tets, const ClosedSurface& surface);

}  // namespace hexatlas::hybrid
