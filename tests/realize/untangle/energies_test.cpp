// Claim. The energies have the values of their definitions, and the gradient of a sum over the
// samples of a mesh is its derivative. Oracle. The definitions for matrices whose determinant is
// plain; central differences.
#include "realize/untangle/energies.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "realize/untangle/problem.hpp"
#include "tests/realize/untangle/grids.hpp"

namespace hexatlas::untangle {
namespace {

Eigen::Matrix3d random_matrix(support::Random& random) {
  Eigen::Matrix3d j;
  for (int i = 0; i < 9; ++i) j(i) = 2 * grids::fraction(random) - 1;
  return j;
}

template <class F>
void expect_derivative(const F& f, const Eigen::Matrix3d& j) {
  Eigen::Matrix3d derivative;
  Eigen::Matrix3d ignored;
  ASSERT_TRUE(std::isfinite(f(j, derivative)));
  for (int i = 0; i < 9; ++i) {
    const double h = 1e-6;
    Eigen::Matrix3d up = j;
    Eigen::Matrix3d down = j;
    up(i) += h;
    down(i) -= h;
    const double slope = (f(up, ignored) - f(down, ignored)) / (2 * h);
    EXPECT_NEAR(derivative(i), slope, 1e-5 * (1 + derivative.norm()));
  }
}

TEST(Energies, DerivativesAreThoseOfTheValues) {
  support::Random random(1);
  int positive = 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3d j = random_matrix(random);
    expect_derivative(Foldover{0.5, 2}, j);
    expect_derivative(ScaledExponential{-0.3, 3, 0.1, {0.5, 1}}, j);
    if (scaled_determinant(j) < 0.05) continue;
    expect_derivative(Foldover{0, 1}, j);
    expect_derivative(ScaledPower{0.2, 3, 0.01}, j);
    ++positive;
  }
  EXPECT_GT(positive, 30);
}

TEST(Energies, ValuesOfADiagonalMatrix) {
  const Eigen::Matrix3d j = Eigen::Vector3d(1, 2, 4).asDiagonal();
  Eigen::Matrix3d ignored;
  EXPECT_DOUBLE_EQ(scaled_determinant(j), 1);
  EXPECT_DOUBLE_EQ(scaled_determinant(-j), -1);
  EXPECT_DOUBLE_EQ(scaled_determinant(Eigen::Matrix3d::Zero()), 0);
  EXPECT_NEAR(Foldover({0, 2})(j, ignored), 21.0 / 4 + 2 * 65.0 / 8, 1e-12);
  // det = -8, epsilon = 6: chi = (-8 + 10) / 2 = 1
  EXPECT_NEAR(Foldover({6, 2})(-j, ignored), 21.0 + 2 * 65.0, 1e-9);
  EXPECT_NEAR(ScaledPower({0.5, 2, 0})(j, ignored), 0.25, 1e-12);
  EXPECT_TRUE(std::isinf(ScaledPower({0.5, 2, 0})(-j, ignored)));
  EXPECT_NEAR(ScaledExponential({0.5, 2, 0, {1, 1}})(-j, ignored), std::exp(3.0), 1e-9);
}

/// A spoiled grid; some cells looked at closely.
Problem spoiled(const grids::Mesh& mesh, support::Random& random) {
  Points points(3, static_cast<Eigen::Index>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    points.col(static_cast<Eigen::Index>(v)) << mesh.points[v].x + 0.3 * grids::fraction(random),
        mesh.points[v].y + 0.3 * grids::fraction(random),
        mesh.points[v].z + 0.3 * grids::fraction(random);
  Problem problem(points, mesh.hexahedra, mesh.is_free);
  for (std::size_t c = 0; c < problem.cells(); c += 3) problem.look_closely(c);
  return problem;
}

TEST(Energies, TheGradientOfASumIsItsDerivative) {
  support::Random random(2);
  grids::Mesh mesh = grids::cubes(4);
  for (std::size_t v = 0; v < mesh.is_free.size(); v += 5) mesh.is_free[v] ^= 1U;
  const Problem problem = spoiled(mesh, random);
  Variables x = problem.variables_of(
      problem.points_at(Variables::Zero(static_cast<Eigen::Index>(problem.variables()))));
  for (std::size_t i = 0; i < problem.free_points().size(); ++i) {
    const exact::Point3& p = mesh.points[problem.free_points()[i]];
    x.segment<3>(static_cast<Eigen::Index>(3 * i)) << p.x + 0.2 * grids::fraction(random), p.y, p.z;
  }
  const Foldover energy{0.1, 1};
  Variables gradient;
  Variables ignored;
  static_cast<void>(problem.sum(x, energy, 1, gradient));
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double h = 1e-6;
    Variables up = x;
    Variables down = x;
    up(i) += h;
    down(i) -= h;
    const double slope =
        (problem.sum(up, energy, 1, ignored) - problem.sum(down, energy, 1, ignored)) / (2 * h);
    ASSERT_NEAR(gradient(i), slope, 1e-4 * (1 + std::abs(slope)));
  }
}

TEST(Energies, SamplesAreTheJacobianMatrices) {
  support::Random random(3);
  grids::Mesh mesh = grids::cubes(1);
  Points points(3, 8);
  std::array<exact::Point3, 8> corners{};
  for (std::size_t v = 0; v < 8; ++v) {
    corners[v] = {grids::fraction(random), grids::fraction(random), grids::fraction(random)};
    points.col(static_cast<Eigen::Index>(v)) << corners[v].x, corners[v].y, corners[v].z;
  }
  for (std::size_t i = 0; i < kSamples; ++i) {
    const Eigen::Matrix3d j = Problem::matrix_at(points, mesh.hexahedra[0], i);
    const double expected =
        grids::jacobian(corners, 0.5 * static_cast<double>(i % 3),
                        0.5 * static_cast<double>(i / 3 % 3), 0.5 * static_cast<double>(i / 9));
    EXPECT_NEAR(j.col(0).dot(cofactors(j).col(0)), expected, 1e-12);
  }
}

}  // namespace
}  // namespace hexatlas::untangle
