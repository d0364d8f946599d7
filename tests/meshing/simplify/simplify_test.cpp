// Claim. What simplified() makes obeys the strict rule, is a ball, has the boundary of the mesh
// given and no more hexahedra; blown up meshes become small again; the same seed gives the same
// mesh. An edited mesh knows who meets whom. Oracle. complex::validate() and shelling_of() on whole
// meshes; the boundary quad by quad; the number of hexahedra before the mesh was blown up;
// neighbours found anew.
#include "meshing/simplify/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "meshing/simplify/small_meshes.hpp"
#include "tests/meshing/simplify/blow_up.hpp"

namespace {

using namespace hexatlas;
using complex::HexComplex;

/// A row of n cubes, the vertices of its boundary first.
HexComplex row(std::uint32_t n) {
  HexComplex mesh{4 * (n + 1), {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 4 * i;
    mesh.hexahedra.push_back({a, a + 1, a + 2, a + 3, a + 4, a + 5, a + 6, a + 7});
  }
  return mesh;
}

/// One of the meshes of a boundary with at most four hexahedra.
HexComplex small_mesh(const std::string& code) {
  simplify::SmallMeshes found =
      simplify::small_meshes(canon::decode(canon::from_text(code).value()).value(), 4, 100'000);
  EXPECT_TRUE(found.is_all) << code;
  EXPECT_FALSE(found.meshes.empty()) << code;
  return found.meshes.front();
}

void expect_simplified(const HexComplex& made, const HexComplex& given) {
  const auto fault = complex::validate(made);
  EXPECT_FALSE(fault) << fault->reason;
  EXPECT_TRUE(complex::shelling_of(made));
  EXPECT_TRUE(complex::has_boundary(made, complex::boundary_of(given)));
  EXPECT_LE(made.hexahedra.size(), given.hexahedra.size());
}

/// Meshes with the least numbers of hexahedra: those in the literature (tables/build/named.hpp).
std::vector<HexComplex> least_meshes() {
  std::vector<HexComplex> result{row(1), row(2), row(3)};
  for (const char* code : {"q1:088a2a5ddf7f", "q1:02228a5d777f", "q1:022222a575df7f"})
    result.push_back(small_mesh(code));
  return result;
}

TEST(Simplify, MakesBlownUpMeshesSmallAgain) {
  for (const HexComplex& least : least_meshes())
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const HexComplex given = support::blown_up(least, 40, seed, 5);
      ASSERT_GE(given.hexahedra.size(), 40U);
      ASSERT_FALSE(complex::validate(given));
      const auto made = simplify::simplified(given, nullptr, {.tries = 3000, .seed = seed});
      expect_simplified(made.mesh, least);
      EXPECT_EQ(made.mesh.hexahedra.size(), least.hexahedra.size()) << "seed " << seed;
      EXPECT_GT(made.exchanges, 0U);
    }
}

TEST(Simplify, IsTheSameForASeed) {
  const HexComplex given = support::blown_up(row(4), 60, 9, 20);
  const simplify::Options options{.tries = 300, .uphill = 4, .seed = 5};
  const auto first = simplify::simplified(given, nullptr, options);
  const auto second = simplify::simplified(given, nullptr, options);
  EXPECT_EQ(first.mesh.hexahedra, second.mesh.hexahedra);
  EXPECT_EQ(first.exchanges, second.exchanges);
  expect_simplified(first.mesh, given);
}

TEST(Simplify, LeavesAMeshAsItIsIfNoneIsSmaller) {
  for (const HexComplex& least : least_meshes()) {
    const auto made = simplify::simplified(least, nullptr, {.tries = 200});
    EXPECT_EQ(made.mesh.hexahedra, least.hexahedra);
  }
}

TEST(Simplify, SparesTheWholeMeshAndWideCavitiesIfAsked) {
  const HexComplex cube = support::blown_up(row(1), 7, 1, 0);
  simplify::Options options{.tries = 500, .max_cavity = 6, .whole = false};
  const auto without = simplify::simplified(cube, nullptr, options);
  EXPECT_EQ(without.mesh.hexahedra.size(), 7U);
  EXPECT_EQ(without.tries, options.tries);
  options.whole = true;
  const auto with = simplify::simplified(cube, nullptr, options);
  EXPECT_EQ(with.mesh.hexahedra.size(), 1U);
  EXPECT_LT(with.tries, options.tries);
}

TEST(Simplify, Stops) {
  const HexComplex given = support::blown_up(row(3), 30, 2, 5);
  std::atomic<bool> stop{true};
  const auto none = simplify::simplified(given, nullptr, {.stop = &stop});
  EXPECT_TRUE(none.is_stopped);
  EXPECT_EQ(none.tries, 0U);
  EXPECT_EQ(none.mesh.hexahedra, given.hexahedra);
  stop = false;
  const auto progress = [&stop](std::size_t tries, std::size_t) { stop = tries > 0; };
  const auto some = simplify::simplified(given, nullptr, {.stop = &stop, .progress = progress});
  EXPECT_TRUE(some.is_stopped);
  EXPECT_GT(some.tries, 0U);
  EXPECT_LT(some.tries, simplify::Options{}.tries);
  expect_simplified(some.mesh, given);
}

TEST(EditedMesh, KnowsWhoMeetsWhom) {
  core::Random random(3);
  simplify::KnownBalls known(nullptr);
  simplify::EditedMesh edited(support::blown_up(row(5), 60, 4, 5));
  simplify::Cavity cavity(edited, known);
  std::size_t made = 0;
  for (int step = 0; step < 300; ++step) {
    cavity.restart(random);
    for (std::size_t left = 1 + random.below(10); left > 0 && cavity.grow(random);) --left;
    const auto fits = cavity.fits(cavity.size() + 1);
    if (fits.empty()) {
      cavity.remember(random);
      continue;
    }
    edited.make(cavity.exchange_for(fits[random.below(fits.size())]));
    ++made;
    ASSERT_EQ(edited.neighbours(), flips::SubBall::neighbours_of(edited.mesh()));
    const simplify::EditedMesh anew(edited.mesh());
    for (std::size_t v = 0; v < edited.mesh().vertices; ++v) {
      auto cells = edited.cells_at()[v];
      std::sort(cells.begin(), cells.end());
      ASSERT_EQ(cells, anew.cells_at()[v]);
    }
    ASSERT_FALSE(complex::validate(complex::compacted(edited.mesh(), 24)));
  }
  EXPECT_GT(made, 30U);
}

TEST(SmallMeshes, SaysWhetherTheyAreAll) {
  // By counting facets and corners: the spindle has no mesh with at most 8 hexahedra.
  const auto spindle = canon::decode(canon::from_text("q1:088a577f").value()).value();
  const auto found = simplify::small_meshes(spindle, 8, 1'000'000);
  EXPECT_TRUE(found.is_all);
  EXPECT_TRUE(found.meshes.empty());
  EXPECT_FALSE(simplify::small_meshes(spindle, 8, 1).is_all);
}

}  // namespace
