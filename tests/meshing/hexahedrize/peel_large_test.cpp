// Claim. mesh_by_peeling() gives random quadrangulations of up to 2000 quads, with a table and
// without, meshes that are right, and few hexahedra per quad; more tries give fewer hexahedra.
// Oracle. The judge of tables/check, which shares no code.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/meshing/hexahedrize/peeled.hpp"

namespace {

using namespace hexatlas;
using support::expect_peeled;
using support::table;

TEST(PeelLarge, MeshesAllQuadrangulationsOfTwelveQuads) {
  for (const auto& sphere : support::small_spheres(12)) {
    EXPECT_EQ(expect_peeled(sphere, &table(), {.tries = 2}).account.rest, hexahedrize::Rest::table);
    expect_peeled(sphere, nullptr, {.tries = 2});
  }
}

TEST(PeelLarge, MeshesRandomQuadrangulations) {
  for (const std::size_t inserted : {3U, 30U, 90U})
    for (std::uint64_t seed = 0; seed < 10; ++seed)
      expect_peeled(support::random_sphere(24 + 64 * seed, seed, inserted), &table(), {.tries = 2});
}

// Of meshes so large the judge's searches find no shelling. It tries the order given first: what
// was taken off is one, backwards, so only the rest is to be proven a ball.
TEST(PeelLarge, MeshesThousandsOfQuads) {
  std::size_t proven = 0, unproven_else = 0;
  for (const std::size_t inserted : {3U, 10U, 30U}) {
    const auto sphere = support::random_sphere(2000, 2, inserted);
    const auto made = expect_peeled(sphere, &table(), {.tries = 1}, true);
    EXPECT_LT(made.mesh.hexahedra.size(), 4 * sphere.quads.size());
    EXPECT_EQ(made.account.rest, hexahedrize::Rest::table);
    proven += support::judged(made.mesh, sphere).ball_proof == "shelling" ? 1 : 0;
    auto reversed = made.mesh;
    std::reverse(reversed.hexahedra.begin(), reversed.hexahedra.end());
    const check::Verdict verdict = support::judged(reversed, sphere);
    EXPECT_TRUE(verdict.accepted || verdict.undecided) << verdict.reason;
    unproven_else += verdict.undecided ? 1 : 0;
    expect_peeled(sphere, nullptr, {.tries = 1, .layers = 1}, true);
  }
  EXPECT_GE(proven, 2U);
  EXPECT_GE(unproven_else, 1U);
  expect_peeled(support::grid_cube(18), &table(), {.tries = 1});
  expect_peeled(support::trapezohedron(1000), &table(), {.tries = 1});
}

TEST(PeelLarge, MoreTriesGiveFewerHexahedraOnTheWhole) {
  std::size_t few = 0, many = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const auto sphere = support::random_sphere(60, 50 + seed);
    few += expect_peeled(sphere, &table(), {.tries = 1}).mesh.hexahedra.size();
    many += expect_peeled(sphere, &table(), {.tries = 12}).mesh.hexahedra.size();
  }
  EXPECT_LT(many, few);
}

}  // namespace
