// Claim. graph_form() may be called from several threads at once.
// Oracle. The answers of one thread.
#include <gtest/gtest.h>

#include <vector>

#include "enum/canon/nauty/hex_symmetry.hpp"
#include "enum/parallel/parallel_for.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;

TEST(HexSymmetryThreads, SeveralThreadsGetTheAnswersOfOne) {
  support::Random random(11);
  std::vector<complex::HexComplex> meshes;
  for (std::size_t i = 0; i < 200; ++i)
    meshes.push_back(
        support::mesh_of(support::cells_of(support::random_shelling(1 + i % 10, 30, random))));
  std::vector<canon::GraphForm> alone(meshes.size()), together(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) alone[i] = canon::graph_form(meshes[i]);
  parallel::parallel_for(4, meshes.size(),
                         [&](std::size_t i) { together[i] = canon::graph_form(meshes[i]); });
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    EXPECT_EQ(together[i].certificate, alone[i].certificate);
    EXPECT_EQ(together[i].automorphisms, alone[i].automorphisms);
  }
}

}  // namespace
