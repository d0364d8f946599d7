#pragma once
/// \file
/// All combinations of tetrahedra into hexahedra, prisms and pyramids.
///
/// Definition. A *candidate* is a cell whose vertices are vertices of the mesh, with an accepted
/// filling (filling.hpp), of quality above a threshold, and valid (meshing/quality). A filling has
/// 5 to 15 tetrahedra in a hexahedron, 3 to 6 in a prism, 2 in a pyramid (3 with a flat one);
/// interior vertices are possible. Quality is the least scaled Jacobian of the corners
/// (meshing/quality).
///
/// Source: J. Pellerin, A. Johnen, K. Verhetsel, J.-F. Remacle, "Identifying combinations of
/// tetrahedra into hexahedra: a vertex based strategy", CAD 105 (2018), arXiv 1705.02451. Where the
/// paper walks from vertex to vertex and tests each quad, this joins quads that were found before:
/// three at the least vertex, then, for each two of them, those at the next three vertices.
///
/// Each candidate is found once: its least vertex comes first, then the least neighbour of that in
/// the cell that the orientation allows. Order: by first vertex, then as found, the same for any
/// number of threads.
/// Cost: grows with the fourth power of the degrees; some microseconds per candidate.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/hybrid/progress.hpp"
#include "meshing/hybrid/tet_graph.hpp"

namespace hexatlas::hybrid {

template <std::size_t N>
struct Candidate {
  std::array<Index, N> vertices{};
  double quality = 0;
  std::size_t first = 0;   ///< of its tetrahedra in the list
  std::uint8_t inner = 0;  ///< tetrahedra inside, which come first
  std::uint8_t flat = 0;   ///< tetrahedra on its quads
};

template <std::size_t N>
struct CandidateList {
  std::vector<Candidate<N>> cells;
  std::vector<TetIndex> tetrahedra;

  [[nodiscard]] std::span<const TetIndex> inside(std::size_t i) const {
    return std::span(tetrahedra).subspan(cells[i].first, cells[i].inner);
  }
  [[nodiscard]] std::span<const TetIndex> all(std::size_t i) const {
    return std::span(tetrahedra)
        .subspan(cells[i].first, std::size_t{cells[i].inner} + cells[i].flat);
  }
};

struct Candidates {
  CandidateList<8> hexahedra;  ///< numbering of enum/cells/cube.hpp
  CandidateList<6> prisms;     ///< numbering of mesh::Prism
  CandidateList<5> pyramids;   ///< numbering of mesh::Pyramid
  /// Hexahedra left out because it is not known whether they are valid.
  std::size_t undecided = 0;
};

/// Requires 0 <= quality < 1, threads >= 1. Progress is by vertices.
[[nodiscard]] Candidates candidates(const TetGraph& graph, double quality, int threads = 1,
                                    const Progress& progress = {});

}  // namespace hexatlas::hybrid
