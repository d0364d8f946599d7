// Claim. The verdict of a prism is positive exactly if the Jacobian determinant of its map is
// positive on the closed prism, that of a pyramid exactly if it is wherever t < 1; double
// precision never contradicts the integers.
// Oracle. Rational numbers: the matrix of partial derivatives as sums over shape functions,
// evaluated at rational points. On a lateral edge the least value of the quadratic polynomial
// through three such values is at an end or where its derivative is zero; there the matrix is
// evaluated once more. No Bernstein coefficients, no differences of corners.
#include "realize/exact/prism.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "enum/core/errors.hpp"
#include "realize/exact/integers.hpp"
#include "tests/realize/exact/placed_cells.hpp"

namespace {

using namespace hexatlas;
using exact::JacobianVerdict;
using exact::Point3;
using exact::Positivity;
using exact::Prism;
using exact::Pyramid;
using Rational = mpq_class;
using placed_cells::moved;
using placed_cells::scaled;

/// The determinant of sum_v weights[v][d] p_v, d = 0, 1, 2 being the rows.
template <std::size_t kCount>
Rational determinant(const std::array<Point3, kCount>& points,
                     const std::array<std::array<Rational, 3>, kCount>& weights) {
  std::array<std::array<Rational, 3>, 3> m;
  for (std::size_t v = 0; v < kCount; ++v)
    for (std::size_t d = 0; d < 3; ++d) {
      m[d][0] += weights[v][d] * Rational(points[v].x);
      m[d][1] += weights[v][d] * Rational(points[v].y);
      m[d][2] += weights[v][d] * Rational(points[v].z);
    }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Rational jacobian(const Prism& p, const Rational& r, const Rational& s, const Rational& t) {
  const Rational q = 1 - r - s;
  const Rational b = 1 - t;
  return determinant<6>(
      p, {{{-b, -b, -q}, {b, 0, -r}, {0, b, -s}, {-t, -t, q}, {t, 0, r}, {0, t, s}}});
}

Rational jacobian(const Pyramid& p, const Rational& r, const Rational& s, const Rational& t) {
  const Rational b = 1 - t;
  const Rational r0 = 1 - r;
  const Rational s0 = 1 - s;
  return determinant<5>(p, {{{-s0 * b, -r0 * b, -r0 * s0},
                             {s0 * b, -r * b, -r * s0},
                             {s * b, r * b, -r * s},
                             {-s * b, r0 * b, -r0 * s},
                             {0, 0, 1}}});
}

struct Least {
  Rational corner, edge;
};

/// The least value at a corner, and on the lateral edges with their ends.
Least least_jacobian(const Prism& p) {
  Least least;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](const Rational& t) {
      return jacobian(p, i == 1 ? 1 : 0, i == 2 ? 1 : 0, t);
    };
    const Rational low = at(0);
    const Rational middle = at(Rational(1, 2));
    const Rational high = at(1);
    const Rational end = std::min(low, high);
    least.corner = i == 0 ? end : std::min(least.corner, end);
    least.edge = i == 0 ? end : std::min(least.edge, end);
    const Rational square = 2 * (low - 2 * middle + high);
    const Rational linear = 4 * middle - 3 * low - high;
    if (square <= 0) continue;
    const Rational flat = -linear / (2 * square);
    if (flat > 0 && flat < 1) least.edge = std::min(least.edge, at(flat));
  }
  return least;
}

const Prism kPrism{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
const Pyramid kPyramid{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}};

template <class Cell>
Cell mirrored(Cell cell) {
  for (Point3& p : cell) p.z = -p.z;
  return cell;
}

/// The verdict, after a look at the filter's.
template <class Cell>
JacobianVerdict verdict_of(const Cell& cell) {
  const JacobianVerdict verdict = exact::exact_jacobian_verdict(cell);
  const auto filtered = exact::filtered_jacobian_verdict(cell);
  if (filtered) {
    EXPECT_EQ(*filtered, verdict);
  }
  EXPECT_NE(verdict.positivity, Positivity::undecided);
  return verdict;
}

template <class Cell>
void expect_same_at_all_scales(const Cell& cell, const JacobianVerdict& verdict) {
  for (const int exponent : {-1074, -1000, -340, 330, 900, 1015})
    ASSERT_EQ(verdict_of(scaled(cell, exponent)), verdict);
}

TEST(PrismJacobian, AgreesWithTheLeastValue) {
  std::mt19937_64 random(20261123);
  int valid = 0;
  int refuted_inside = 0;
  int filtered = 0;
  for (int trial = 0; trial < 1600; ++trial) {
    const Prism prism = moved(kPrism, trial % 9, 1 + trial % 6, random);
    const Least least = least_jacobian(prism);
    const JacobianVerdict verdict = verdict_of(prism);
    ASSERT_EQ(verdict.positivity == Positivity::positive, least.edge > 0);
    ASSERT_EQ(verdict.corner_not_positive, least.corner <= 0);
    valid += least.edge > 0 ? 1 : 0;
    refuted_inside += least.edge <= 0 && least.corner > 0 ? 1 : 0;
    filtered += exact::filtered_jacobian_verdict(prism) ? 1 : 0;
    if (trial % 8 == 0) expect_same_at_all_scales(prism, verdict);
  }
  EXPECT_GT(valid, 160);
  EXPECT_GT(refuted_inside, 8);
  EXPECT_GT(filtered, 1200);
}

/// The least value is on a lateral edge: no point of the prism has a smaller one.
TEST(PrismJacobian, IsLeastOnLateralEdges) {
  std::mt19937_64 random(20261124);
  for (int trial = 0; trial < 100; ++trial) {
    const Prism prism = moved(kPrism, 6, 5, random);
    const Rational least = least_jacobian(prism).edge;
    for (int sample = 0; sample < 40; ++sample) {
      const auto number = [&] { return Rational(static_cast<long>(random() % 17), 16); };
      const Rational r = number();
      const Rational s = (1 - r) * number();
      ASSERT_GE(jacobian(prism, r, s, number()), least);
    }
  }
}

/// A right triangle of legs n, its copy above turned by half a turn less an angle of tangent e/n:
/// J has the coefficients n^2, -n^2, n^2 + e^2 on each lateral edge, hence the least value 0 if
/// e = 0, and about e^2/4 otherwise.
Prism twisted(double n, double e) {
  return {{{0, 0, 0}, {n, 0, 0}, {0, n, 0}, {0, 0, 1}, {-n, e, 1}, {-e, -n, 1}}};
}

TEST(PrismJacobian, TouchesZeroInside) {
  const JacobianVerdict touching{Positivity::not_positive, false};
  const JacobianVerdict positive{Positivity::positive, false};
  EXPECT_EQ(verdict_of(twisted(1, 0)), touching);
  EXPECT_FALSE(exact::filtered_jacobian_verdict(twisted(1, 0)).has_value());
  EXPECT_EQ(verdict_of(twisted(2, 1)), positive);
  EXPECT_TRUE(exact::filtered_jacobian_verdict(twisted(2, 1)).has_value());
  EXPECT_TRUE(exact::filtered_jacobian_verdict(twisted(1 << 18, 1)).has_value());
  for (const double n : {0x1p24, 0x1p26, 0x1p50}) {
    EXPECT_EQ(verdict_of(twisted(n, 0)), touching);
    EXPECT_EQ(verdict_of(twisted(n, 1)), positive);
    EXPECT_FALSE(exact::filtered_jacobian_verdict(twisted(n, 1)).has_value());
    EXPECT_EQ(verdict_of(twisted(n, -1)), positive);
    EXPECT_EQ(verdict_of(mirrored(twisted(n, 1))),
              (JacobianVerdict{Positivity::not_positive, true}));
  }
}

TEST(PrismJacobian, KnownShapes) {
  const JacobianVerdict positive{Positivity::positive, false};
  const JacobianVerdict inverted{Positivity::not_positive, true};
  EXPECT_EQ(exact::filtered_jacobian_verdict(kPrism), positive);
  EXPECT_EQ(exact::filtered_jacobian_verdict(mirrored(kPrism)), inverted);
  EXPECT_EQ(verdict_of(Prism{}), inverted);
  for (std::size_t i = 0; i < 3; ++i) {
    Prism wedge = kPrism;  // a lateral edge of length zero
    wedge[i + 3] = wedge[i];
    EXPECT_EQ(verdict_of(wedge), inverted);
  }
}

TEST(PyramidJacobian, AgreesWithRationalPoints) {
  std::mt19937_64 random(20261125);
  int valid = 0;
  int filtered = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Pyramid pyramid = moved(kPyramid, 2 * (trial % 6), 1 + trial % 5, random);
    bool positive = true;
    for (int place = 0; place < 50; ++place) {
      const Rational r(place % 5, 4);
      const Rational s(place / 5 % 5, 4);
      positive = positive && jacobian(pyramid, r, s, Rational(place / 25 * 2, 3)) > 0;
      ASSERT_EQ(jacobian(pyramid, r, s, 1), 0);
    }
    bool corners_positive = true;
    for (int corner = 0; corner < 4; ++corner)
      corners_positive = corners_positive && jacobian(pyramid, corner % 2, corner / 2, 0) > 0;
    const JacobianVerdict verdict = verdict_of(pyramid);
    ASSERT_EQ(verdict.positivity == Positivity::positive, positive);
    ASSERT_EQ(verdict.corner_not_positive, !corners_positive);
    valid += positive ? 1 : 0;
    filtered += exact::filtered_jacobian_verdict(pyramid) ? 1 : 0;
    if (trial % 8 == 0) expect_same_at_all_scales(pyramid, verdict);
  }
  EXPECT_GT(valid, 60);
  EXPECT_GT(filtered, 200);
}

TEST(PyramidJacobian, KnownShapes) {
  const JacobianVerdict positive{Positivity::positive, false};
  const JacobianVerdict inverted{Positivity::not_positive, true};
  EXPECT_EQ(exact::filtered_jacobian_verdict(kPyramid), positive);
  EXPECT_EQ(exact::filtered_jacobian_verdict(mirrored(kPyramid)), inverted);
  EXPECT_EQ(verdict_of(Pyramid{}), inverted);
  Pyramid dart = kPyramid;  // the base is flat and not convex
  dart[2] = {0.25, 0.25, 0};
  EXPECT_EQ(verdict_of(dart), inverted);
  dart[2] = {0.5, 0.5, 0};
  EXPECT_FALSE(exact::filtered_jacobian_verdict(dart).has_value());
  EXPECT_EQ(verdict_of(dart), inverted);
  dart[2] = {0.5, std::nextafter(0.5, 1), 0};
  EXPECT_EQ(verdict_of(dart), positive);
  for (std::size_t i = 0; i < 4; ++i) {
    Pyramid flat = kPyramid;
    flat[4] = flat[i];
    EXPECT_EQ(verdict_of(flat), inverted);
  }
}

TEST(PyramidJacobian, RefusesWhatIsNotFinite) {
  Prism prism = kPrism;
  prism[4].z = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)exact::filtered_jacobian_verdict(prism), core::PreconditionViolated);
  EXPECT_THROW((void)exact::exact_jacobian_verdict(prism), core::PreconditionViolated);
  Pyramid pyramid = kPyramid;
  pyramid[4].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)exact::filtered_jacobian_verdict(pyramid), core::PreconditionViolated);
  EXPECT_THROW((void)exact::exact_jacobian_verdict(pyramid), core::PreconditionViolated);
}

}  // namespace
