// Claim. koebe_polyhedron() is a convex polyhedron with the given quads as facets,
// counter-clockwise from outside, all of whose edges touch the unit sphere in points whose centre
// is the origin. Oracle. The definition, measured on the points alone: distances of lines from the
// origin, heights of all vertices over the plane of each quad. The cube's is known.
#include "realize/untangle/koebe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/quads/generate.hpp"

namespace hexatlas::untangle {
namespace {

using exact::Point3;

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Point3& a) { return std::sqrt(dot(a, a)); }

void expect_koebe(const complex::Quadrangulation& sphere) {
  const std::vector<Point3> points = koebe_polyhedron(sphere);
  ASSERT_EQ(points.size(), static_cast<std::size_t>(sphere.vertices()));
  Point3 sum;
  for (const auto& quad : sphere.list_of_quads()) {
    const Point3 normal =
        cross(minus(points[quad[2]], points[quad[0]]), minus(points[quad[3]], points[quad[1]]));
    ASSERT_GT(length(normal), 1e-3);
    for (int v = 0; v < sphere.vertices(); ++v) {
      const double height =
          dot(normal, minus(points[static_cast<std::size_t>(v)], points[quad[0]])) / length(normal);
      const bool is_corner = std::find(quad.begin(), quad.end(), v) != quad.end();
      if (is_corner) {
        ASSERT_NEAR(height, 0, 1e-9);
      } else {
        ASSERT_LT(height, -1e-6);
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3& a = points[quad[i]];
      const Point3 along = minus(points[quad[(i + 1) % 4]], a);
      EXPECT_NEAR(length(cross(a, along)) / length(along), 1, 1e-9);
      const double at = -dot(a, along) / dot(along, along);
      EXPECT_GT(at, 0);
      EXPECT_LT(at, 1);
      sum = {sum.x + a.x + at * along.x, sum.y + a.y + at * along.y, sum.z + a.z + at * along.z};
    }
  }
  EXPECT_LT(length(sum), 1e-9);
}

TEST(Koebe, ItIsOneForAllBoundariesOfSmallMeshes) {
  for (int quads = 6; quads <= 14; quads += 2)
    quads::generate(quads::Class::three_connected, quads,
                    [](const complex::Quadrangulation& sphere, int, int) { expect_koebe(sphere); });
}

TEST(Koebe, TheCubeIsTheCube) {
  for (const Point3& p : koebe_polyhedron(complex::Quadrangulation::cube()))
    EXPECT_NEAR(length(p), std::sqrt(1.5), 1e-9);  // edges at distance 1: side sqrt(2)
}

TEST(Koebe, OnlyThreeConnectedOnesAreTaken) {
  const std::vector<complex::QuadVertices> pillow{{0, 1, 2, 3}, {0, 3, 2, 1}};
  const auto sphere = complex::Quadrangulation::from_quads(pillow);
  ASSERT_TRUE(sphere.has_value());
  EXPECT_THROW(static_cast<void>(koebe_polyhedron(*sphere)), core::PreconditionViolated);
}

}  // namespace
}  // namespace hexatlas::untangle
