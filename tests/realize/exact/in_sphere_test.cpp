// Claim. sign_of_in_sphere() is exact for any finite doubles, whichever arithmetic decides, the
// filter is never wrong, and sign_of_perturbed_in_sphere() is the sign after raising the points by
// small amounts in the order of their places.
// Oracle. The determinant of five rows by elimination over integers of any length.
#include "realize/exact/in_sphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "realize/exact/orientation.hpp"
#include "tests/realize/exact/in_sphere_oracle.hpp"
#include "tests/realize/exact/sign_trials.hpp"

namespace {

using namespace hexatlas;
using exact::Point3;
using exact::Sign;
using in_sphere_oracle::Tuple;
using sign_trials::Random;
using sign_trials::small_integer;
using sign_trials::Tally;
using sign_trials::unit;

Sign in_sphere(const Tuple& p) { return exact::sign_of_in_sphere(p[0], p[1], p[2], p[3], p[4]); }
/// With and without the filter.
Sign perturbed(const Tuple& p) {
  const Sign sign = exact::sign_of_perturbed_in_sphere(p[0], p[1], p[2], p[3], p[4]);
  EXPECT_EQ(exact::unfiltered_sign_of_perturbed_in_sphere(p[0], p[1], p[2], p[3], p[4]), sign);
  return sign;
}

void check(const Tuple& p, Tally& tally) {
  const auto expected = static_cast<Sign>(in_sphere_oracle::in_sphere(p));
  ASSERT_EQ(in_sphere(p), expected);
  add(expected, exact::filtered_sign_of_in_sphere(p[0], p[1], p[2], p[3], p[4]), tally);
}

bool are_different(const Tuple& p) {
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (p[i] == p[j]) return false;
  return true;
}

template <class Coordinate>
Tuple tuple_of(const Coordinate& coordinate) {
  Tuple p;
  for (Point3& point : p) {
    point.x = coordinate();
    point.y = coordinate();
    point.z = coordinate();
  }
  return p;
}

TEST(InSphere, OfTheUnitTetrahedron) {
  const Point3 o{0, 0, 0};
  const Point3 x{1, 0, 0};
  const Point3 y{0, 1, 0};
  const Point3 z{0, 0, 1};
  ASSERT_EQ(exact::sign_of_orientation(o, x, y, z), Sign::positive);
  EXPECT_EQ(exact::sign_of_in_sphere(o, x, y, z, {0.5, 0.5, 0.5}), Sign::positive);
  EXPECT_EQ(exact::sign_of_in_sphere(o, x, y, z, {1, 1, 1}), Sign::zero);
  EXPECT_EQ(exact::sign_of_in_sphere(o, x, y, z, {1, 1, 1.5}), Sign::negative);
  const double ulp = std::numeric_limits<double>::epsilon();
  EXPECT_EQ(exact::sign_of_in_sphere(o, x, y, z, {1, 1, 1 - ulp}), Sign::positive);
  EXPECT_EQ(exact::sign_of_in_sphere(o, x, y, z, {1, 1, 1 + ulp}), Sign::negative);
  EXPECT_EQ(exact::sign_of_in_sphere(x, o, y, z, {0.5, 0.5, 0.5}), Sign::negative);
}

TEST(InSphere, SmallGridsAtEveryScale) {
  Random random(20261201);
  Tally tally;
  for (const int exponent :
       {0,   -1074, -1060, -1000, -900, -700, -230, -216, -215, -214, -213, -190, -180,
        -50, 50,    179,   180,   181,  202,  203,  204,  300,  700,  960,  1018})
    for (int trial = 0; trial < 1500; ++trial) {
      const std::uint64_t size = 2 + random() % 6;
      check(tuple_of([&] { return std::ldexp(small_integer(random, size), exponent); }), tally);
    }
  EXPECT_GT(tally.zero, 5000);
  EXPECT_GT(tally.negative, 5000);
  EXPECT_GT(tally.positive, 5000);
}

/// Rounded multiples of 0.01 are no lattice: many near ties, and those ties that symmetry leaves.
TEST(InSphere, DecimalGrids) {
  Random random(20261202);
  Tally tally;
  for (int trial = 0; trial < 30000; ++trial) {
    const double offset = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 10 : -1e5;
    const std::uint64_t size = trial % 2 == 0 ? 3 : 3 + random() % 100;
    check(tuple_of([&] { return offset + 0.01 * small_integer(random, size); }), tally);
  }
  EXPECT_GT(tally.left_by_filter, 1000);
}

/// All integer points at one distance from the origin.
std::vector<std::array<int, 3>> lattice_sphere(int square) {
  std::vector<std::array<int, 3>> points;
  const int radius = static_cast<int>(std::sqrt(square)) + 1;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      for (int z = -radius; z <= radius; ++z)
        if (x * x + y * y + z * z == square) points.push_back({x, y, z});
  return points;
}

/// Cospherical by construction, then one coordinate moved by few units in the last place of 2^50.
TEST(InSphere, RationalPointsOfASphereAndTheirNeighbours) {
  Random random(20261203);
  const auto points = lattice_sphere(1001);
  ASSERT_GT(points.size(), 100U);
  Tally tally;
  for (int trial = 0; trial < 40000; ++trial) {
    const double scale = std::ldexp(1, static_cast<int>(random() % 44));
    const double offset = std::floor(std::ldexp(unit(random), 44));
    Tuple p;
    for (Point3& q : p) {
      const auto& r = points[random() % points.size()];
      q = {scale * r[0] + offset, scale * r[1] - offset, scale * r[2]};
    }
    p[random() % 5].z += small_integer(random, 3);
    if (trial % 2 == 0)
      for (Point3& q : p) q = {std::ldexp(q.x, -50), std::ldexp(q.y, -50), std::ldexp(q.z, -50)};
    check(p, tally);
  }
  EXPECT_GT(tally.zero, 5000);
  EXPECT_GT(tally.negative, 5000);
  EXPECT_GT(tally.positive, 5000);
  EXPECT_GT(tally.left_by_filter, 10000);
}

TEST(InSphere, RoundedPointsOfASphere) {
  Random random(20261204);
  Tally tally;
  for (int trial = 0; trial < 30000; ++trial) {
    Tuple p = tuple_of([&] { return 2 * unit(random) - 1; });
    for (Point3& q : p) {
      const double length = std::hypot(q.x, q.y, q.z);
      q = {q.x / length, q.y / length, q.z / length};
    }
    check(p, tally);
  }
  EXPECT_GT(tally.negative, 10000);
  EXPECT_GT(tally.positive, 10000);
  EXPECT_GT(tally.left_by_filter, 25000);
}

/// Exponents that differ by up to 2, 4, ..., 2^11: every width of integers decides some.
TEST(InSphere, MixedExponents) {
  Random random(20261205);
  Tally tally;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto spread = std::uint64_t{1} << (1U + random() % 11);
    const bool few_bits = random() % 2 == 0;
    check(tuple_of([&] {
            const double mantissa = few_bits ? small_integer(random, 5) : unit(random) - 0.5;
            return std::ldexp(
                mantissa, static_cast<int>(random() % spread) - static_cast<int>(spread / 2) - 2);
          }),
          tally);
  }
  EXPECT_GT(tally.negative, 5000);
  EXPECT_GT(tally.positive, 5000);
  EXPECT_GT(tally.left_by_filter, 5000);
}

/// Coordinates that share no short unit, with differences that do.
TEST(InSphere, FarFromTheOrigin) {
  Random random(20261206);
  Tally tally;
  for (const int bits : {20, 52, 54, 60, 64, 70, 90, 110, 126, 128, 140})
    for (int trial = 0; trial < 3000; ++trial) {
      Tuple p;
      for (Point3& q : p)
        q = {1 + std::ldexp(small_integer(random, 5), -52),
             std::ldexp(small_integer(random, 5), -52) - 1,
             std::ldexp(small_integer(random, 1U << 30U), -bits)};
      check(p, tally);
    }
  EXPECT_GT(tally.zero, 100);
  EXPECT_GT(tally.negative, 5000);
  EXPECT_GT(tally.positive, 5000);
}

TEST(InSphere, ExtremeMagnitudes) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = std::numeric_limits<double>::max();
  Random random(20261207);
  Tally tally;
  const std::array values{0.0,   -0.0,   least, -least, 1e-300,    -1e-300,  greatest,  -greatest,
                          1e300, -1e300, 1.0,   -1.0,   0x1p-1022, 0x1p1023, -0x1p1023, 0x1p-1021};
  for (int trial = 0; trial < 6000; ++trial)
    check(tuple_of([&] { return values[random() % values.size()]; }), tally);
  EXPECT_GT(tally.negative, 1000);
  EXPECT_GT(tally.positive, 1000);
}

TEST(InSphere, FilterDecidesWellShapedTuples) {
  Random random(20261208);
  Tally tally;
  for (int trial = 0; trial < 20000; ++trial) check(tuple_of([&] { return unit(random); }), tally);
  EXPECT_LT(tally.left_by_filter, 5);
}

void permute(const Tuple& p, const std::function<void(const Tuple&, bool)>& visit) {
  std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
  do {
    unsigned inversions = 0;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i] ? 1 : 0;
    visit({p[order[0]], p[order[1]], p[order[2]], p[order[3]], p[order[4]]}, inversions % 2 != 0);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(InSphere, ChangesSignUnderOddPermutations) {
  Random random(20261209);
  for (int trial = 0; trial < 500; ++trial) {
    const Tuple p = tuple_of([&] {
      return trial % 4 == 0   ? unit(random)
             : trial % 4 == 1 ? 0.01 * small_integer(random, 3)
             : trial % 4 == 2 ? std::ldexp(small_integer(random, 3), -400)
                              : std::ldexp(unit(random), static_cast<int>(random() % 300));
    });
    const Sign sign = in_sphere(p);
    const bool has_tie_rule = are_different(p);
    const Sign with_ties = has_tie_rule ? perturbed(p) : Sign::zero;
    permute(p, [&](const Tuple& q, bool is_odd) {
      ASSERT_EQ(in_sphere(q), is_odd ? exact::opposite(sign) : sign);
      if (has_tie_rule) {
        ASSERT_EQ(perturbed(q), is_odd ? exact::opposite(with_ties) : with_ties);
      }
    });
  }
}

TEST(InSphere, RefusesCoordinatesThatAreNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {infinity, -infinity, nan})
    for (std::size_t i = 0; i < 15; ++i) {
      Tuple p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}};
      Point3& q = p[i / 3];
      (i % 3 == 0 ? q.x : i % 3 == 1 ? q.y : q.z) = bad;
      EXPECT_THROW((void)in_sphere(p), core::PreconditionViolated);
      EXPECT_THROW((void)perturbed(p), core::PreconditionViolated);
      EXPECT_THROW((void)exact::filtered_sign_of_in_sphere(p[0], p[1], p[2], p[3], p[4]),
                   core::PreconditionViolated);
    }
}

TEST(PerturbedInSphere, IsThatOfRaisedPoints) {
  Random random(20261210);
  int ties = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const int exponent = trial % 5 == 0 ? -1074 : trial % 5 == 1 ? 900 : 0;
    const double step = trial % 5 == 4 ? 0.01 : 1;
    const std::uint64_t size = 2 + random() % 3;
    const Tuple p =
        tuple_of([&] { return std::ldexp(step * small_integer(random, size), exponent); });
    if (!are_different(p)) continue;
    const Sign sign = perturbed(p);
    ASSERT_EQ(sign, static_cast<Sign>(in_sphere_oracle::perturbed_in_sphere(p)));
    const Sign flat = exact::sign_of_orientation(p[0], p[1], p[2], p[3]);
    if (flat != Sign::zero) {
      ASSERT_NE(sign, Sign::zero);
    }
    const Sign unperturbed = in_sphere(p);
    if (unperturbed != Sign::zero) {
      ASSERT_EQ(sign, unperturbed);
    } else {
      ties += flat != Sign::zero ? 1 : 0;
    }
  }
  EXPECT_GT(ties, 3000);
}

/// The rule for points in the plane of a facet, docs/theory/delaunay-ties.md.
TEST(PerturbedInSphere, OfAPointInThePlaneOfAFacetDependsOnTheSideOfTheApexOnly) {
  Random random(20261211);
  int checked = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    Tuple p = tuple_of([&] { return small_integer(random, 3); });
    const Point3 other{small_integer(random, 5), small_integer(random, 5),
                       small_integer(random, 5)};
    const Sign side = exact::sign_of_orientation(p[0], p[1], p[2], p[3]);
    const Sign other_side = exact::sign_of_orientation(p[0], p[1], p[2], other);
    if (exact::sign_of_orientation(p[0], p[1], p[2], p[4]) != Sign::zero || side == Sign::zero ||
        other_side == Sign::zero || !are_different(p))
      continue;
    const Sign sign = perturbed(p);
    p[3] = other;
    ASSERT_EQ(perturbed(p), side == other_side ? sign : exact::opposite(sign));
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

TEST(PerturbedInSphere, RefusesEqualPoints) {
  const Tuple p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
  permute(p, [](const Tuple& q, bool) {
    EXPECT_THROW((void)perturbed(q), core::PreconditionViolated);
  });
}

}  // namespace
