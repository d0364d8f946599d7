// Claim. check_mesh accepts exactly the hexahedral balls under the strict rule, with the boundary
// that is given, and names the law that a bad mesh breaks.
// Oracle. Piles of lattice cubes, whose topology is seen by eye: boxes and L-shapes are balls, a
// ring is a solid torus, a box without its centre is a shell. Counts of faces of boxes by formula.
#include "tables/check/mesh_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/tables/check/example_meshes.hpp"

namespace hexatlas::check {
namespace {

using examples::box;
using examples::cubes;
using examples::Example;
using examples::Places;

Places without(Places places, const Places& removed) {
  for (const auto& place : removed) places.erase(place);
  return places;
}

void expect_broken(const Mesh& mesh, const Surface* surface, Law law, const std::string& words) {
  const Verdict verdict = check_mesh(mesh, surface);
  EXPECT_FALSE(verdict.accepted);
  EXPECT_EQ(static_cast<int>(verdict.broken), static_cast<int>(law)) << verdict.reason;
  EXPECT_NE(verdict.reason.find(words), std::string::npos) << verdict.reason;
}

/// Hexahedra given by labels, on as many points as they need.
Mesh labelled(std::vector<Hexahedron> cells) {
  Mesh mesh;
  std::uint32_t most = 0;
  for (const Hexahedron& cell : cells) {
    for (const std::uint32_t vertex : cell) most = std::max(most, vertex);
  }
  for (std::uint32_t v = 0; v <= most; ++v) mesh.points.push_back({double(v), 0, 0});
  mesh.hexahedra = std::move(cells);
  return mesh;
}

TEST(MeshCheck, AcceptsBoxesAndCountsTheirFaces) {
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{
           {1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {2, 2, 2}, {3, 3, 3}, {4, 3, 2}, {7, 1, 1}}) {
    const Example example = cubes(box(a, b, c));
    const Verdict verdict = check_mesh(example.mesh, &example.surface);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_TRUE(verdict.is_ball);
    EXPECT_EQ(verdict.ball_proof, "shelling");
    const auto count = [](int number) { return static_cast<std::uint64_t>(number); };
    EXPECT_EQ(verdict.hexahedra, count(a * b * c));
    EXPECT_EQ(verdict.vertices, count((a + 1) * (b + 1) * (c + 1)));
    EXPECT_EQ(verdict.interior_vertices, count((a - 1) * (b - 1) * (c - 1)));
    EXPECT_EQ(verdict.boundary_quads, count(2 * (a * b + b * c + c * a)));
    EXPECT_EQ(verdict.quads, count((a + 1) * b * c + a * (b + 1) * c + a * b * (c + 1)));
    EXPECT_EQ(verdict.edges,
              count(a * (b + 1) * (c + 1) + (a + 1) * b * (c + 1) + (a + 1) * (b + 1) * c));
    EXPECT_FALSE(verdict.boundary_reversed);
    EXPECT_FALSE(verdict.boundary_unoriented);
  }
}

TEST(MeshCheck, AcceptsBentPilesAndInteriorVerticesOfDegreeFour) {
  std::vector<Example> accepted = {
      cubes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
      cubes(without(box(3, 3, 1), {{2, 2, 0}, {1, 2, 0}})),
      cubes(without(box(2, 2, 2), {{1, 1, 1}})), examples::cube_in_cube()};
  for (const Example& example : accepted) {
    const Verdict verdict = check_mesh(example.mesh, &example.surface);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_TRUE(check_mesh(example.mesh, nullptr).accepted);
  }
}

TEST(MeshCheck, RefusesHexahedraThatAreNone) {
  Mesh mesh = cubes(box(1, 1, 1)).mesh;
  expect_broken({}, nullptr, Law::kCorners, "no hexahedra");
  mesh.hexahedra[0][3] = mesh.hexahedra[0][5];
  expect_broken(mesh, nullptr, Law::kCorners, "twice");
  mesh.hexahedra[0][3] = 8;
  expect_broken(mesh, nullptr, Law::kCorners, "not among the points");
  mesh.hexahedra[0][3] = std::numeric_limits<std::uint32_t>::max();
  expect_broken(mesh, nullptr, Law::kCorners, "not among the points");
}

TEST(MeshCheck, RefusesUnusedPointsUnlessTheSurfaceHasThem) {
  Example example = cubes(box(2, 1, 1));
  example.mesh.points.push_back({7, 7, 7});
  expect_broken(example.mesh, nullptr, Law::kUnusedPoint, "point 12");
  expect_broken(example.mesh, &example.surface, Law::kUnusedPoint, "point 12");
  example.surface.points.push_back({7, 7, 7});
  EXPECT_TRUE(check_mesh(example.mesh, &example.surface).accepted);
}

// Two cubes that share the bottom and a side: corners 0 to 5 of the first, in its own shape.
TEST(MeshCheck, RefusesTwoCubesWithTwoCommonQuads) {
  expect_broken(labelled({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 3, 2, 1, 4, 8, 9, 5}}), nullptr,
                Law::kStrictRule, "hexahedra 0 and 1 share 6 vertices");
}

TEST(MeshCheck, RefusesACommonDiagonal) {
  // The diagonal 0, 2 of a quad of the first is one of the second.
  expect_broken(labelled({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 8, 2, 9, 10, 11, 12, 13}}), nullptr,
                Law::kStrictRule, "not an edge of both: (0, 2)");
  // It is an edge of the second.
  expect_broken(labelled({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 2, 8, 9, 10, 11, 12, 13}}), nullptr,
                Law::kStrictRule, "not an edge of both: (0, 2)");
  // The diagonal 0, 6 of the first hexahedron is one of the second.
  expect_broken(labelled({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 8, 9, 10, 11, 12, 6, 13}}), nullptr,
                Law::kStrictRule, "not an edge of both: (0, 6)");
}

TEST(MeshCheck, RefusesAQuadInTwoCyclicOrders) {
  expect_broken(labelled({{0, 1, 2, 3, 4, 5, 6, 7}, {4, 6, 5, 7, 8, 9, 10, 11}}), nullptr,
                Law::kStrictRule, "two cyclic orders");
}

TEST(MeshCheck, RefusesThreeCommonVertices) {
  expect_broken(labelled({{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 8, 9, 10, 11, 12}}), nullptr,
                Law::kStrictRule, "share 3 vertices");
}

TEST(MeshCheck, RefusesAQuadInThreeCubes) {
  expect_broken(
      labelled(
          {{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}, {4, 5, 6, 7, 12, 13, 14, 15}}),
      nullptr, Law::kTwoHexahedra, "lies in 3 hexahedra");
}

TEST(MeshCheck, RefusesADuplicateCube) {
  Example example = cubes(box(2, 1, 1));
  example.mesh.hexahedra.push_back(example.mesh.hexahedra[0]);
  expect_broken(example.mesh, &example.surface, Law::kTwoHexahedra, "lies in 3 hexahedra");
  example = cubes(box(1, 1, 1));
  example.mesh.hexahedra.push_back(example.mesh.hexahedra[0]);
  expect_broken(example.mesh, &example.surface, Law::kStrictRule, "share 8 vertices");
}

TEST(MeshCheck, RefusesAnInvertedCube) {
  Example example = cubes(box(3, 2, 1));
  Hexahedron& cell = example.mesh.hexahedra[2];
  for (std::size_t i = 0; i < 4; ++i) std::swap(cell[i], cell[i + 4]);
  expect_broken(example.mesh, &example.surface, Law::kOrientation, "in the same direction");
}

TEST(MeshCheck, RefusesPermutedCorners) {
  Example example = cubes(box(2, 2, 1));
  std::swap(example.mesh.hexahedra[1][0], example.mesh.hexahedra[1][1]);
  expect_broken(example.mesh, &example.surface, Law::kStrictRule, "share");
}

TEST(MeshCheck, AcceptsAllInvertedAndSaysSo) {
  Example example = cubes(box(2, 2, 2));
  for (Hexahedron& cell : example.mesh.hexahedra) {
    for (std::size_t i = 0; i < 4; ++i) std::swap(cell[i], cell[i + 4]);
  }
  const Verdict verdict = check_mesh(example.mesh, &example.surface);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_TRUE(verdict.boundary_reversed);
}

TEST(MeshCheck, RefusesTwoComponents) {
  expect_broken(cubes({{0, 0, 0}, {2, 0, 0}}).mesh, nullptr, Law::kConnected, "2 components");
}

TEST(MeshCheck, RefusesPinches) {
  expect_broken(cubes({{0, 0, 0}, {1, 1, 1}}).mesh, nullptr, Law::kLink, "is not connected");
  expect_broken(cubes({{0, 0, 0}, {1, 1, 0}}).mesh, nullptr, Law::kLink, "is not connected");
  // Two holes that touch along an edge: at its ends the link is pinched.
  expect_broken(cubes(without(box(2, 2, 3), {{0, 0, 1}, {1, 1, 1}})).mesh, nullptr, Law::kLink,
                "pinched");
  // Without two opposite ones: the link is an annulus.
  expect_broken(cubes(without(box(2, 2, 2), {{0, 0, 0}, {1, 1, 1}})).mesh, nullptr, Law::kLink,
                "Euler characteristic is 0");
}

TEST(MeshCheck, RefusesAShellAndASolidTorus) {
  expect_broken(cubes(without(box(3, 3, 3), {{1, 1, 1}})).mesh, nullptr, Law::kBoundarySphere,
                "2 components");
  expect_broken(cubes(without(box(3, 3, 1), {{1, 1, 0}})).mesh, nullptr, Law::kBoundarySphere,
                "Euler characteristic 0");
}

TEST(MeshCheck, RefusesAnotherSurface) {
  const Example example = cubes(box(2, 2, 2));
  Mesh mesh = example.mesh;
  mesh.hexahedra.pop_back();  // the last corner is now in no hexahedron
  expect_broken(mesh, &example.surface, Law::kUnusedPoint, "in no hexahedron");
  const Example longer = cubes(box(3, 1, 1));
  expect_broken(cubes(box(2, 1, 1)).mesh, &longer.surface, Law::kSurfacePoints, "fewer points");

  Surface relabelled = example.surface;
  for (Quad& quad : relabelled.quads) {
    for (std::uint32_t& vertex : quad) vertex = vertex == 0 ? 1 : vertex == 1 ? 0 : vertex;
  }
  expect_broken(example.mesh, &relabelled, Law::kSurfaceQuads, "quad");

  Surface moved = example.surface;
  moved.points[5][1] = std::nextafter(moved.points[5][1], 9.0);
  expect_broken(example.mesh, &moved, Law::kSurfacePoints, "point 5");
  moved = example.surface;
  moved.points[0][0] = -0.0;
  expect_broken(example.mesh, &moved, Law::kSurfacePoints, "point 0");

  Surface missing = example.surface;
  missing.quads.pop_back();
  expect_broken(example.mesh, &missing, Law::kSurfaceQuads, "not among them");
  Surface extra = example.surface;
  extra.quads.push_back({0, 1, 2, 99});
  expect_broken(example.mesh, &extra, Law::kSurfaceQuads, "(0, 1, 2, 99)");
}

TEST(MeshCheck, ComparesUnorientedWhenTheSurfaceIsNotCoherent) {
  Example example = cubes(box(2, 1, 1));
  std::swap(example.surface.quads[3][1], example.surface.quads[3][3]);
  const Verdict verdict = check_mesh(example.mesh, &example.surface);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_TRUE(verdict.boundary_unoriented);
  std::swap(example.surface.quads[3][1], example.surface.quads[3][2]);
  expect_broken(example.mesh, &example.surface, Law::kSurfaceQuads, "quad");
}

TEST(MeshCheck, ComparesTheQuadsThatTheFileLists) {
  Example example = cubes(box(2, 1, 1));
  example.mesh.quads = example.surface.quads;
  std::swap(example.mesh.quads[0], example.mesh.quads[7]);
  EXPECT_TRUE(check_mesh(example.mesh, nullptr).accepted);
  example.mesh.quads.push_back(example.mesh.quads[0]);  // in two groups
  EXPECT_TRUE(check_mesh(example.mesh, nullptr).accepted);
  const Hexahedron& cell = example.mesh.hexahedra[0];
  example.mesh.quads = {{cell[1], cell[5], cell[6], cell[2]}};  // between the two
  EXPECT_TRUE(check_mesh(example.mesh, nullptr).accepted);
  example.mesh.quads = {example.surface.quads[3], {cell[0], cell[1], cell[6], cell[7]}};
  expect_broken(example.mesh, nullptr, Law::kListedQuads, "listed");
  example.mesh.quads = {{cell[0], cell[1], cell[2], cell[2]}};
  expect_broken(example.mesh, nullptr, Law::kListedQuads, "listed");
  example.mesh.quads = {{cell[0], cell[1], cell[2], 99}};
  expect_broken(example.mesh, nullptr, Law::kListedQuads, "listed");
}

TEST(MeshCheck, TellsWhatIsValidInSpace) {
  Example example = cubes(box(3, 3, 3));
  EXPECT_EQ(valid_in_space(example.mesh).valid, 27U);
  // The corner of one cube beyond the middle of the opposite side: that one only; then flat ones.
  Mesh bent = example.mesh;
  const Point old = bent.points[bent.hexahedra[0][0]];
  const Point far = bent.points[bent.hexahedra[0][6]];
  for (std::size_t i = 0; i < 3; ++i)
    bent.points[bent.hexahedra[0][0]][i] = 0.2 * old[i] + 0.8 * far[i];
  EXPECT_TRUE(check_mesh(bent, nullptr).accepted);
  EXPECT_EQ(valid_in_space(bent).valid, 26U);
  for (Point& p : bent.points) p[2] = 0;
  EXPECT_EQ(valid_in_space(bent).valid, 0U);
  EXPECT_EQ(valid_in_space(bent).undecided, 0U);
  for (Point& p : example.mesh.points) p[1] = -p[1];
  EXPECT_EQ(valid_in_space(example.mesh).valid, 0U);
}

// A pit along a trefoil in a pile of cubes, which ends one cube below the surface. The last cube
// has an edge from the bottom of the pit to the surface, a knotted spanning arc of a single edge;
// a ball with such an arc is not shellable (Furch; Lickorish, Europ. J. Combin. 12, 1991).
//
// The knot is the grid diagram with marks at rows i and i + 2 (mod 5) of column i: horizontal
// strands in layer 1, vertical ones above them in layer 3, one vertical one closed above the top.
Places pile_with_knotted_pit() {
  Places pit;
  const auto at = [](int i) { return 2 * i + 1; };
  for (int i = 0; i < 5; ++i) {
    const int low = std::min(i, (i + 2) % 5);
    const int high = std::max(i, (i + 2) % 5);
    for (int y = at(low); y <= at(high); ++y) {
      if (i > 0) pit.insert({at(i), y, 3});  // column i
    }
    for (const int row : {low, high}) pit.insert({{at(i), at(row), 2}, {at(i), at(row), 3}});
    const int other = (i + 3) % 5;  // row i has marks in columns i and i - 2
    for (int x = at(std::min(i, other)); x <= at(std::max(i, other)); ++x)
      pit.insert({x, at(i), 1});
  }
  pit.insert({1, 1, 4});  // open above one end of column 0, one cube short at the other
  return without(box(11, 11, 5), pit);
}

TEST(MeshCheck, NeverCallsAKnottedPileShellable) {
  const Example example = cubes(pile_with_knotted_pit());
  const Verdict verdict = check_mesh(example.mesh, &example.surface);
  EXPECT_NE(verdict.ball_proof, "shelling");
  if (!verdict.accepted) {
    EXPECT_TRUE(verdict.undecided) << verdict.reason;
    EXPECT_EQ(static_cast<int>(verdict.broken), static_cast<int>(Law::kBall));
    EXPECT_NE(verdict.reason.find("not shown to be a ball"), std::string::npos);
  }
  RecordProperty("proof", verdict.ball_proof.empty() ? "none" : verdict.ball_proof);
}

// The order in which hexahedra are listed is a hint at most: the verdict is that of the mesh.
TEST(MeshCheck, DoesNotDependOnTheOrderOfTheHexahedra) {
  for (const Places& places : {box(4, 3, 2), box(5, 5, 1), without(box(3, 3, 3), {{1, 1, 2}})}) {
    Example example = cubes(places);
    const Verdict listed = check_mesh(example.mesh, &example.surface);
    EXPECT_EQ(listed.ball_proof, "shelling");
    auto& cells = example.mesh.hexahedra;
    for (std::size_t turn = 0; turn < 8; ++turn) {
      // Every third one first, then the others, from another place each time: no shelling.
      std::rotate(cells.begin(), cells.begin() + 1, cells.end());
      auto scattered = example.mesh;
      std::stable_partition(scattered.hexahedra.begin(), scattered.hexahedra.end(),
                            [&](const Hexahedron& cell) { return (cell[0] + turn) % 3 == 0; });
      const Verdict verdict = check_mesh(scattered, &example.surface);
      EXPECT_TRUE(verdict.accepted) << verdict.reason;
      EXPECT_TRUE(verdict.is_ball);
      EXPECT_FALSE(verdict.ball_proof.empty()) << "a shelling or a collapse";
    }
  }
  for (const Places& places :
       {without(box(3, 3, 3), {{1, 1, 1}}), without(box(3, 3, 1), {{1, 1, 0}})}) {
    Example example = cubes(places);
    const Verdict listed = check_mesh(example.mesh, nullptr);
    EXPECT_FALSE(listed.accepted);
    std::reverse(example.mesh.hexahedra.begin(), example.mesh.hexahedra.end());
    const Verdict reversed = check_mesh(example.mesh, nullptr);
    EXPECT_FALSE(reversed.accepted);
    EXPECT_EQ(static_cast<int>(reversed.broken), static_cast<int>(listed.broken));
  }
}

// With one more cube taken away the pit is a knotted tunnel: no ball.
TEST(MeshCheck, RefusesAKnottedTunnel) {
  const Example example = cubes(without(pile_with_knotted_pit(), {{1, 5, 4}}));
  expect_broken(example.mesh, nullptr, Law::kBoundarySphere, "Euler characteristic 0");
}

}  // namespace
}  // namespace hexatlas::check
