// Claim. volume() is the integral of the Jacobian determinant of the cell's map.
// Oracle. Gauss quadrature of the determinant, exact for its degree: two points in each direction,
// three in those that a triangle or an apex shrinks to a point. And additivity: cells that share
// bilinear sides fill a cube, wherever their common vertices are.
#include "meshing/quality/volume.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace hexatlas;
using mesh::Point;
using quality::Corners;
using quality::PrismCorners;
using quality::PyramidCorners;
using quality::TetrahedronCorners;

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(double s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }

double determinant(const Point& a, const Point& b, const Point& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
         a.z * (b.x * c.y - b.y * c.x);
}

/// The map of the unit cube to the cell; a prism as a hexahedron with the edge of corners 2 and 3
/// shrunk, a pyramid with the top shrunk, a tetrahedron with both.
Point mapped(const std::array<Point, 8>& p, double r, double s, double t) {
  Point sum{};
  for (std::size_t v = 0; v < 8; ++v)
    sum = sum + ((v & 1U) != 0 ? r : 1 - r) * ((v & 2U) != 0 ? s : 1 - s) *
                    ((v & 4U) != 0 ? t : 1 - t) * p[v];
  return sum;
}

std::array<Point, 8> shrunk(const Corners& p) { return p; }
std::array<Point, 8> shrunk(const PrismCorners& p) {
  return {p[0], p[1], p[2], p[2], p[3], p[4], p[5], p[5]};
}
std::array<Point, 8> shrunk(const PyramidCorners& p) {
  return {p[0], p[1], p[3], p[2], p[4], p[4], p[4], p[4]};
}
std::array<Point, 8> shrunk(const TetrahedronCorners& p) {
  return {p[0], p[1], p[2], p[2], p[3], p[3], p[3], p[3]};
}

/// Differences replace derivatives: the map is linear in each variable.
template <class Cell>
double integral(const Cell& cell) {
  const std::array<Point, 8> p = shrunk(cell);
  const double node = std::sqrt(0.6) / 2;
  const std::array<double, 3> at{0.5 - node, 0.5, 0.5 + node};
  const std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        sum += weight[i] * weight[j] * weight[k] *
               determinant(mapped(p, 1, at[j], at[k]) - mapped(p, 0, at[j], at[k]),
                           mapped(p, at[i], 1, at[k]) - mapped(p, at[i], 0, at[k]),
                           mapped(p, at[i], at[j], 1) - mapped(p, at[i], at[j], 0));
  return sum;
}

template <class Cell>
void expect_the_integral(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 500; ++trial) {
    Cell cell{};
    for (Point& p : cell) p = {coordinate(random), coordinate(random), coordinate(random)};
    ASSERT_NEAR(quality::volume(cell), integral(cell), 1e-13);
  }
}

TEST(Volume, IsTheIntegralOfTheJacobian) {
  expect_the_integral<TetrahedronCorners>(1);
  expect_the_integral<PrismCorners>(2);
  expect_the_integral<PyramidCorners>(3);
  expect_the_integral<Corners>(4);
}

TEST(Volume, OfKnownCells) {
  const Corners cube{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
  EXPECT_EQ(quality::volume(cube), 1);
  EXPECT_EQ(quality::volume(PrismCorners{cube[0], cube[1], cube[2], cube[4], cube[5], cube[6]}),
            0.5);
  EXPECT_DOUBLE_EQ(quality::volume(PyramidCorners{cube[0], cube[1], cube[3], cube[2], cube[4]}),
                   1.0 / 3);
  EXPECT_DOUBLE_EQ(quality::volume(TetrahedronCorners{cube[0], cube[1], cube[2], cube[4]}),
                   1.0 / 6);
}

/// The inside vertex joins a hexahedron's six sides to six pyramids; two cubes glued along a bent
/// side are cut elsewhere. The sums do not depend on where the shared vertices are.
TEST(Volume, AddsUp) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> move(-0.4, 0.4);
  for (int trial = 0; trial < 100; ++trial) {
    Corners cell{};
    for (std::size_t v = 0; v < 8; ++v)
      cell[v] = {static_cast<double>(v & 1U) + move(random),
                 static_cast<double>(v >> 1U & 1U) + move(random),
                 static_cast<double>(v >> 2U) + move(random)};
    const Point centre{0.5 + move(random), 0.5 + move(random), 0.5 + move(random)};
    const std::vector<std::array<std::size_t, 4>> sides{{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                                        {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    double sum = 0;
    for (const auto& [a, b, c, d] : sides)
      sum += quality::volume(PyramidCorners{cell[a], cell[b], cell[c], cell[d], centre});
    ASSERT_NEAR(sum, quality::volume(cell), 1e-13);
  }
}

}  // namespace
