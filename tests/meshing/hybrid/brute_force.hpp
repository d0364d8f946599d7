#pragma once
/// \file
/// The search for candidates against brute force.

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <variant>

#include "meshing/hybrid/candidates.hpp"
#include "tests/meshing/hybrid/kuhn.hpp"
#include "tests/meshing/hybrid/oracle.hpp"

namespace hexatlas::hybrid_tests {

inline hybrid::TetGraph graph_of(const mesh::TetMesh& mesh) {
  auto graph = hybrid::TetGraph::of({mesh.points, mesh.tetrahedra});
  if (const auto* fault = std::get_if<complex::BrokenLaw>(&graph)) ADD_FAILURE() << fault->reason;
  return std::get<hybrid::TetGraph>(std::move(graph));
}

template <std::size_t N>
Cells cells_of(const OracleShape& shape, const hybrid::CandidateList<N>& list) {
  Cells cells;
  for (std::size_t i = 0; i < list.cells.size(); ++i) {
    const auto inside = list.inside(i);
    const auto all = list.all(i);
    Found found{{inside.begin(), inside.end()}, {}};
    found.flat.insert(all.begin() + static_cast<std::ptrdiff_t>(inside.size()), all.end());
    const bool is_new = cells.emplace(key_of(shape, list.cells[i].vertices), found).second;
    EXPECT_TRUE(is_new) << "a cell is found twice";
  }
  return cells;
}

inline void expect_as_by_brute_force(const mesh::TetMesh& mesh, double quality) {
  const hybrid::TetGraph graph = graph_of(mesh);
  const hybrid::Candidates found = hybrid::candidates(graph, quality);
  Oracle oracle(mesh);
  const auto hexahedron = hexahedron_shape();
  const auto prism = prism_shape();
  const auto pyramid = pyramid_shape();
  EXPECT_EQ(cells_of(hexahedron, found.hexahedra), oracle.cells(hexahedron, quality));
  EXPECT_EQ(cells_of(prism, found.prisms), oracle.cells(prism, quality));
  EXPECT_EQ(cells_of(pyramid, found.pyramids), oracle.cells(pyramid, quality));
}

/// On Delaunay meshes of 9 to `most` points; in every other round many are in one plane or sphere.
inline void expect_as_by_brute_force_at_random(std::uint64_t seed, int rounds, std::size_t most) {
  std::mt19937_64 random(seed);
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    const std::size_t points = 9 + random() % (most - 8);
    const unsigned side = round % 2 == 0 ? 100 : 5;
    expect_as_by_brute_force(random_delaunay(points, side, random), round % 3 == 0 ? 0 : 0.05);
  }
}

}  // namespace hexatlas::hybrid_tests
