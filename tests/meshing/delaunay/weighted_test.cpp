// Claim. With weights the tetrahedra are exactly those whose perturbed orthospheres are empty; all
// points that are no vertices are duplicates or hidden; points inserted later, the order, threads
// and the length of references change nothing.
// Oracle. Brute force over all sets of four points, in integers of 128 bits or any length;
// triangulations without weights; triangulations made from scratch.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "enum/core/errors.hpp"
#include "meshing/delaunay/triangulation.hpp"
#include "realize/exact/integers.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/oracle.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::References;
using delaunay::Triangulation;
using Index = Triangulation::Index;
using Weights = std::vector<double>;

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();

/// What is true of a triangulation: tetrahedra, duplicates, hidden points.
struct Expected {
  Tetrahedra tetrahedra;
  std::size_t duplicates = 0;
  std::vector<Index> hidden;
};

/// From the tetrahedra alone.
template <class Same>
Expected with_others(const Tetrahedra& tetrahedra, std::size_t points, const Same& same) {
  Expected result{tetrahedra, 0, {}};
  std::set<Index> vertices;
  for (const auto& t : tetrahedra) vertices.insert(t.begin(), t.end());
  for (Index i = 0; i < points; ++i) {
    if (vertices.contains(i)) continue;
    if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return same(v, i); }))
      ++result.duplicates;
    else
      result.hidden.push_back(i);
  }
  return result;
}

template <class T>
Expected by_brute_force(const std::vector<typename Oracle<T>::Place>& places,
                        const std::vector<T>& weights) {
  return with_others(Oracle<T>::regular(places, weights), places.size(), [&](Index v, Index i) {
    return places[v] == places[i] && weights[v] == weights[i];
  });
}

void expect_is(const Triangulation& made, const Expected& expected) {
  ASSERT_EQ(made.dimension() == 3, !expected.tetrahedra.empty());
  if (expected.tetrahedra.empty()) return;
  ASSERT_EQ(made.tetrahedra(), expected.tetrahedra);
  ASSERT_EQ(made.duplicates(), expected.duplicates);
  ASSERT_EQ(made.hidden(), expected.hidden);
}

std::vector<Oracle<Wide>::Place> wide(const std::vector<Lattice>& points) {
  std::vector<Oracle<Wide>::Place> result;
  result.reserve(points.size());
  for (const Lattice& p : points) result.push_back({p[0], p[1], p[2]});
  return result;
}

/// Of many kinds: few values, one point above all, nearly a paraboloid the other way, which is
/// flat.
std::vector<std::int64_t> small_weights(std::size_t trial, const std::vector<Lattice>& points,
                                        Random& random) {
  std::vector<std::int64_t> weights(points.size());
  const auto below = [&](std::uint64_t n) { return static_cast<std::int64_t>(random() % n); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Lattice& p = points[i];
    const std::int64_t square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    switch (trial % 7) {
      case 0:
        weights[i] = below(3);
        break;
      case 1:
        weights[i] = below(20) - 10;
        break;
      case 2:
        weights[i] = i == 0 ? 1 << 20 : 0;
        break;
      case 3:  // all lifted to one affine function
        weights[i] = square - 3 * p[0] + p[1];
        break;
      case 4:  // the same, a little wrong
        weights[i] = square - p[2] + below(2);
        break;
      case 5:
        weights[i] = -below(1 << 20);
        break;
      default:
        weights[i] = 17;
    }
  }
  return weights;
}

/// step is a power of two, and so is its square.
Weights real(const std::vector<std::int64_t>& weights, double step) {
  Weights result;
  result.reserve(weights.size());
  for (const std::int64_t w : weights) result.push_back(step * step * static_cast<double>(w));
  return result;
}

TEST(Weighted, IsThatOfBruteForce) {
  Random random(20261601);
  std::size_t with_hidden = 0, with_duplicates = 0, solid = 0;
  constexpr std::array kSteps{1.0, 0x1p-40, 0x1p-500, 0x1p+400};
  for (std::size_t trial = 0; trial < 6000; ++trial) {
    const auto points = small_set(trial, trial % 20 == 0 ? 14 : 9, random);
    const auto weights = small_weights(random(), points, random);
    const Expected expected = by_brute_force<Wide>(wide(points), {weights.begin(), weights.end()});
    const double step = kSteps[trial / 8 % kSteps.size()];
    const Triangulation made(delaunay_tests::real(points, step), real(weights, step),
                             {1, random()});
    ASSERT_TRUE(made.is_weighted());
    expect_is(made, expected);
    if (HasFatalFailure()) FAIL() << "trial " << trial;
    with_hidden += expected.hidden.empty() ? 0 : 1;
    with_duplicates += expected.duplicates == 0 ? 0 : 1;
    solid += expected.tetrahedra.empty() ? 0 : 1;
  }
  EXPECT_GT(solid, 5000U);
  EXPECT_GT(with_hidden, 1000U);
  EXPECT_GT(with_duplicates, 300U);
}

/// Coordinates and weights from 1e-300 to 1e300, in units of one power of two and its square.
TEST(Weighted, OfWideRangesIsThatOfBruteForce) {
  Random random(20261602);
  std::size_t with_hidden = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = 5 + random() % 4;
    const int range = trial % 3 == 0 ? 5 : trial % 3 == 1 ? 90 : 300;
    const auto number = [&](int most) {
      const int exponent = static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
      return (random() % 2 == 0 ? 1 : -1) * unit(random) * std::pow(10.0, exponent);
    };
    Cloud points(count);
    Weights weights(count);
    for (std::size_t i = 0; i < count; ++i) {
      points[i] = {number(range), number(range), number(range)};
      weights[i] = number(trial % 2 == 0 ? std::min(2 * range, 300) : 300);
    }
    mpz_class denominator = 1;
    for (const mesh::Point& p : points)
      for (const double c : {p.x, p.y, p.z})
        denominator = std::max(denominator, mpz_class(mpq_class(c).get_den()));
    for (const double w : weights)
      while (denominator * denominator < mpq_class(w).get_den()) denominator *= 2;
    const auto integer = [](double value, const mpz_class& unit) {
      return mpz_class(mpq_class(mpq_class(value) * unit));
    };
    std::vector<Oracle<mpz_class>::Place> places;
    std::vector<mpz_class> heights;
    for (std::size_t i = 0; i < count; ++i) {
      places.push_back({integer(points[i].x, denominator), integer(points[i].y, denominator),
                        integer(points[i].z, denominator)});
      heights.push_back(integer(weights[i], denominator * denominator));
    }
    const Expected expected = by_brute_force<mpz_class>(places, heights);
    expect_is(Triangulation(points, weights), expected);
    if (HasFatalFailure()) FAIL() << "trial " << trial;
    with_hidden += expected.hidden.empty() ? 0 : 1;
  }
  EXPECT_GT(with_hidden, 50U);
}

TEST(Weighted, EqualWeightsAreAsNone) {
  Random random(20261603);
  for (std::size_t trial = 0; trial < 300; ++trial) {
    const Cloud points = delaunay_tests::real(small_set(trial, 60, random), 0.1);
    const Triangulation plain(points);
    for (const double weight : {0.0, -3.7, kHuge, kTiny}) {
      const Triangulation made(points, Weights(points.size(), weight));
      ASSERT_EQ(made.tetrahedra(), plain.tetrahedra());
      ASSERT_EQ(made.duplicates(), plain.duplicates());
      if (made.dimension() == 3) {
        ASSERT_TRUE(made.hidden().empty());
      }
    }
  }
  const Cloud lattice = grid(9, 1);
  ASSERT_EQ(Triangulation(lattice, Weights(lattice.size(), 0.25)).tetrahedra(),
            Triangulation(lattice).tetrahedra());
  EXPECT_FALSE(Triangulation(lattice).is_weighted());
  EXPECT_TRUE(Triangulation(lattice).hidden().empty());
}

template <class T>
std::span<const T> first_of(const std::vector<T>& values, std::size_t count) {
  return std::span<const T>(values).first(count);
}

/// As sets of places with weights.
using Heavy = std::tuple<double, double, double, double>;
std::set<std::set<Heavy>> by_places(const Cloud& points, const Weights& weights,
                                    const Tetrahedra& mesh) {
  std::set<std::set<Heavy>> result;
  for (const auto& t : mesh) {
    std::set<Heavy> places;
    for (const Index v : t) places.emplace(points[v].x, points[v].y, points[v].z, weights[v]);
    result.insert(places);
  }
  return result;
}

TEST(Weighted, DependsOnThePointsOnly) {
  Random random(20261604);
  for (std::size_t trial = 0; trial < 400; ++trial) {
    const auto lattice = small_set(trial, 60, random);
    const Cloud points = delaunay_tests::real(lattice, 1);
    const Weights weights = real(small_weights(random(), lattice, random), 1);
    const Triangulation once(points, weights);
    for (const References references : {References::short_, References::long_})
      for (const int threads : {1, 3}) {
        const Triangulation again(points, weights, {threads, random(), references});
        ASSERT_EQ(again.tetrahedra(), once.tetrahedra());
        if (once.dimension() < 3) continue;
        ASSERT_EQ(again.duplicates(), once.duplicates());
        ASSERT_EQ(again.hidden(), once.hidden());
      }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    Cloud shuffled;
    Weights their_weights;
    for (const std::size_t i : order) {
      shuffled.push_back(points[i]);
      their_weights.push_back(weights[i]);
    }
    ASSERT_EQ(
        by_places(shuffled, their_weights, Triangulation(shuffled, their_weights).tetrahedra()),
        by_places(points, weights, once.tetrahedra()));
  }
}

/// Each point after the first few: the same as if it had been there from the beginning.
TEST(WeightedInsert, IsAsFromScratch) {
  Random random(20261605);
  std::size_t hidden = 0, hiding = 0, same = 0;
  for (std::size_t trial = 0; trial < 300; ++trial) {
    const auto lattice = small_set(trial, 25, random);
    Cloud points = delaunay_tests::real(lattice, 1);
    Weights weights = real(small_weights(random(), lattice, random), 1);
    // Heavier and lighter ones at the same places.
    for (int i = 0; i < 8; ++i) {
      const std::size_t k = random() % points.size();
      points.push_back(points[k]);
      weights.push_back(weights[k] + static_cast<double>(random() % 3) - 1);
    }
    std::size_t first = 4;
    while (first < points.size() && Triangulation(first_of(points, first)).dimension() < 3) ++first;
    if (first == points.size()) continue;
    Triangulation made(first_of(points, first), first_of(weights, first));
    for (std::size_t i = first; i < points.size(); ++i) {
      const std::size_t before = made.hidden().size();
      const std::optional<Index> vertex = made.insert(points[i], weights[i]);
      const Triangulation expected(first_of(points, i + 1), first_of(weights, i + 1));
      ASSERT_EQ(made.tetrahedra(), expected.tetrahedra());
      const auto now_hidden = made.hidden();
      ASSERT_EQ(now_hidden, expected.hidden());
      ASSERT_EQ(made.duplicates(), expected.duplicates());
      ASSERT_EQ(made.points(), i + 1);
      ASSERT_EQ(vertex.has_value(),
                !std::binary_search(now_hidden.begin(), now_hidden.end(), static_cast<Index>(i)));
      if (!vertex) ++hidden;
      if (vertex && now_hidden.size() > before) ++hiding;
      if (vertex && *vertex != i) ++same;
      if (vertex) {
        ASSERT_EQ(points[*vertex], points[i]);
        ASSERT_EQ(weights[*vertex], weights[i]);
        const auto star = made.star(static_cast<Index>(i));
        ASSERT_FALSE(star.empty());
        for (const auto& t : star) ASSERT_EQ(t[0], *vertex);
      }
    }
    for (const Index h : made.hidden())
      for (const auto& t : made.star(h)) ASSERT_EQ(points[t[0]], points[h]);
  }
  EXPECT_GT(hidden, 500U);
  EXPECT_GT(hiding, 300U);
  EXPECT_GT(same, 100U);
}

/// One point after the other hides all but the corners of what it is in.
TEST(WeightedInsert, AllHiddenButFour) {
  Random random(20261606);
  for (const int threads : {1, 3}) {
    Cloud points = uniform(2000, random);
    Weights weights(points.size(), 0.0);
    for (const mesh::Point& p : Cloud{{-1, -1, -1}, {9, -1, -1}, {-1, 9, -1}, {-1, -1, 9}}) {
      points.push_back(p);
      weights.push_back(1000);
    }
    Triangulation made(points, weights, {threads});
    const auto mesh = made.tetrahedra();
    ASSERT_EQ(mesh, (Tetrahedra{{2000, 2001, 2002, 2003}}));
    ASSERT_EQ(made.hidden().size(), 2000U);
    EXPECT_EQ(made.size(), 1U);
    EXPECT_TRUE(made.star(7).empty());
    Triangulation later(first_of(points, 2000), first_of(weights, 2000), {threads});
    for (std::size_t i = 2000; i < points.size(); ++i)
      ASSERT_EQ(later.insert(points[i], weights[i]), static_cast<Index>(i));
    EXPECT_EQ(later.tetrahedra(), mesh);
    EXPECT_EQ(later.hidden(), made.hidden());
    EXPECT_EQ(later.insert({0, 0, 0}, 0), std::nullopt);
    EXPECT_EQ(later.insert({0, 0, 0}, 2000), Index{2005});
    EXPECT_EQ(later.size(), 4U);
  }
}

TEST(Weighted, OfHugeWeightsAndTinyOnes) {
  const Cloud corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, 0.25}};
  const Tetrahedra whole{{0, 1, 2, 3}};
  const Tetrahedra parts{{0, 1, 2, 4}, {0, 1, 4, 3}, {0, 2, 3, 4}, {1, 2, 4, 3}};
  const auto tetrahedra = [&](double weight) {
    return Triangulation(corners, Weights{0, 0, 0, 0, weight}).tetrahedra();
  };
  for (const double weight : {kHuge, kTiny, -kTiny, 0.0, std::nextafter(-0.5625, 0.0)})
    EXPECT_EQ(tetrahedra(weight), parts) << weight;
  for (const double weight : {-kHuge, std::nextafter(-0.5625, -1.0)})
    EXPECT_EQ(tetrahedra(weight), whole) << weight;
  // The point is on the orthosphere: it is raised above the lesser corners, but not above the
  // greatest one, (1, 0, 0), whose height counts most.
  EXPECT_EQ(tetrahedra(-0.5625), parts);
  const Triangulation far(Cloud{{-kHuge, 0, 0}, {kHuge, 0, 0}, {0, kHuge, 0}, {0, 0, kHuge}},
                          Weights{kHuge, -kHuge, kTiny, 0});
  EXPECT_EQ(far.tetrahedra(), whole);
}

TEST(Weighted, RefusesWhatIsNotFiniteOrMissing) {
  const Cloud corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Triangulation plain(corners), made(corners, Weights(4, 1));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Triangulation(corners, Weights{0, 0, bad, 0}), core::PreconditionViolated);
    EXPECT_THROW((void)made.insert({1, 1, 1}, bad), core::PreconditionViolated);
    EXPECT_THROW((void)made.insert({1, bad, 1}, 0), core::PreconditionViolated);
  }
  EXPECT_THROW(Triangulation(corners, Weights(3, 0)), core::PreconditionViolated);
  EXPECT_THROW(Triangulation(corners, Weights(5, 0)), core::PreconditionViolated);
  EXPECT_THROW((void)plain.insert({1, 1, 1}, 0), core::PreconditionViolated);
  EXPECT_THROW((void)made.insert({1, 1, 1}), core::PreconditionViolated);
  EXPECT_EQ(made.points(), 4U);
  EXPECT_EQ(made.size(), 1U);
}

TEST(Weighted, SetsThatDoNotSpanSpace) {
  const Triangulation none(Cloud{}, Weights{});
  EXPECT_EQ(none.dimension(), -1);
  const Triangulation plane(Cloud{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}},
                            Weights{1, 2, 3, 3, 4});
  EXPECT_EQ(plane.dimension(), 2);
  EXPECT_EQ(plane.duplicates(), 1U);
  EXPECT_TRUE(plane.tetrahedra().empty());
  EXPECT_THROW((void)plane.hidden(), core::PreconditionViolated);
}

/// Wishes have weight 0: hidden where all others have much, none below them.
TEST(WeightedRefine, EndsWhenWishesAreHidden) {
  Random random(20261608);
  const Cloud points = uniform(30, random);
  Triangulation made(points, Weights(points.size(), 1000));
  const std::size_t tetrahedra = made.size();
  std::size_t asked = 0;
  const auto wish = [&](const std::array<mesh::Point, 4>& t) -> std::optional<mesh::Point> {
    ++asked;
    return mesh::Point{(t[0].x + t[1].x + t[2].x + t[3].x) / 4,
                       (t[0].y + t[1].y + t[2].y + t[3].y) / 4,
                       (t[0].z + t[1].z + t[2].z + t[3].z) / 4};
  };
  EXPECT_EQ(made.refine(wish, 1000), 0U);
  EXPECT_EQ(asked, tetrahedra);
  EXPECT_EQ(made.size(), tetrahedra);
  EXPECT_EQ(made.hidden().size(), tetrahedra);
  Triangulation light(points, Weights(points.size(), -1000));
  EXPECT_EQ(light.refine(wish, 5), 5U);
}

}  // namespace
