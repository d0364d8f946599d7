#pragma once
/// \file
/// Which candidates a mesh has.
///
/// Definition. Two cells are *compatible* if they have no tetrahedron in common, flat ones of a
/// common quad excepted; no edge of one is a diagonal of a quad of the other; and a common diagonal
/// of two quads is one of the same quad. Pairwise compatible cells meet in common faces: two quads
/// with three common vertices have a common diagonal, or an edge of one is a diagonal of the other;
/// and so it is for a triangle in a quad.
///
/// Method. Greedy by shape, then quality, as in the paper (candidates.hpp); then exchange: a cell
/// is taken out and what fits into its place is put in, or a cell is put in and those that it
/// conflicts with are taken out, as long as the weight grows. Weight is volume times a factor for
/// the shape. To choose the greatest weight is NP-hard (Meshkat, Talmor, IJNME 2000): no
/// optimum is promised. On Delaunay meshes of 10, 15, 20, 25, 30 random points the weight is in the
/// mean 1.00, 0.99, 0.96, 0.94, 0.94 of the greatest, at least 0.80; on lattices it is the greatest
/// (tests/cli/mesh_hybrid_optimum_test.py).
///
/// Deterministic. Cost: n log n in the candidates for the greedy part.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshing/hybrid/candidates.hpp"
#include "meshing/hybrid/progress.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

enum class Shape : std::uint8_t { hexahedron, prism, pyramid };
inline constexpr std::size_t kShapes = 3;

/// A candidate by its place in the list of its shape.
struct Cell {
  Shape shape = Shape::hexahedron;
  std::uint32_t index = 0;
  friend auto operator<=>(const Cell&, const Cell&) = default;
};

struct SelectionOptions {
  std::array<double, kShapes> factor{1, 0.5, 0.25};  ///< of a volume, by shape; 0: none of them
  int rounds = 2;                                    ///< of exchange; 0: greedy only
  Progress progress{};  ///< by candidates tried in exchange, of all in all rounds; may end early
};

/// The chosen cells, ascending; pairwise compatible, and none can be added.
[[nodiscard]] std::vector<Cell> selection(const TetGraph& graph, const Candidates& candidates,
                                          const SelectionOptions& options = {});

}  // namespace hexatlas::hybrid
