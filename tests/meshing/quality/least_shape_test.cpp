// Claim. The bounds of the least scaled Jacobian over a whole cell enclose it and are close.
// Oracle. Dense samples in long double, refined around the least ones, from the partial derivatives
// as sums over corners; cells whose least value is known by hand.
#include "meshing/quality/least_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include "enum/core/errors.hpp"
#include "tests/realize/exact/placed_cells.hpp"

namespace {

using namespace hexatlas;
using mesh::Point;
using placed_cells::scaled;
using quality::Corners;
using quality::PrismCorners;
using quality::ShapeBounds;

using Long = long double;
using Vector = std::array<Long, 3>;
using Place = std::array<Long, 3>;

Long dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Long norm(const Vector& a) { return std::sqrt(dot(a, a)); }
Long determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
void add(Vector& sum, Long weight, const Point& p) {
  sum[0] += weight * p.x;
  sum[1] += weight * p.y;
  sum[2] += weight * p.z;
}

Long shape_at(const Corners& p, const Place& at) {
  std::array<Vector, 3> d{};
  for (std::size_t direction = 0; direction < 3; ++direction)
    for (std::size_t v = 0; v < 8; ++v) {
      Long weight = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const bool high = (v >> k & 1U) != 0;
        if (k == direction)
          weight *= high ? 1 : -1;
        else
          weight *= high ? at[k] : 1 - at[k];
      }
      add(d[direction], weight, p[v]);
    }
  const Long lengths = norm(d[0]) * norm(d[1]) * norm(d[2]);
  return lengths > 0 ? determinant(d[0], d[1], d[2]) / lengths : 0;
}

/// `at` is in the unit cube: the second coordinate is a fraction of what the first leaves.
Long shape_at(const PrismCorners& p, const Place& at) {
  const Long r = at[0];
  const Long s = (1 - r) * at[1];
  const Long t = at[2];
  const std::array<Long, 3> bary{1 - r - s, r, s};
  Vector u{};
  Vector v{};
  Vector w{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Long sign_u = i == 0 ? -1 : (i == 1 ? 1 : 0);
    const Long sign_v = i == 0 ? -1 : (i == 2 ? 1 : 0);
    add(u, sign_u * (1 - t), p[i]);
    add(u, sign_u * t, p[i + 3]);
    add(v, sign_v * (1 - t), p[i]);
    add(v, sign_v * t, p[i + 3]);
    add(w, -bary[i], p[i]);
    add(w, bary[i], p[i + 3]);
  }
  const Vector third{v[0] - u[0], v[1] - u[1], v[2] - u[2]};
  const Long a = norm(u);
  const Long b = norm(v);
  const Long c = norm(third);
  return 2 / (3 * std::sqrt(Long{3})) * determinant(u, v, w) / norm(w) *
         (1 / (a * b) + 1 / (b * c) + 1 / (a * c));
}

/// The least of 21^3 samples, then of 5^3 ever closer around it.
template <class Cell>
Long least_sample(const Cell& cell) {
  constexpr int kSteps = 20;
  Place best{};
  Long least = 2;
  const auto look = [&](const Place& at) {
    const Long value = shape_at(cell, at);
    if (value >= least) return;
    least = value;
    best = at;
  };
  for (int i = 0; i < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++i)
    look({Long(i % 21) / kSteps, Long(i / 21 % 21) / kSteps, Long(i / 441) / kSteps});
  for (Long step = Long{1} / (2 * kSteps); step > 1e-3L; step /= 2) {
    const Place centre = best;
    for (int i = 0; i < 125; ++i) {
      Place at = centre;
      int rest = i;
      for (Long& x : at) {
        x = std::clamp(x + (rest % 5 - 2) * step, Long{0}, Long{1});
        rest /= 5;
      }
      look(at);
    }
  }
  return least;
}

template <class Cell>
Cell moved(Cell cell, double shift, std::mt19937_64& random) {
  std::uniform_real_distribution<double> move(-shift, shift);
  for (Point& p : cell) p = {p.x + move(random), p.y + move(random), p.z + move(random)};
  return cell;
}

/// The upper half of the vertices turned around the middle axis of the cube.
template <class Cell>
Cell twisted(Cell cell, double angle) {
  for (std::size_t v = cell.size() / 2; v < cell.size(); ++v) {
    const double x = cell[v].x - 0.5;
    const double y = cell[v].y - 0.5;
    cell[v].x = 0.5 + std::cos(angle) * x - std::sin(angle) * y;
    cell[v].y = 0.5 + std::sin(angle) * x + std::cos(angle) * y;
  }
  return cell;
}

const Corners kCube{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
const PrismCorners kPrism{
    {{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, 0.9, 1}}};

void expect_bounds(const ShapeBounds& bounds, double least, double tolerance) {
  EXPECT_LE(bounds.low, bounds.high);
  EXPECT_LE(bounds.low, least + tolerance);
  EXPECT_GE(bounds.high, least - tolerance);
  EXPECT_LE(bounds.high - bounds.low, quality::kShapeGap);
}

TEST(LeastShape, HexahedraAgainstSamples) {
  std::mt19937_64 random(20261201);
  int negative = 0;
  int inside = 0;
  for (int trial = 0; trial < 250; ++trial) {
    const Corners cell = moved(twisted(kCube, trial % 4 * 0.6), 0.05 * (trial % 11), random);
    const double least = static_cast<double>(least_sample(cell));
    const ShapeBounds bounds = quality::least_scaled_jacobian(cell);
    ASSERT_LE(bounds.low, least + 1e-9) << trial;
    ASSERT_GE(bounds.low, least - quality::kShapeGap - 1e-3) << trial;
    ASSERT_LE(bounds.high - bounds.low, quality::kShapeGap) << trial;
    ASSERT_LE(bounds.low, bounds.high) << trial;
    ASSERT_LE(bounds.low, quality::scaled_jacobian(cell)) << trial;
    negative += least < 0 ? 1 : 0;
    inside += least < quality::scaled_jacobian(cell) - 0.01 ? 1 : 0;
  }
  EXPECT_GT(negative, 20);
  EXPECT_GT(inside, 30);
}

TEST(LeastShape, PrismsAgainstSamples) {
  std::mt19937_64 random(20261202);
  int valid = 0;
  int inside = 0;
  for (int trial = 0; trial < 250; ++trial) {
    const PrismCorners cell = moved(twisted(kPrism, trial % 4 * 0.6), 0.05 * (trial % 7), random);
    const double least = static_cast<double>(least_sample(cell));
    const ShapeBounds bounds = quality::least_scaled_jacobian(cell);
    ASSERT_LE(bounds.low, least + 1e-9) << trial;
    ASSERT_LE(bounds.low, bounds.high) << trial;
    if (quality::verdict_of_prism(cell).validity != quality::Validity::valid) {
      ASSERT_LE(bounds.high, 0) << trial;
      ASSERT_EQ(bounds.low, -1) << trial;
      continue;
    }
    ++valid;
    ASSERT_GE(bounds.low, least - quality::kShapeGap - 1e-3) << trial;
    ASSERT_LE(bounds.high - bounds.low, quality::kShapeGap) << trial;
    inside += least < quality::scaled_jacobian(cell) - 0.01 ? 1 : 0;
  }
  EXPECT_GT(valid, 80);
  EXPECT_GT(inside, 5);
}

TEST(LeastShape, KnownCells) {
  expect_bounds(quality::least_scaled_jacobian(kCube), 1, 1e-12);
  Corners box = kCube;
  for (Point& p : box) p = {2 * p.x + p.y, 3 * p.y, 5 * p.z};  // constant: 3 / sqrt 10
  expect_bounds(quality::least_scaled_jacobian(box), 3 / std::sqrt(10.0), 1e-12);
  Corners left = kCube;
  for (Point& p : left) p.x = -p.x;
  expect_bounds(quality::least_scaled_jacobian(left), -1, 1e-12);
  expect_bounds(quality::least_scaled_jacobian(Corners{}), 0, 0);
  Corners flat = kCube;
  for (Point& p : flat) p.z = 0;
  expect_bounds(quality::least_scaled_jacobian(flat), 0, 1e-12);
  Corners frustum = kCube;  // at all eight corners of the top and bottom the same angle
  for (std::size_t v = 4; v < 8; ++v)
    frustum[v] = {0.5 * frustum[v].x + 0.25, 0.5 * frustum[v].y + 0.25, 1};
  expect_bounds(quality::least_scaled_jacobian(frustum), 1 / std::sqrt(1.125), 1e-12);
  const PrismCorners half_cube{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 7}, {1, 0, 7}, {0, 1, 7}}};
  const double sines = (1 + std::sqrt(2.0)) * 2 / (3 * std::sqrt(3.0));
  expect_bounds(quality::least_scaled_jacobian(half_cube), sines, 1e-12);
  // Turned by half a turn: the Jacobian is (1 - 2t)^2.
  const ShapeBounds touching = quality::least_scaled_jacobian(
      PrismCorners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 1}, {0, -1, 1}}});
  EXPECT_EQ(touching.low, -1);
  EXPECT_EQ(touching.high, 0);
}

TEST(LeastShape, SameAtEveryScale) {
  std::mt19937_64 random(20261203);
  for (int trial = 0; trial < 40; ++trial) {
    const Corners cell = moved(kCube, 0.3, random);
    const PrismCorners prism = moved(kPrism, 0.2, random);
    const ShapeBounds bounds = quality::least_scaled_jacobian(cell);
    const ShapeBounds of_prism = quality::least_scaled_jacobian(prism);
    for (const int exponent : {-1000, -500, 500, 1023}) {
      const ShapeBounds other = quality::least_scaled_jacobian(scaled(cell, exponent));
      ASSERT_NEAR(other.low, bounds.low, 1e-12);
      ASSERT_NEAR(other.high, bounds.high, 1e-12);
      ASSERT_NEAR(quality::least_scaled_jacobian(scaled(prism, exponent)).low, of_prism.low, 1e-12);
    }
  }
}

/// Cells with edges of length zero end, with bounds that hold.
TEST(LeastShape, CollapsedEdgesEnd) {
  Corners cell = kCube;
  for (const std::size_t v : {7U, 5U, 4U}) {
    cell[v] = cell[6];
    const ShapeBounds bounds = quality::least_scaled_jacobian(cell);
    EXPECT_LE(bounds.low, 1e-12);
    EXPECT_LE(bounds.high, 1e-12);
    EXPECT_GE(bounds.low, -1);
  }
  PrismCorners wedge = kPrism;
  wedge[3] = wedge[0];
  EXPECT_LE(quality::least_scaled_jacobian(wedge).high, 0);
}

TEST(LeastShape, RefusesWhatIsNotFinite) {
  Corners cell = kCube;
  cell[3].z = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)quality::least_scaled_jacobian(cell), core::PreconditionViolated);
  PrismCorners prism = kPrism;
  prism[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)quality::least_scaled_jacobian(prism), core::PreconditionViolated);
}

}  // namespace
