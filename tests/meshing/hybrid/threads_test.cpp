// Claim. candidates() answers the same for any number of threads, watched or not. Run under
// ThreadSanitizer too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

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

TEST(CandidatesByThreads, TellHowFarTheyAre) {
  std::mt19937_64 random(8);
  const mesh::TetMesh mesh = hybrid_tests::random_delaunay(1200, 1U << 20U, random);
  const hybrid::TetGraph graph = hybrid_tests::graph_of(mesh);
  for (const int threads : {1, 3}) {
    std::vector<std::size_t> told{0};
    const auto watched =
        hybrid::candidates(graph, 0.4, threads, [&](std::size_t done, std::size_t all) {
          EXPECT_EQ(all, 1200U);
          EXPECT_GT(done, told.back());
          told.push_back(done);
        });
    EXPECT_GT(told.size(), 3U);
    EXPECT_EQ(told.back(), 1200U);
    EXPECT_TRUE(are_equal(watched, hybrid::candidates(graph, 0.4)));
  }
}

}  // namespace
}  // namespace hexatlas
