// Claim. Verdicts and shapes of tetrahedra, prisms and pyramids: 1 for the ideal shape, in [-1, 1],
// the same at every scale, positive exactly if the cell is not inverted.
// Oracle. Ideal shapes; the formulas of the header in long double, from lengths and determinants
// of whole edge vectors; for signs, integers of 128 bits.
#include "meshing/quality/cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/quality/edge.hpp"
#include "realize/exact/prism.hpp"
#include "tests/realize/exact/placed_cells.hpp"

namespace {

using namespace hexatlas;
using mesh::Point;
using placed_cells::scaled;
using quality::PrismCorners;
using quality::PyramidCorners;
using quality::TetrahedronCorners;
using quality::Validity;

__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;
using Long = long double;
using Vector = std::array<Long, 3>;

Vector edge(const Point& from, const Point& to) {
  return {Long{to.x} - from.x, Long{to.y} - from.y, Long{to.z} - from.z};
}

Long dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Long norm(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector combined(Long s, const Vector& a, Long t, const Vector& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}
Long determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Long shape(const TetrahedronCorners& p) {
  Long longest = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    Long product = 1;
    for (std::size_t w = 0; w < 4; ++w)
      if (w != v) product *= norm(edge(p[v], p[w]));
    longest = std::max(longest, product);
  }
  return std::sqrt(Long{2}) * determinant(edge(p[0], p[1]), edge(p[0], p[2]), edge(p[0], p[3])) /
         longest;
}

Long shape(const PrismCorners& p) {
  Long least = 1;
  for (std::size_t v = 0; v < 6; ++v) {
    const std::size_t floor = v / 3 * 3;
    const Vector u = edge(p[v], p[floor + (v + 1) % 3]);
    const Vector w = edge(p[v], p[floor + (v + 2) % 3]);
    const Vector up = edge(p[v % 3], p[v % 3 + 3]);
    const Long a = norm(u);
    const Long b = norm(w);
    const Long c = norm(combined(1, u, -1, w));
    const Long bracket = 1 / (a * b) + 1 / (b * c) + 1 / (a * c);
    least =
        std::min(least, 2 / (3 * std::sqrt(Long{3})) * determinant(u, w, up) * bracket / norm(up));
  }
  return least;
}

Long shape(const PyramidCorners& p) {
  Long least = 1;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector u = edge(p[v], p[(v + 1) % 4]);
    const Vector w = edge(p[v], p[(v + 3) % 4]);
    const Vector mean = combined(0.5L, u, 0.5L, w);
    const Vector apex = edge(p[v], p[4]);
    const Vector z = combined(std::sqrt(Long{2}), apex, -std::sqrt(Long{2}), mean);
    const Long d = determinant(u, w, z);
    const Long size = 3 * std::pow(std::abs(d), Long{2} / 3) / (dot(u, u) + dot(w, w) + dot(z, z));
    least = std::min(least, std::copysign(size, d));
  }
  return least;
}

const double kHalfRoot3 = std::sqrt(3.0) / 2;
const TetrahedronCorners kTetrahedron{{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}};
const PrismCorners kPrism{
    {{0, 0, 0}, {1, 0, 0}, {0.5, kHalfRoot3, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, kHalfRoot3, 1}}};
const PyramidCorners kPyramid{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, std::sqrt(0.5)}}};

template <class Cell, class Map>
Cell mapped(Cell cell, const Map& map) {
  for (Point& p : cell) p = map(p);
  return cell;
}

template <class Cell>
Cell mirrored(const Cell& cell) {
  return mapped(cell, [](const Point& p) { return Point{p.y, p.x, p.z}; });
}

template <class Cell>
Cell moved(const Cell& cell, double shift, std::mt19937_64& random) {
  std::uniform_real_distribution<double> move(-shift, shift);
  return mapped(cell, [&](const Point& p) {
    return Point{p.x + move(random), p.y + move(random), p.z + move(random)};
  });
}

template <class Cell>
void expect_ideal(const Cell& cell) {
  EXPECT_NEAR(quality::scaled_jacobian(cell), 1, 1e-14);
  EXPECT_NEAR(quality::scaled_jacobian(mirrored(cell)), -1, 1e-14);
  EXPECT_EQ(quality::scaled_jacobian(Cell{}), 0);
}

TEST(Cells, IdealShapes) {
  expect_ideal(kTetrahedron);
  expect_ideal(kPrism);
  expect_ideal(kPyramid);
  const auto stretched = mapped(kPrism, [](const Point& p) { return Point{p.x, p.y, 9 * p.z}; });
  EXPECT_NEAR(quality::scaled_jacobian(stretched), 1, 1e-14);
}

template <class Cell>
void expect_the_formula(const Cell& ideal, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  int negative = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Cell cell = moved(ideal, 0.25 * (trial % 12), random);
    const double value = quality::scaled_jacobian(cell);
    ASSERT_NEAR(value, static_cast<double>(shape(cell)), 1e-12);
    ASSERT_GE(value, -1);
    ASSERT_LE(value, 1);
    negative += value < 0 ? 1 : 0;
    for (const int exponent : {-960, -500, 500, 1022})
      ASSERT_NEAR(quality::scaled_jacobian(scaled(cell, exponent)), value, 1e-12);
  }
  EXPECT_GT(negative, 100);
}

TEST(Cells, Formulas) {
  expect_the_formula(kTetrahedron, 1);
  expect_the_formula(kPrism, 2);
  expect_the_formula(kPyramid, 3);
}

/// The corners of a cell: where, and the ends of three edges in right-handed order.
using CornerEdges = std::array<std::size_t, 4>;
std::vector<CornerEdges> corner_edges(const TetrahedronCorners& /*cell*/) { return {{0, 1, 2, 3}}; }
std::vector<CornerEdges> corner_edges(const PrismCorners& /*cell*/) {
  return {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}};
}
std::vector<CornerEdges> corner_edges(const quality::Corners& /*cell*/) {
  return {{0, 1, 2, 4}, {1, 3, 0, 5}, {2, 0, 3, 6}, {3, 2, 1, 7},
          {4, 6, 5, 0}, {5, 4, 7, 1}, {6, 7, 4, 2}, {7, 5, 6, 3}};
}
std::vector<CornerEdges> corner_edges(const PyramidCorners& /*cell*/) {
  return {{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}};
}

/// The sign of the least determinant at a corner, for integers whose determinants are below 2^127;
/// what they are computed from may wrap around.
template <class Cell>
int sign_of_least(const Cell& p) {
  int least = 1;
  for (const auto& [a, b, c, d] : corner_edges(p)) {
    std::array<std::array<UnsignedWide, 3>, 3> m{};
    const auto difference = [](double from, double to) {
      return static_cast<UnsignedWide>(Wide{std::llround(to)} - std::llround(from));
    };
    std::size_t row = 0;
    for (const std::size_t end : {b, c, d})
      m[row++] = {difference(p[a].x, p[end].x), difference(p[a].y, p[end].y),
                  difference(p[a].z, p[end].z)};
    const auto value = static_cast<Wide>(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
    least = std::min(least, value > 0 ? 1 : (value < 0 ? -1 : 0));
  }
  return least;
}

/// All edges near one plane and of length 2^48, heights of a few units: double precision sees no
/// sign. The heights are drawn so that corners have all signs.
template <class Cell>
void expect_exact_signs(const Cell& unit, auto verdict_of, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 3000; ++trial) {
    constexpr double kSide = 0x1p48;
    const Cell cell = mapped(unit, [&](const Point& p) {
      const double noise = static_cast<double>(random() % 3) - 1;
      return Point{kSide * (p.x + p.z), kSide * p.y,
                   kSide * (p.x + p.y + p.z) + trial % 4 * p.z + noise};
    });
    const int sign = sign_of_least(cell);
    const double value = quality::scaled_jacobian(cell);
    ASSERT_EQ((value > 0) - (value < 0), sign);
    ASSERT_LT(std::abs(value), 1e-3);
    ASSERT_EQ(verdict_of(cell).inverted, sign <= 0);
    for (const int exponent : {-1074, 900}) {
      const double other = quality::scaled_jacobian(scaled(cell, exponent));
      ASSERT_EQ((other > 0) - (other < 0), sign);
    }
    ++seen[static_cast<std::size_t>(sign + 1)];
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(Cells, SignsAreExact) {
  expect_exact_signs(TetrahedronCorners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                     quality::verdict_of_tetrahedron, 4);
  expect_exact_signs(
      PrismCorners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
      quality::verdict_of_prism, 5);
  expect_exact_signs(PyramidCorners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}},
                     quality::verdict_of_pyramid, 6);
  expect_exact_signs(
      quality::Corners{
          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}},
      quality::verdict_of_hexahedron, 7);
}

/// Edges of lengths that differ by 600 powers of ten: no measure is NaN or loses its sign.
TEST(Cells, EdgesOfVeryDifferentLengths) {
  constexpr double kTiny = 1e-300;
  constexpr double kHuge = 1e300;
  const auto expect_tiny_but_positive = [](double value) {
    EXPECT_GT(value, 0);
    EXPECT_LT(value, 1e-3);
  };
  expect_tiny_but_positive(quality::scaled_jacobian(
      TetrahedronCorners{{{0, 0, 0}, {kHuge, 0, 0}, {0, kTiny, 0}, {0, 0, 1}}}));
  expect_tiny_but_positive(quality::scaled_jacobian(
      PyramidCorners{{{0, 0, 0}, {kHuge, 0, 0}, {kHuge, kTiny, 0}, {0, kTiny, 0}, {0, 0, 1}}}));
  // A right angle, one angle of almost zero: the sines of the angles add up to 2.
  const PrismCorners narrow{
      {{0, 0, 0}, {kHuge, 0, 0}, {0, kTiny, 0}, {0, 0, 1}, {kHuge, 0, 1}, {0, kTiny, 1}}};
  EXPECT_NEAR(quality::scaled_jacobian(narrow), 4 / (3 * std::sqrt(3.0)), 1e-14);
  // All edges at corner 0 have the least length there is, and another corner is far away.
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const PyramidCorners far{
      {{0, 0, 0}, {kLeast, 0, 0}, {kHuge, kHuge, 0}, {0, kLeast, 0}, {0, 0, kLeast}}};
  const auto farther = mapped(far, [](const Point& p) {
    return Point{p.x > 1 ? 1e307 : p.x, p.y > 1 ? 1e307 : p.y, p.z};
  });
  for (const auto& cell : {far, farther}) EXPECT_GT(quality::scaled_jacobian(cell), 0);
  const auto high = mapped(kPrism, [](const Point& p) { return Point{p.x, p.y, kHuge * p.z}; });
  EXPECT_NEAR(quality::scaled_jacobian(high), 1, 1e-14);
}

TEST(Cells, VerdictsOfKnownShapes) {
  const auto expect = [](const quality::Verdict& verdict, Validity validity, bool inverted,
                         bool exact) {
    EXPECT_EQ(verdict.validity, validity);
    EXPECT_EQ(verdict.inverted, inverted);
    EXPECT_EQ(verdict.exact, exact);
  };
  expect(quality::verdict_of_tetrahedron(kTetrahedron), Validity::valid, false, false);
  expect(quality::verdict_of_tetrahedron(mirrored(kTetrahedron)), Validity::invalid, true, false);
  expect(quality::verdict_of_tetrahedron({}), Validity::invalid, true, true);
  expect(quality::verdict_of_prism(kPrism), Validity::valid, false, false);
  expect(quality::verdict_of_prism(mirrored(kPrism)), Validity::invalid, true, false);
  expect(quality::verdict_of_prism({}), Validity::invalid, true, true);
  expect(quality::verdict_of_pyramid(kPyramid), Validity::valid, false, false);
  expect(quality::verdict_of_pyramid(mirrored(kPyramid)), Validity::invalid, true, false);
  expect(quality::verdict_of_pyramid({}), Validity::invalid, true, true);
  // Turned by half a turn the corners are positive, and the Jacobian vanishes half way up.
  const PrismCorners twisted{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 1}, {0, -1, 1}}};
  expect(quality::verdict_of_prism(twisted), Validity::invalid, false, true);
}

/// At thresholds at all distances from the shape, of cells with heights of all sizes: the filter
/// may decide only what the integers would.
template <class Cell>
void expect_exact_thresholds(const Cell& ideal, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  int exceeding = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double height = std::ldexp(1.0, -(trial % 40));
    const Cell cell = mapped(moved(ideal, 0.2, random), [height](const Point& p) {
      return Point{p.x, p.y, p.x + height * p.z};
    });
    const double shape = quality::scaled_jacobian(cell);
    for (const int side : {-1, 1}) {
      const double q = shape + side * std::ldexp(1.0, -20 - static_cast<int>(random() % 40));
      if (!(q >= 0 && q <= 1)) continue;
      const bool expected = exact::corners_exceed(quality::exact_points(cell), q);
      ASSERT_EQ(quality::exceeds(cell, shape, q), expected) << trial;
      exceeding += expected ? 1 : 0;
    }
  }
  EXPECT_GT(exceeding, 300);
}

TEST(Cells, ThresholdsAreExact) {
  expect_exact_thresholds(kPrism, 8);
  expect_exact_thresholds(kPyramid, 9);
  // In integers the shapes of these are 1: what rounding makes of them has no say.
  const PrismCorners prism{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}}};
  const PyramidCorners pyramid{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
  const double below = std::nextafter(1, 0);
  for (const double shape : {1 - 0x1p-46, 1.0}) {
    EXPECT_TRUE(quality::exceeds(prism, shape, below));
    EXPECT_FALSE(quality::exceeds(prism, shape, 1));
    EXPECT_TRUE(quality::exceeds(pyramid, shape, below));
    EXPECT_FALSE(quality::exceeds(pyramid, shape, 1));
  }
}

TEST(Cells, RefuseWhatIsNotFinite) {
  PrismCorners prism = kPrism;
  prism[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)quality::verdict_of_prism(prism), core::PreconditionViolated);
  EXPECT_THROW((void)quality::scaled_jacobian(prism), core::PreconditionViolated);
  TetrahedronCorners tetrahedron = kTetrahedron;
  tetrahedron[2].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)quality::verdict_of_tetrahedron(tetrahedron), core::PreconditionViolated);
  EXPECT_THROW((void)quality::scaled_jacobian(tetrahedron), core::PreconditionViolated);
}

}  // namespace
