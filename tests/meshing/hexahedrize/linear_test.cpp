// Claim. mesh_by_sectors() gives every 3-connected quadrangulation with an even number n of quads a
// mesh that obeys the strict rule, has this boundary and at most 25 n hexahedra, each from a sector
// that it counts; the same again for the same input. Without regard to scars it would be wrong.
// Oracle. complex::validate() and the boundary quad by quad, on all small quadrangulations, random
// and regular ones; for some also the judge of tables/check, which shares no code and proves balls.
#include "meshing/hexahedrize/linear.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "tests/meshing/hexahedrize/judged.hpp"
#include "tests/meshing/hexahedrize/sectors.hpp"
#include "tests/meshing/hexahedrize/spheres.hpp"

namespace {

using namespace hexatlas;
using complex::QuadSphere;
using format::Sector;
using hexahedrize::LinearMesh;
using support::judged;
using support::small_spheres;

/// All sectors without scars, fewest hexahedra first.
std::vector<Sector> without_scars() {
  std::vector<Sector> result;
  for (const Sector& sector : support::sectors())
    if (sector.scars.empty()) result.push_back(sector);
  return result;
}

LinearMesh expect_meshed(const QuadSphere& sphere, const std::vector<Sector>& sectors) {
  EXPECT_EQ(complex::reason_against_filling(sphere), std::nullopt);
  LinearMesh made = hexahedrize::mesh_by_sectors(sphere, sectors);
  const std::size_t quads = sphere.quads.size();
  const auto fault = complex::validate(made.mesh);
  EXPECT_FALSE(fault) << quads << " quads: " << fault->reason;
  EXPECT_TRUE(complex::has_boundary(made.mesh, sphere.quads)) << quads << " quads";
  EXPECT_LE(made.mesh.hexahedra.size(), hexahedrize::hexahedra_bound(quads, sectors));
  EXPECT_EQ(hexahedrize::hexahedra_bound(quads, sectors), 25 * quads);
  EXPECT_EQ(made.used.size(), sectors.size());
  EXPECT_EQ(std::accumulate(made.used.begin(), made.used.end(), std::size_t{0}), quads / 2);
  std::size_t hexahedra = 0;
  for (std::size_t i = 0; i < sectors.size(); ++i)
    hexahedra += made.used[i] * sectors[i].mesh.hexahedra.size();
  EXPECT_EQ(made.mesh.hexahedra.size(), hexahedra);
  // The apex is a vertex of all sectors and none of the boundary.
  const auto apex = static_cast<complex::VertexId>(sphere.vertices());
  const auto at_apex = std::count_if(
      made.mesh.hexahedra.begin(), made.mesh.hexahedra.end(),
      [&](const auto& cell) { return std::find(cell.begin(), cell.end(), apex) != cell.end(); });
  EXPECT_GE(static_cast<std::size_t>(at_apex), quads / 2);
  return made;
}

void expect_accepted(const QuadSphere& sphere) {
  const check::Verdict verdict = judged(expect_meshed(sphere, support::sectors()).mesh, sphere);
  EXPECT_TRUE(verdict.accepted) << sphere.quads.size() << " quads: " << verdict.reason;
  EXPECT_FALSE(verdict.boundary_reversed);
}

TEST(Linear, MeshesAllSmallQuadrangulations) {
  // Their numbers: those of their duals, the 4-regular polyhedra, https://oeis.org/A007022.
  const std::vector<std::pair<int, std::size_t>> counts{
      {6, 1}, {8, 1}, {10, 3}, {12, 11}, {14, 58}};
  for (const auto& [quads, count] : counts) {
    const auto spheres = small_spheres(quads);
    EXPECT_EQ(spheres.size(), count);
    for (const QuadSphere& sphere : spheres) {
      expect_meshed(sphere, support::sectors());
      expect_meshed(sphere, without_scars());
      if (quads <= 10) expect_accepted(sphere);
    }
  }
}

TEST(Linear, MeshesTheMirrorImageAsWell) {
  for (QuadSphere sphere : small_spheres(12)) {
    for (auto& quad : sphere.quads) std::swap(quad[1], quad[3]);
    expect_meshed(sphere, support::sectors());
  }
}

TEST(Linear, MeshesRandomQuadrangulations) {
  for (const std::size_t inserted : {3U, 30U, 90U})
    for (std::uint64_t seed = 0; seed < 12; ++seed)
      expect_meshed(support::random_sphere(24 + 10 * seed, seed, inserted), support::sectors());
  expect_meshed(support::random_sphere(500, 1), support::sectors());
}

TEST(Linear, MeshesLargeRandomQuadrangulations) {
  expect_meshed(support::random_sphere(2000, 2, 10), support::sectors());
}

TEST(Linear, MeshesGridsAndVerticesOfHighDegree) {
  for (const complex::VertexId n : {2U, 3U, 4U, 5U, 8U})
    expect_meshed(support::grid_cube(n), support::sectors());
  for (const complex::VertexId k : {3U, 4U, 5U, 6U, 7U, 20U, 101U, 300U}) {
    expect_meshed(support::trapezohedron(k), support::sectors());
    if (k < 10) expect_meshed(support::trapezohedron(k), without_scars());
  }
}

TEST(Linear, IsAcceptedByTheJudge) {
  expect_accepted(support::grid_cube(3));
  expect_accepted(support::trapezohedron(20));
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    expect_accepted(support::random_sphere(24 + 10 * seed, seed));
}

TEST(Linear, GivesTheSameAgain) {
  const QuadSphere sphere = support::random_sphere(200, 5);
  const LinearMesh first = expect_meshed(sphere, support::sectors());
  const LinearMesh second = expect_meshed(sphere, support::sectors());
  EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
  EXPECT_EQ(first.mesh.hexahedra, second.mesh.hexahedra);
  EXPECT_EQ(first.used, second.used);
}

TEST(Linear, TakesTheSectorWithoutScarsIfItIsTheOnlyOne) {
  const auto sectors = without_scars();
  ASSERT_EQ(sectors.size(), 1U);
  const LinearMesh made = expect_meshed(support::grid_cube(3), sectors);
  EXPECT_EQ(made.mesh.hexahedra.size(), 27 * sectors[0].mesh.hexahedra.size());
}

// At a vertex of degree 3 corners 1 and 5 of the hexagon are opposite in the third quad.
TEST(Linear, LooksForScarsInQuadsOfTheBoundary) {
  std::vector<Sector> sectors = support::sectors();
  ASSERT_EQ(expect_meshed(support::grid_cube(1), sectors).used.front(), 1U);
  for (Sector& sector : sectors)
    if (!sector.scars.empty()) sector.scars.push_back({1, 5});
  const LinearMesh made = expect_meshed(support::grid_cube(1), sectors);
  EXPECT_EQ(made.used.back(), 3U);
}

// Sabotage. With the scars hidden the first sector is taken everywhere, and the strict rule breaks.
TEST(Linear, NeedsTheRuleOfScars) {
  std::vector<Sector> hidden = support::sectors();
  ASSERT_FALSE(hidden.front().scars.empty());
  for (Sector& sector : hidden) sector.scars.clear();
  std::size_t faults = 0;
  for (const int quads : {6, 8, 10, 12})
    for (const QuadSphere& sphere : small_spheres(quads)) {
      const LinearMesh made = hexahedrize::mesh_by_sectors(sphere, hidden);
      EXPECT_EQ(made.used.front(), sphere.quads.size() / 2);
      if (quads <= 8) {
        EXPECT_EQ(judged(made.mesh, sphere).accepted, !complex::validate(made.mesh));
      }
      if (!complex::validate(made.mesh)) continue;
      ++faults;
      // With the scars seen, another sector is taken somewhere, and the mesh is right.
      EXPECT_LT(expect_meshed(sphere, support::sectors()).used.front(), sphere.quads.size() / 2);
    }
  EXPECT_GT(faults, 0U);
}

}  // namespace
