// Claim. Prisms and pyramids exceed a threshold exactly if the shape does at each corner; what
// equals it does not exceed it.
// Oracle. The formulas of the shapes corner by corner, in numbers with 2000 binary places after the
// point, with roots by GMP; nothing is squared. What differs by less than 2^-1900 is
// equal: of integers as small as here, a difference that is not zero is far greater.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "enum/core/errors.hpp"
#include "realize/exact/integers.hpp"
#include "realize/exact/prism.hpp"
#include "tests/realize/exact/placed_cells.hpp"

namespace {

using namespace hexatlas;
using exact::Integer;
using exact::Point3;
using exact::Prism;
using exact::Pyramid;
using Vector = std::array<Integer, 3>;
using placed_cells::moved;
using placed_cells::scaled;

constexpr unsigned long kPlaces = 2000;

Integer root(const Integer& x, unsigned long degree) {
  Integer result;
  const Integer shifted = x << degree * kPlaces;
  mpz_root(result.get_mpz_t(), shifted.get_mpz_t(), degree);
  return result;
}

Vector edge(const Point3& from, const Point3& to) {
  return {Integer(to.x) - Integer(from.x), Integer(to.y) - Integer(from.y),
          Integer(to.z) - Integer(from.z)};
}

Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Integer determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The shape at a corner as a quotient, both times 2^kPlaces.
struct Quotient {
  Integer above, below;
};

std::vector<Quotient> shapes(const Prism& p) {
  std::vector<Quotient> result;
  for (std::size_t v = 0; v < 6; ++v) {
    const std::size_t floor = v / 3 * 3;
    const Vector u = edge(p[v], p[floor + (v + 1) % 3]);
    const Vector w = edge(p[v], p[floor + (v + 2) % 3]);
    const Vector t = edge(p[floor + (v + 1) % 3], p[floor + (v + 2) % 3]);
    const Vector up = edge(p[v % 3], p[v % 3 + 3]);
    result.push_back(
        {2 * determinant(u, w, up) * (root(dot(u, u), 2) + root(dot(w, w), 2) + root(dot(t, t), 2)),
         root(27 * dot(u, u) * dot(w, w) * dot(t, t) * dot(up, up), 2)});
  }
  return result;
}

std::vector<Quotient> shapes(const Pyramid& p) {
  std::vector<Quotient> result;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector u = edge(p[v], p[(v + 1) % 4]);
    const Vector w = edge(p[v], p[(v + 3) % 4]);
    const Vector up = edge(p[v], p[4]);
    Vector raised;  // 2 z / sqrt 2
    for (std::size_t k = 0; k < 3; ++k) raised[k] = 2 * up[k] - u[k] - w[k];
    const Integer d = determinant(u, w, up);
    result.push_back({(d > 0 ? 6 : -6) * root(2 * d * d, 3),
                      (2 * dot(u, u) + 2 * dot(w, w) + dot(raised, raised)) << kPlaces});
  }
  return result;
}

/// -1, 0, 1 as the least shape is below, at or above the threshold.
template <class Cell>
int compared(const Cell& cell, double threshold) {
  int exponent = 0;
  const Integer mantissa(std::ldexp(std::frexp(threshold, &exponent), 53));
  int least = 1;
  for (const auto& [above, below] : shapes(cell)) {
    const Integer gap = (above << static_cast<unsigned long>(53 - exponent)) - mantissa * below;
    const bool is_small = abs(gap) < Integer(1) << 200;  // 2^-1800 of the scale
    least = std::min(least, is_small ? 0 : sgn(gap));
  }
  return least;
}

template <class Cell>
double least_shape(const Cell& cell) {
  double least = 1;
  for (const auto& [above, below] : shapes(cell)) {
    if (below == 0) return 0;
    least = std::min(least, mpq_class(above, below).get_d());
  }
  return least;
}

/// Equilateral, right, and half an octahedron: both of shape 1, in integers.
const Prism kPrism{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}}};
const Pyramid kPyramid{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};

/// At the doubles nearest to the shape, and at numbers far from it.
template <class Cell>
void expect_as_by_roots(const Cell& ideal, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::array<int, 2> seen{};
  for (int trial = 0; trial < 400; ++trial) {
    const Cell cell = moved(ideal, 1 << trial % 20, (1 << trial % 20) / (1 + trial % 5), random);
    const double shape = least_shape(cell);
    std::vector<double> thresholds{0, 1, 0.5, 0.3, std::ldexp(1.0, -1074)};
    if (shape > 0 && shape < 1) {
      const double below = std::nextafter(shape, 0);
      const double above = std::nextafter(shape, 1);
      for (const double q : {std::nextafter(below, 0), below, shape, above})
        thresholds.push_back(q);
    }
    for (const double q : thresholds) {
      const bool expected = compared(cell, q) > 0;
      ASSERT_EQ(exact::corners_exceed(cell, q), expected) << trial << ' ' << q;
      for (const int exponent : {-1074, 900})
        ASSERT_EQ(exact::corners_exceed(scaled(cell, exponent), q), expected) << trial << ' ' << q;
      ++seen[expected ? 1 : 0];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 500);
}

TEST(PrismThreshold, AsByRoots) { expect_as_by_roots(kPrism, 20261140); }
TEST(PyramidThreshold, AsByRoots) { expect_as_by_roots(kPyramid, 20261141); }

TEST(PrismThreshold, EqualityDoesNotExceed) {
  for (const int exponent : {-1074, 0, 900}) {
    EXPECT_FALSE(exact::corners_exceed(scaled(kPrism, exponent), 1));
    EXPECT_TRUE(exact::corners_exceed(scaled(kPrism, exponent), std::nextafter(1, 0)));
    EXPECT_FALSE(exact::corners_exceed(scaled(kPyramid, exponent), 1));
    EXPECT_TRUE(exact::corners_exceed(scaled(kPyramid, exponent), std::nextafter(1, 0)));
  }
  EXPECT_EQ(compared(kPrism, 1), 0);
  EXPECT_EQ(compared(kPyramid, 1), 0);
  Pyramid leaning = kPyramid;  // 3/4 at each corner
  leaning[4] = {1, 0, 1};
  EXPECT_EQ(compared(leaning, 0.75), 0);
  EXPECT_FALSE(exact::corners_exceed(leaning, 0.75));
  EXPECT_TRUE(exact::corners_exceed(leaning, std::nextafter(0.75, 0)));
}

/// Over an equilateral triangle, 13/15 at each corner: no double.
TEST(PrismThreshold, DoublesBesideARationalShape) {
  Prism leaning = kPrism;
  for (std::size_t i = 0; i < 3; ++i)
    leaning[i + 3] = {leaning[i].x + 1, leaning[i].y + 5, leaning[i].z + 7};
  double below = 13.0 / 15;
  if (mpq_class(below) > mpq_class(13, 15)) below = std::nextafter(below, 0);
  EXPECT_TRUE(exact::corners_exceed(leaning, below));
  EXPECT_FALSE(exact::corners_exceed(leaning, std::nextafter(below, 1)));
}

TEST(PrismThreshold, InvertedAndFlatCellsExceedNothing) {
  const auto mirrored = [](auto cell) {
    for (Point3& p : cell) p.z = -p.z;
    return cell;
  };
  const auto flat = [](auto cell) {
    for (Point3& p : cell) p.z = 0;
    return cell;
  };
  EXPECT_TRUE(exact::corners_exceed(kPrism, 0));
  EXPECT_TRUE(exact::corners_exceed(kPyramid, 0));
  EXPECT_FALSE(exact::corners_exceed(mirrored(kPrism), 0));
  EXPECT_FALSE(exact::corners_exceed(mirrored(kPyramid), 0));
  EXPECT_FALSE(exact::corners_exceed(flat(kPrism), 0));
  EXPECT_FALSE(exact::corners_exceed(flat(kPyramid), 0));
  EXPECT_FALSE(exact::corners_exceed(Prism{}, 0));
}

TEST(PrismThreshold, RefusesWhatItCannotJudge) {
  EXPECT_THROW((void)exact::corners_exceed(kPrism, -0.5), core::PreconditionViolated);
  EXPECT_THROW((void)exact::corners_exceed(kPyramid, 1.5), core::PreconditionViolated);
  Prism wrong = kPrism;
  wrong[5].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)exact::corners_exceed(wrong, 0.5), core::PreconditionViolated);
}

}  // namespace
