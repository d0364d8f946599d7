#pragma once
/// \file
/// A mesh of chosen cells and tetrahedra in which cells meet in common faces.
///
/// Where a quad of a cell meets two triangles of tetrahedra, the tetrahedra around their common
/// edge, the diagonal, are replaced. If they are two, by the pyramid over the quad that they form.
/// Otherwise by a pyramid whose apex is a new point near the quad, and by the tetrahedra between
/// that point and the facets around; where it does not see a facet from inside, what lies beyond
/// is replaced, too. Facets between regions, and those on surfaces, stay. Of some places for the
/// point the one is taken with the best worst cell. If a cell or such a facet is in the way, or no
/// place makes all new cells valid, which is decided exactly, one of the cells is given up and
/// becomes tetrahedra again. What is left is conforming: in the end at least the tetrahedra. No
/// vertex is lost but those inside a cell.
///
/// Cost: linear in the mesh for each time that cells are given up.
/// Not promised: that fewest cells are given up; quality of the new cells.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/progress.hpp"
#include "meshing/hybrid/selection.hpp"
#include "meshing/hybrid/tet_graph.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::hybrid {

struct Combined {
  mesh::HybridMesh mesh;                      ///< points: those given, then new ones
  std::array<std::size_t, kShapes> chosen{};  ///< cells among the candidates, by shape
  std::size_t given_up = 0;                   ///< cells chosen that are not in the mesh
  std::size_t inserted_pyramids = 0;          ///< pyramids that are not among the candidates
  std::size_t new_points = 0;
  std::size_t quads_on_triangles = 0;  ///< without conforming: quads that meet two triangles
};

/// Requires: cells as selection() makes them. Progress is by cells, anew after some are given up.
[[nodiscard]] Combined conforming_mesh(const TetGraph& graph, const Candidates& candidates,
                                       std::span<const Cell> cells, const Progress& progress = {});

/// The cells, and the tetrahedra of none of them, as they are.
[[nodiscard]] Combined plain_mesh(const TetGraph& graph, const Candidates& candidates,
                                  std::span<const Cell> cells);

}  // namespace hexatlas::hybrid
