// Claim. TetGraph accepts tetrahedral meshes and names the law that anything else breaks.
// Oracle. Meshes that are wrong in one way.
#include "meshing/hybrid/tet_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/meshing/hybrid/kuhn.hpp"

namespace hexatlas {
namespace {

using hybrid::TetGraph;

std::string fault_of(const mesh::TetMesh& mesh) {
  const auto graph = TetGraph::of({mesh.points, mesh.tetrahedra});
  const auto* fault = std::get_if<complex::BrokenLaw>(&graph);
  return fault == nullptr ? "" : fault->reason;
}

TEST(TetGraph, KnowsWhatIsAroundATetrahedron) {
  const mesh::TetMesh mesh = hybrid_tests::kuhn(2, 1);
  const auto graph = std::get<TetGraph>(TetGraph::of({mesh.points, mesh.tetrahedra}));
  std::size_t outside = 0;
  for (hybrid::TetIndex t = 0; t < graph.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) {
      const hybrid::TetIndex other = graph.across(t, i);
      if (other == TetGraph::kOutside) {
        ++outside;
        continue;
      }
      std::size_t common = 0;
      for (const auto v : graph[t])
        if (std::find(graph[other].begin(), graph[other].end(), v) != graph[other].end()) ++common;
      EXPECT_EQ(common, 3U);
      EXPECT_EQ(std::find(graph[other].begin(), graph[other].end(), graph[t][i]),
                graph[other].end());
    }
  EXPECT_EQ(outside, 48U);                // two for each of 24 squares
  EXPECT_EQ(graph.star(13).size(), 24U);  // the middle
  EXPECT_EQ(graph.neighbours(13).size(), 14U);
  EXPECT_EQ(graph.find(13, 0).has_value(), true);
  EXPECT_EQ(graph.find(0, 26).has_value(), false);
}

TEST(TetGraph, TurnsLeftHandedMeshesOver) {
  mesh::TetMesh mesh = hybrid_tests::kuhn(1, 1);
  for (auto& t : mesh.tetrahedra) std::swap(t[0], t[1]);
  EXPECT_EQ(fault_of(mesh), "");
  std::swap(mesh.tetrahedra[4][0], mesh.tetrahedra[4][1]);
  EXPECT_NE(fault_of(mesh).find("tetrahedron 0 is inverted"), std::string::npos) << fault_of(mesh);
}

TEST(TetGraph, NamesTheLawThatIsBroken) {
  const mesh::TetMesh good = hybrid_tests::kuhn(1, 1);
  EXPECT_EQ(fault_of(good), "");
  const auto expect = [](const mesh::TetMesh& mesh, const std::string& words) {
    EXPECT_NE(fault_of(mesh).find(words), std::string::npos) << fault_of(mesh);
  };
  expect({good.points, {}}, "no tetrahedra");
  mesh::TetMesh flat = good;
  flat.tetrahedra.push_back({0, 1, 2, 3});
  expect(flat, "tetrahedron 6 has volume zero");
  mesh::TetMesh twice = good;
  twice.tetrahedra.push_back(
      {good.tetrahedra[2][1], good.tetrahedra[2][2], good.tetrahedra[2][0], good.tetrahedra[2][3]});
  expect(twice, "tetrahedra 2 and 6 have the same vertices");
  mesh::TetMesh over = good;
  over.points.push_back({0.9, 0.8, 0.05});
  const auto& t = good.tetrahedra[0];
  over.tetrahedra.push_back({t[0], t[1], t[2], 8});
  if (fault_of(over).find("inverted") != std::string::npos)
    std::swap(over.tetrahedra.back()[0], over.tetrahedra.back()[1]);
  expect(over, "overlap");
}

}  // namespace
}  // namespace hexatlas
