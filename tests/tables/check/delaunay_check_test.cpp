// Claim. The judge accepts Delaunay triangulations, degenerate ones too, and names the law that a
// mesh breaks first; its signs are exact.
// Oracle. delaunay_oracle.hpp: brute force over all tetrahedra and points, with determinants of
// 128-bit integers and infinitesimals; for each law a mesh made by hand that breaks it.
#include "tables/check/delaunay_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tables/check/signs.hpp"
#include "tests/tables/check/delaunay_examples.hpp"
#include "tests/tables/check/delaunay_oracle.hpp"

namespace hexatlas::check {
namespace {

using oracle::Lattice;
using oracle::Points;

DelaunayLaw broken(const TetrahedralMesh& mesh) {
  const DelaunayVerdict verdict = check_delaunay(mesh, nullptr);
  EXPECT_EQ(verdict.accepted, verdict.broken == DelaunayLaw::kNone);
  EXPECT_EQ(verdict.accepted, verdict.reason.empty()) << verdict.reason;
  return verdict.broken;
}

/// The points scaled and moved, so that the other stages decide.
Point placed(const Lattice& p, double scale, double shift) {
  return {static_cast<double>(p[0]) * scale + shift, static_cast<double>(p[1]) * scale + shift,
          static_cast<double>(p[2]) * scale + shift};
}

TEST(Signs, AreThoseOfIntegersInEveryStage) {
  std::mt19937 random(1);
  SignCounts total;
  int zeros = 0;
  for (int round = 0; round < 3000; ++round) {
    Points points;
    const int range = round % 3 == 0 ? 3 : round % 3 == 1 ? 40 : 1000;
    for (int i = 0; i < 5; ++i)
      points.at.push_back({static_cast<int>(random() % range), static_cast<int>(random() % range),
                           static_cast<int>(random() % range)});
    const int side = points.orientation(0, 1, 2, 3);
    const int in = points.in_sphere(0, 1, 2, 3, 4);
    zeros += in == 0;
    // 2^-1074: subnormal numbers. 2^-358, 2^-215: products are. 2^500: products overflow.
    for (const auto& [scale, shift] : std::vector<std::pair<double, double>>{{1, 0},
                                                                             {0x1p-20, 0x1p30},
                                                                             {0x1p-1074, 0},
                                                                             {0x1p-358, 0},
                                                                             {0x1p-362, 0},
                                                                             {0x1p-368, 0},
                                                                             {0x1p-356, 0},
                                                                             {0x1p-215, 0},
                                                                             {0x1p-213, 0},
                                                                             {0x1p500, 0},
                                                                             {0x1p40, 1}}) {
      std::array<Point, 5> p{};
      for (std::size_t i = 0; i < 5; ++i) p[i] = placed(points.at[i], scale, shift);
      Signs signs;
      ASSERT_EQ(signs.orientation(p[0], p[1], p[2], p[3]), side);
      ASSERT_EQ(signs.in_sphere(p[0], p[1], p[2], p[3], p[4]), in);
      ASSERT_EQ(signs.in_sphere(p[1], p[0], p[2], p[3], p[4]), -in);
      total.by_double += signs.counts().by_double;
      total.by_words += signs.counts().by_words;
      total.by_integers += signs.counts().by_integers;
    }
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(total.by_double, 10000U);
  EXPECT_GT(total.by_words, 10000U);
}

int nonzero(std::mt19937& random) {
  constexpr std::array<int, 4> kValues = {-2, -1, 1, 2};
  return kValues[random() % 4];
}

/// Five points of a small lattice, one of them moved a little.
Points slightly_moved(std::mt19937& random) {
  Points points;
  for (int i = 0; i < 5; ++i)
    points.at.push_back({nonzero(random), nonzero(random), nonzero(random)});
  points.moved = random() % 5;
  points.axis = random() % 3;
  points.direction = random() % 2 == 0 ? 1 : -1;
  return points;
}

TEST(Signs, SeeOneUnitAmongLargeIntegers) {
  std::mt19937 random(5);
  for (int round = 0; round < 4000; ++round) {
    const Points points = slightly_moved(random);
    for (const std::int64_t unit : {(1LL << 22) - 3, (1LL << 30) - 35, (1LL << 35) - 31,
                                    (1LL << 38) - 45, (1LL << 52) - 47}) {
      std::array<Point, 5> p{};
      for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::int64_t value = points.at[i][axis] * unit;
          if (i == points.moved && axis == points.axis) value += points.direction;
          // The last unit: subnormal numbers among normal ones.
          p[i][axis] = static_cast<double>(value) * (round % 2 == 0 ? 1 : 0x1p-1074);
        }
      Signs signs;
      ASSERT_EQ(signs.orientation(p[0], p[1], p[2], p[3]), points.orientation(0, 1, 2, 3));
      ASSERT_EQ(signs.in_sphere(p[0], p[1], p[2], p[3], p[4]), points.in_sphere(0, 1, 2, 3, 4));
    }
  }
}

TEST(Signs, SeeOneUnitInTheLastPlace) {
  std::mt19937 random(2);
  SignCounts total;
  int decided_by_it = 0;
  for (int round = 0; round < 4000; ++round) {
    const Points points = slightly_moved(random);
    const bool zero = points.sphere({0, 1, 2, 3, 4}, 0) == 0;
    const std::vector<Point> p = oracle::mesh_of(points, {}).points;
    Signs signs;
    ASSERT_EQ(signs.orientation(p[0], p[1], p[2], p[3]), points.orientation(0, 1, 2, 3));
    ASSERT_EQ(signs.in_sphere(p[0], p[1], p[2], p[3], p[4]), points.in_sphere(0, 1, 2, 3, 4));
    decided_by_it += zero && points.in_sphere(0, 1, 2, 3, 4) != 0;
    total.by_integers += signs.counts().by_integers;
  }
  EXPECT_GT(decided_by_it, 200);
  EXPECT_GT(total.by_integers, 200U);
}

TEST(Signs, KnowTheSideOfACentroid) {
  std::mt19937 random(3);
  for (int round = 0; round < 1000; ++round) {
    Points points;
    for (int i = 0; i < 7; ++i)
      points.at.push_back({static_cast<int>(random() % 4), static_cast<int>(random() % 4),
                           static_cast<int>(random() % 4)});
    Points quadrupled = points;
    quadrupled.at.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 7; ++i) quadrupled.at[i][axis] *= 4;
      for (int i = 3; i < 7; ++i) quadrupled.at[7][axis] += points.at[i][axis];
    }
    const std::vector<Point> p = oracle::mesh_of(points, {}).points;
    Signs signs;
    EXPECT_EQ(signs.orientation_of_centroid(p[0], p[1], p[2], std::span<const Point, 4>(&p[3], 4)),
              quadrupled.orientation(0, 1, 2, 7));
  }
}

TEST(DelaunayCheck, AcceptsWhatBruteForceFinds) {
  std::mt19937 random(4);
  int accepted = 0;
  for (int round = 0; round < 60; ++round) {
    const Points points = examples::random_points(random, 5 + random() % 8, 100);
    const std::vector<Tetrahedron> cells = oracle::delaunay_of(points);
    if (cells.empty()) continue;
    ASSERT_TRUE(oracle::is_delaunay(points, cells, oracle::volume_of(points, cells)));
    const DelaunayVerdict verdict = check_delaunay(oracle::mesh_of(points, cells), nullptr);
    ASSERT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_EQ(verdict.tetrahedra, cells.size());
    EXPECT_EQ(verdict.cospherical, 0U);
    // Two facets more for each facet and tetrahedron; the boundary is a sphere.
    EXPECT_EQ(2 * verdict.facets, 4 * cells.size() + verdict.boundary_facets);
    EXPECT_EQ(verdict.boundary_facets, 2 * verdict.boundary_vertices - 4);
    ++accepted;
  }
  EXPECT_GT(accepted, 30);
}

TEST(DelaunayCheck, AcceptsLatticesHoweverTheyAreCut) {
  const DelaunayVerdict five =
      check_delaunay(oracle::mesh_of(examples::lattice(1), examples::kFive), nullptr);
  EXPECT_TRUE(five.accepted) << five.reason;
  EXPECT_EQ(five.cospherical, 4U);
  for (int n = 1; n <= 8; ++n) {
    const DelaunayVerdict verdict =
        check_delaunay(oracle::mesh_of(examples::lattice(n), examples::kuhn(n)), nullptr);
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_EQ(verdict.boundary_facets, 12U * n * n);
    EXPECT_EQ(verdict.signs.by_integers, 0U);
  }
}

TEST(DelaunayCheck, AllowsPointsWithTheCoordinatesOfAVertex) {
  TetrahedralMesh mesh = oracle::mesh_of(examples::lattice(1), examples::kFive);
  mesh.points.push_back({0, -0.0, 1});
  const DelaunayVerdict verdict = check_delaunay(mesh, nullptr);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  EXPECT_EQ(verdict.duplicates, 1U);
  mesh.points.push_back({0, 0.5, 1});
  EXPECT_EQ(broken(mesh), DelaunayLaw::kUnusedPoint);
}

TEST(DelaunayCheck, ComparesGivenPointsByValueAndPlace) {
  const TetrahedralMesh mesh = oracle::mesh_of(examples::lattice(1), examples::kFive);
  std::vector<Point> given = mesh.points;
  given[0][1] = -0.0;
  EXPECT_TRUE(check_delaunay(mesh, &given).accepted);
  std::swap(given[2], given[3]);
  EXPECT_EQ(check_delaunay(mesh, &given).broken, DelaunayLaw::kGivenPoints);
  std::swap(given[2], given[3]);
  given.push_back(given[0]);
  EXPECT_EQ(check_delaunay(mesh, &given).broken, DelaunayLaw::kGivenPoints);
  given.resize(7);
  EXPECT_EQ(check_delaunay(mesh, &given).broken, DelaunayLaw::kGivenPoints);
  given = mesh.points;
  given[7][2] = std::nextafter(given[7][2], 2);
  EXPECT_EQ(check_delaunay(mesh, &given).broken, DelaunayLaw::kGivenPoints);
}

TEST(DelaunayCheck, NamesTheLawThatIsBroken) {
  const TetrahedralMesh good = oracle::mesh_of(examples::lattice(2), examples::kuhn(2));
  const auto after = [&good](auto damage) {
    TetrahedralMesh mesh = good;
    damage(mesh.points, mesh.tetrahedra);
    return broken(mesh);
  };
  EXPECT_EQ(after([](auto&, auto& cells) { cells.clear(); }), DelaunayLaw::kCorners);
  EXPECT_EQ(after([](auto&, auto& cells) { cells[5][2] = 27; }), DelaunayLaw::kCorners);
  EXPECT_EQ(after([](auto&, auto& cells) { cells[5][2] = cells[5][0]; }), DelaunayLaw::kCorners);
  EXPECT_EQ(after([](auto&, auto& cells) { std::swap(cells[5][2], cells[5][0]); }),
            DelaunayLaw::kPositive);
  EXPECT_EQ(after([](auto&, auto& cells) { cells[0] = {0, 1, 2, 4}; }), DelaunayLaw::kPositive);
  EXPECT_EQ(after([](auto&, auto& cells) { cells.push_back(cells[24]); }),
            DelaunayLaw::kTwoTetrahedra);
  // At the hull a facet of one tetrahedron becomes one of two.
  EXPECT_EQ(after([](auto&, auto& cells) { cells.push_back(cells[3]); }),
            DelaunayLaw::kOppositeSides);
  // A tetrahedron that stays on the side of its neighbour.
  TetrahedralMesh same_side{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}},
                            {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  EXPECT_EQ(broken(same_side), DelaunayLaw::kOppositeSides);
  TetrahedralMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  for (int i = 0; i < 4; ++i) two.points.push_back({two.points[i][0] + 9, two.points[i][1], 0});
  two.points[7][2] = 1;
  EXPECT_EQ(broken(two), DelaunayLaw::kConnected);
  EXPECT_EQ(after([](auto&, auto& cells) { cells.erase(cells.begin()); }),
            DelaunayLaw::kConvexEdges);
  EXPECT_EQ(after([](auto& points, auto&) {
              points.push_back({0.5, 0.5, 0.5});
            }),
            DelaunayLaw::kUnusedPoint);
}

TEST(DelaunayCheck, RefusesBoundariesThatAreNoSphere) {
  // A ring of cubes around the middle column of 3 x 3 x 1: a torus.
  std::vector<Tetrahedron> cells = examples::kuhn(3);
  const Points points = examples::lattice(3);
  std::erase_if(cells, [&](const Tetrahedron& t) {
    Lattice least = points.at[t[0]];
    for (const std::uint32_t v : t)
      for (int axis = 0; axis < 3; ++axis) least[axis] = std::min(least[axis], points.at[v][axis]);
    return least[2] != 0 || (least[0] == 1 && least[1] == 1);
  });
  const DelaunayVerdict torus = check_delaunay(oracle::mesh_of(points, cells), nullptr);
  EXPECT_EQ(torus.broken, DelaunayLaw::kBoundarySurface);
  EXPECT_NE(torus.reason.find("Euler characteristic 0"), std::string::npos) << torus.reason;
  // Without two columns of 2 x 2 x 2, but for the top of one: two cubes meet in an edge.
  cells = examples::kuhn(2);
  cells.erase(cells.begin() + 12, cells.begin() + 18);
  cells.erase(cells.begin() + 6, cells.begin() + 12);
  const DelaunayVerdict pinched =
      check_delaunay(oracle::mesh_of(examples::lattice(2), cells), nullptr);
  EXPECT_EQ(pinched.broken, DelaunayLaw::kBoundarySurface);
  EXPECT_NE(pinched.reason.find("lies in 4 boundary facets"), std::string::npos) << pinched.reason;
}

/// All edges of the boundary are convex and all spheres locally empty: only what is covered how
/// often tells these from a triangulation.
TEST(DelaunayCheck, RefusesWhatIsWoundTwice) {
  std::vector<Lattice> ring = {{5, 0, 0}, {4, 3, 0}, {0, 5, 0}, {-5, 0, 0}, {0, -5, 0}};
  TetrahedralMesh mesh = examples::around_axis({ring[0], ring[1], ring[2], ring[3], ring[4]}, 3);
  EXPECT_TRUE(check_delaunay(mesh, nullptr).accepted) << check_delaunay(mesh, nullptr).reason;
  ring.insert(ring.end(), ring.begin(), ring.end());
  mesh = examples::around_axis({ring.begin(), ring.end()}, 3);
  EXPECT_EQ(broken(mesh), DelaunayLaw::kCoveredOnce);
}

TEST(DelaunayCheck, RefusesAPentagramWithItsBaseInATip) {
  const std::vector<Lattice> pentagram = {
      {100, 0, 0}, {-81, 59, 0}, {31, -95, 0}, {31, 95, 0}, {-81, -59, 0}};
  TetrahedralMesh mesh = examples::around_axis(pentagram, 40);
  EXPECT_NE(broken(mesh), DelaunayLaw::kNone);
  // A point near the tip, inside the first tetrahedron only, makes the least box there.
  const Tetrahedron t = mesh.tetrahedra[0];
  const auto tip = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({93, 2, 0});
  mesh.tetrahedra.erase(mesh.tetrahedra.begin());
  for (std::size_t i = 0; i < 4; ++i) {
    Tetrahedron part = t;
    part[i] = tip;
    mesh.tetrahedra.push_back(part);
  }
  EXPECT_EQ(broken(mesh), DelaunayLaw::kNoFolds);
}

TEST(DelaunayCheck, RefusesAFlipThatFillsASphere) {
  // Two tetrahedra at the triangle 0 1 2, or three around the edge 3 4.
  const auto mesh_with = [](double height, bool flipped) {
    TetrahedralMesh mesh{{{2, 0, 0}, {-1, 2, 0}, {-1, -2, 0}, {0, 0, -height}, {0, 0, height}}, {}};
    if (flipped) {
      mesh.tetrahedra = {{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}};
      for (auto& cell : mesh.tetrahedra) std::swap(cell[2], cell[3]);
    } else {
      mesh.tetrahedra = {{0, 1, 2, 4}, {1, 0, 2, 3}};
    }
    return mesh;
  };
  EXPECT_EQ(broken(mesh_with(4, false)), DelaunayLaw::kNone);
  EXPECT_EQ(broken(mesh_with(4, true)), DelaunayLaw::kEmptySpheres);
  EXPECT_EQ(broken(mesh_with(1, true)), DelaunayLaw::kNone);
  EXPECT_EQ(broken(mesh_with(1, false)), DelaunayLaw::kEmptySpheres);
}

/// A small base at the axis of a pentagram, which a side of another tetrahedron cuts in two: its
/// centroid is inside of that one, or on the side.
TEST(DelaunayCheck, RefusesAPentagramWithItsBaseAtTheAxis) {
  for (const bool on_side : {false, true}) {
    const std::vector<Lattice> pentagram = {
        {100, 0, 0}, {-81, 59, 0}, {31, -95, 0}, {31, on_side ? 93 : 95, 0}, {-81, -59, 0}};
    TetrahedralMesh mesh = examples::around_axis(pentagram, 40);
    mesh.points.push_back({6, 10, 0});
    mesh.points.push_back({-1, on_side ? 5.0 : 4.0, 0});
    // The first tetrahedron (5, 0, 1, 6) is cut by point 7, and (5, 7, 1, 6) of it by point 8.
    mesh.tetrahedra.erase(mesh.tetrahedra.begin());
    for (const Tetrahedron& part : std::vector<Tetrahedron>{{7, 0, 1, 6},
                                                            {5, 0, 7, 6},
                                                            {5, 0, 1, 7},
                                                            {8, 7, 1, 6},
                                                            {5, 8, 1, 6},
                                                            {5, 7, 8, 6},
                                                            {5, 7, 1, 8}})
      mesh.tetrahedra.push_back(part);
    EXPECT_EQ(broken(mesh), DelaunayLaw::kCoveredOnce);
  }
}

}  // namespace
}  // namespace hexatlas::check
