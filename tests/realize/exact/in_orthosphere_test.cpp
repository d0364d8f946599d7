// Claim. sign_of_in_orthosphere() is exact for any finite doubles, whichever arithmetic decides,
// the filter is never wrong, and the perturbed sign is that after raising the points by small
// amounts in the order of their places. Equal weights are as none. Oracle. The determinant of five
// rows by elimination over integers of any length.
#include "realize/exact/in_orthosphere.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "enum/core/errors.hpp"
#include "realize/exact/in_sphere.hpp"
#include "tests/realize/exact/in_sphere_oracle.hpp"
#include "tests/realize/exact/sign_trials.hpp"

namespace {

using namespace hexatlas;
using exact::Sign;
using exact::WeightedPoint3;
using in_sphere_oracle::Tuple;
using in_sphere_oracle::Weights;
using sign_trials::Random;
using sign_trials::small_integer;
using sign_trials::Tally;
using sign_trials::unit;
using Five = std::array<WeightedPoint3, 5>;

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();

Tuple places_of(const Five& p) {
  return {p[0].place, p[1].place, p[2].place, p[3].place, p[4].place};
}
Weights weights_of(const Five& p) {
  return {p[0].weight, p[1].weight, p[2].weight, p[3].weight, p[4].weight};
}
Sign unperturbed(const Five& p) {
  return exact::sign_of_in_orthosphere(p[0], p[1], p[2], p[3], p[4]);
}
Sign perturbed(const Five& p) {
  return exact::sign_of_perturbed_in_orthosphere(p[0], p[1], p[2], p[3], p[4]);
}

bool has_different_places(const Five& p) {
  std::set<std::tuple<double, double, double>> places;
  for (const WeightedPoint3& q : p) places.emplace(q.place.x, q.place.y, q.place.z);
  return places.size() == 5;
}

void check(const Five& p, Tally& tally) {
  const auto expected = static_cast<Sign>(in_sphere_oracle::in_sphere(places_of(p), weights_of(p)));
  ASSERT_EQ(unperturbed(p), expected);
  add(expected, exact::filtered_sign_of_in_orthosphere(p[0], p[1], p[2], p[3], p[4]), tally);
}

template <class Coordinate, class Weight>
Five five_of(const Coordinate& coordinate, const Weight& weight) {
  Five p;
  for (WeightedPoint3& q : p) {
    q.place.x = coordinate();
    q.place.y = coordinate();
    q.place.z = coordinate();
    q.weight = weight();
  }
  return p;
}

/// Lifted to one affine function: the last weight is such that the determinant is zero, or nearly.
void lift(Five& p, Random& random) {
  const double slope = small_integer(random, 9);
  for (WeightedPoint3& q : p) {
    const auto& [x, y, z] = q.place;
    q.weight = x * x + y * y + z * z - slope * x + 3 * y - z - slope;
  }
}

TEST(InOrthosphere, OfTheUnitTetrahedron) {
  const WeightedPoint3 o{{0, 0, 0}, 0}, x{{1, 0, 0}, 0}, y{{0, 1, 0}, 0}, z{{0, 0, 1}, 0};
  // The sphere through them is that of x^2 + y^2 + z^2 = x + y + z.
  const auto sign = [&](double weight) {
    return exact::sign_of_in_orthosphere(o, x, y, z, {{0.25, 0.25, 0.25}, weight});
  };
  EXPECT_EQ(sign(0), Sign::positive);
  EXPECT_EQ(sign(-0.5625), Sign::zero);
  EXPECT_EQ(sign(-0.5625 + 0x1p-50), Sign::positive);
  EXPECT_EQ(sign(-0.5625 - 0x1p-50), Sign::negative);
  EXPECT_EQ(sign(kHuge), Sign::positive);
  EXPECT_EQ(sign(-kHuge), Sign::negative);
}

TEST(InOrthosphere, IsThatOfIntegers) {
  Random random(20261501);
  Tally tally;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::uint64_t size = trial % 4 == 0 ? 3 : trial % 4 == 1 ? 9 : 1 << 20;
    Five p = five_of([&] { return small_integer(random, size); },
                     [&] { return small_integer(random, size * (trial % 3 == 0 ? size : 2)); });
    if (trial % 4 == 3 || trial % 8 == 1) lift(p, random);
    if (trial % 16 == 3) p[random() % 5].weight += small_integer(random, 3);
    check(p, tally);
  }
  EXPECT_GT(tally.negative, 5000);
  EXPECT_GT(tally.positive, 5000);
  EXPECT_GT(tally.zero, 3000);
  EXPECT_GT(tally.left_by_filter, 3000);
}

/// The last places of rounded coordinates and weights decide.
TEST(InOrthosphere, IsExactNearZero) {
  Random random(20261502);
  Tally tally;
  for (int trial = 0; trial < 20000; ++trial) {
    const int exponent = trial % 3 == 0 ? 0 : static_cast<int>(random() % 400) - 200;
    const double scale = std::ldexp(1, exponent);
    Five p = five_of([&] { return unit(random); }, [&] { return 0.0; });
    for (WeightedPoint3& q : p) {
      const auto& [x, y, z] = q.place;
      q.weight = x * x + y * y + z * z - 0.5 * x + y;
    }
    for (WeightedPoint3& q : p)
      q = {{scale * q.place.x, scale * q.place.y, scale * q.place.z}, scale * scale * q.weight};
    check(p, tally);
  }
  EXPECT_GT(tally.negative, 5000);
  EXPECT_GT(tally.positive, 5000);
  EXPECT_GT(tally.left_by_filter, 15000);
}

TEST(InOrthosphere, DecidesMostByTheFilter) {
  Random random(20261503);
  Tally tally;
  for (int trial = 0; trial < 10000; ++trial)
    check(five_of([&] { return unit(random); }, [&] { return unit(random); }), tally);
  EXPECT_LT(tally.left_by_filter, 5);
}

/// Any exponents: differences, squares and products overflow and underflow.
TEST(InOrthosphere, OfWideRanges) {
  Random random(20261504);
  Tally tally;
  constexpr std::array kOdd{0.0, -0.0, kTiny, -kTiny, kHuge, -kHuge, 1e-300, 1.0};
  for (int trial = 0; trial < 6000; ++trial) {
    const unsigned range = trial % 3 == 0 ? 40 : trial % 3 == 1 ? 200 : 1000;
    const auto number = [&](unsigned wide) {
      if (random() % 20 == 0) return kOdd[random() % kOdd.size()];
      const int exponent = static_cast<int>(random() % (2 * wide)) - static_cast<int>(wide);
      return std::ldexp(random() % 2 == 0 ? unit(random) : -unit(random), exponent);
    };
    check(five_of([&] { return number(range); },
                  [&] { return number(trial % 2 == 0 ? range : 1000); }),
          tally);
  }
  EXPECT_GT(tally.negative, 2000);
  EXPECT_GT(tally.positive, 2000);
}

/// Weights of 119 to 129 bits beside coordinates of few: fixed width ends there.
TEST(InOrthosphere, AtTheEndOfFixedWidth) {
  Random random(20261505);
  Tally tally;
  for (int trial = 0; trial < 20000; ++trial) {
    const double coordinate = std::ldexp(1, 56 + static_cast<int>(random() % 7));
    const double weight = std::ldexp(1, 119 + static_cast<int>(random() % 10));
    Five p = five_of(
        [&] {
          return random() % 2 == 0 ? coordinate * small_integer(random, 3) + 1
                                   : small_integer(random, 3);
        },
        [&] { return random() % 4 == 0 ? 1.0 : weight * small_integer(random, 3); });
    check(p, tally);
  }
  EXPECT_GT(tally.left_by_filter, 1000);
}

TEST(InOrthosphere, WithEqualWeightsIsInSphere) {
  Random random(20261506);
  for (int trial = 0; trial < 5000; ++trial) {
    const double weight = trial % 5 == 0   ? kHuge
                          : trial % 5 == 1 ? -kTiny
                                           : small_integer(random, 100);
    const Five p = five_of([&] { return small_integer(random, 5); }, [&] { return weight; });
    if (!has_different_places(p)) continue;
    ASSERT_EQ(perturbed(p), exact::sign_of_perturbed_in_sphere(p[0].place, p[1].place, p[2].place,
                                                               p[3].place, p[4].place));
  }
}

TEST(InOrthosphere, TiesAreThoseOfSmallHeights) {
  Random random(20261507);
  int ties = 0, flat = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Five p = five_of([&] { return small_integer(random, trial % 2 == 0 ? 3 : 7); },
                     [&] { return small_integer(random, 4); });
    if (trial % 4 != 0) lift(p, random);
    if (!has_different_places(p)) continue;
    const Sign sign = perturbed(p);
    ASSERT_EQ(sign, static_cast<Sign>(
                        in_sphere_oracle::perturbed_in_sphere(places_of(p), weights_of(p))));
    ties += unperturbed(p) == Sign::zero ? 1 : 0;
    flat += sign == Sign::zero ? 1 : 0;
    const std::size_t i = random() % 5, j = random() % 5;
    if (i == j) continue;
    std::swap(p[i], p[j]);
    ASSERT_EQ(perturbed(p), exact::opposite(sign));
  }
  EXPECT_GT(ties, 5000);
  EXPECT_GT(flat, 50);
}

/// The greater weight wins, whatever the other points are.
TEST(InOrthosphere, OfTwoAtOnePlaceTheHeavierIsInside) {
  const WeightedPoint3 o{{0, 0, 0}, 0.5}, x{{1, 0, 0}, 9}, y{{0, 1, 0}, -7}, z{{0, 0, 1}, 0};
  const auto sign = [&](double weight) {
    return exact::sign_of_perturbed_in_orthosphere(o, x, y, z, {{0, 0, 0}, weight});
  };
  EXPECT_EQ(sign(std::nextafter(0.5, 1)), Sign::positive);
  EXPECT_EQ(sign(std::nextafter(0.5, 0)), Sign::negative);
  EXPECT_THROW((void)sign(0.5), core::PreconditionViolated);
}

TEST(InOrthosphere, RefusesWhatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    for (std::size_t i = 0; i < 5; ++i)
      for (const bool in_weight : {false, true}) {
        Five p{{{{0, 0, 0}, 1}, {{1, 0, 0}, 2}, {{0, 1, 0}, 3}, {{0, 0, 1}, 4}, {{1, 1, 2}, 5}}};
        (in_weight ? p[i].weight : p[i].place.y) = bad;
        EXPECT_THROW((void)unperturbed(p), core::PreconditionViolated);
        EXPECT_THROW((void)perturbed(p), core::PreconditionViolated);
        EXPECT_THROW((void)exact::filtered_sign_of_in_orthosphere(p[0], p[1], p[2], p[3], p[4]),
                     core::PreconditionViolated);
      }
}

}  // namespace
