// Claim. Points that do not span space have a dimension and no tetrahedra; coordinates may be any
// finite doubles; others are refused.
// Oracle. Points are made with the dimension in mind.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/delaunay/triangulation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Triangulation;

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();

void expect_flat(const Cloud& points, int dimension) {
  for (const int threads : {1, 3}) {
    Triangulation made(points, {threads, 7});
    EXPECT_EQ(made.dimension(), dimension);
    EXPECT_EQ(made.size(), 0U);
    EXPECT_TRUE(made.tetrahedra().empty());
    EXPECT_EQ(made.points(), points.size());
    EXPECT_THROW((void)made.located({0, 0, 0}), core::PreconditionViolated);
    EXPECT_THROW((void)made.star(0), core::PreconditionViolated);
    EXPECT_THROW((void)made.insert({0, 0, 0}), core::PreconditionViolated);
    EXPECT_THROW((void)made.refine([](const auto&) { return std::nullopt; }, 1),
                 core::PreconditionViolated);
  }
}

TEST(Degenerate, FewPoints) {
  expect_flat({}, -1);
  expect_flat({{1, 2, 3}}, 0);
  expect_flat({{1, 2, 3}, {1, 2, 4}}, 1);
  expect_flat({{1, 2, 3}, {1, 2, 4}, {2, 2, 3}}, 2);
  const Triangulation one(Cloud{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(one.dimension(), 3);
  EXPECT_EQ(one.tetrahedra(), (std::vector<Triangulation::Tetrahedron>{{0, 1, 2, 3}}));
  const Triangulation mirrored(Cloud{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(mirrored.tetrahedra(), (std::vector<Triangulation::Tetrahedron>{{0, 1, 3, 2}}));
}

TEST(Degenerate, PointsThatDoNotSpanSpace) {
  expect_flat(Cloud(1000, {0.1, -0.3, 1e9}), 0);
  expect_flat({{0.0, 0.0, 0.0}, {-0.0, 0.0, 0.0}, {0.0, -0.0, -0.0}}, 0);
  Cloud line, plane;
  for (int i = 0; i < 1000; ++i) {
    line.push_back({0.1 * i, 0.5 * (0.1 * i), 8 * (0.1 * i)});  // exact multiples
    plane.push_back({0.1 * (i % 31), 3.7 * (i / 31), 0.5 * (0.1 * (i % 31))});
  }
  expect_flat(line, 1);
  expect_flat(plane, 2);
  plane.push_back({0, 0, kTiny});
  EXPECT_EQ(Triangulation(plane).dimension(), 3);
  line.push_back({0, kTiny, 0});
  expect_flat(line, 2);
}

TEST(Degenerate, OneTetrahedronOfAnySize) {
  constexpr std::array kSizes{kTiny, 1e-320, 1e-300, 1.0, 1e300, kHuge};
  for (const double x : kSizes)
    for (const double y : kSizes)
      for (const double z : kSizes) {
        const Triangulation made(Cloud{{-x, 0, 0}, {x, 0, -0.0}, {0, y, 0}, {0, -0.0, z}});
        ASSERT_EQ(made.dimension(), 3);
        ASSERT_EQ(made.tetrahedra(), (std::vector<Triangulation::Tetrahedron>{{0, 1, 2, 3}}));
      }
}

/// Differences of coordinates overflow.
TEST(Degenerate, CornersOfTheLargestCube) {
  for (const double size : {kTiny, kHuge}) {
    Cloud cube, unit_cube;
    for (unsigned i = 0; i < 8; ++i) {
      const auto corner = [&](unsigned axis) { return (i >> axis & 1U) != 0 ? 1.0 : -1.0; };
      unit_cube.push_back({corner(0), corner(1), corner(2)});
      cube.push_back({size * corner(0), size * corner(1), size * corner(2)});
    }
    const Triangulation made(cube);
    EXPECT_EQ(made.tetrahedra(), Triangulation(unit_cube).tetrahedra());
    EXPECT_EQ(made.size(), 6U);
  }
}

TEST(Degenerate, NegativeZeroIsZero) {
  const Triangulation made(
      Cloud{{0.0, 0.0, 0.0}, {1, -0.0, 0}, {-0.0, 1, 0}, {0, 0, 1}, {-0.0, -0.0, -0.0}, {1, 0, 0}});
  EXPECT_EQ(made.duplicates(), 2U);
  EXPECT_EQ(made.size(), 1U);
}

TEST(Degenerate, RefusesWhatIsNotFinite) {
  const Cloud corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    for (const mesh::Point& p : Cloud{{bad, 0, 0}, {0, bad, 0}, {0, 0, bad}}) {
      Cloud points = corners;
      points.push_back(p);
      EXPECT_THROW(Triangulation{points}, core::PreconditionViolated);
      Triangulation made(corners);
      EXPECT_THROW((void)made.insert(p), core::PreconditionViolated);
      EXPECT_THROW((void)made.located(p), core::PreconditionViolated);
      const auto wish = [&](const auto&) { return std::optional(p); };
      EXPECT_THROW((void)made.refine(wish, 1), core::PreconditionViolated);
      EXPECT_EQ(made.points(), 4U);
      EXPECT_EQ(made.size(), 1U);
    }
  EXPECT_THROW((Triangulation(corners, {0})), core::PreconditionViolated);
  EXPECT_THROW((void)Triangulation(corners).star(4), core::PreconditionViolated);
}

}  // namespace
