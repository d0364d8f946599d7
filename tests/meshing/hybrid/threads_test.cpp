// Claim. candidates() answers the same for any number of threads. Run under ThreadSanitizer too.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/meshing/hybrid/brute_force.hpp"

namespace hexatlas {
namespace {

bool are_equal(const hybrid::Candidates& a, const hybrid::Candidates& b) {
  const auto same = [](const auto& one, const auto& other) {
    return one.tetrahedra == other.tetrahedra &&
           std::equal(one.cells.begin(), one.cells.end(), other.cells.begin(), other.cells.end(),
                      [](const auto& x, const auto& y) {
                        return x.vertices == y.vertices && x.quality == y.quality &&
                               x.first == y.first && x.inner == y.inner && x.flat == y.flat;
                      });
  };
  return same(a.hexahedra, b.hexahedra) && same(a.prisms, b.prisms) && same(a.pyramids, b.pyramids);
}

TEST(CandidatesByThreads, AreTheSameForAnyNumberOfThreads) {
  std::mt19937_64 random(7);
  const mesh::TetMesh mesh = hybrid_tests::random_delaunay(900, 1U << 20U, random);
  const hybrid::TetGraph graph = hybrid_tests::graph_of(mesh);
  const hybrid::Candidates one = hybrid::candidates(graph, 0.2, 1);
  EXPECT_GT(one.hexahedra.cells.size(), 2000U);
  for (const int threads : {2, 3, 5})
    EXPECT_TRUE(are_equal(one, hybrid::candidates(graph, 0.2, threads))) << threads;
}

}  // namespace
}  // namespace hexatlas
