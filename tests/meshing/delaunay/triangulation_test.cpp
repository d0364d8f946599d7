// Claim. The tetrahedra are exactly those whose perturbed spheres are empty; a vertex is called by
// the least number of the points at its place. Numbers, order of insertion, threads and the length
// of references change nothing else.
// Oracle. Brute force over all sets of four points, in integers of 128 bits or any length.
#include "meshing/delaunay/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "realize/exact/integers.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/meshing/delaunay/oracle.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::Options;
using delaunay::References;
using delaunay::Triangulation;

std::vector<Oracle<Wide>::Place> wide(const std::vector<Lattice>& points) {
  std::vector<Oracle<Wide>::Place> result;
  result.reserve(points.size());
  for (const Lattice& p : points) result.push_back({p[0], p[1], p[2]});
  return result;
}

/// The places in units of a power of two that divides them all.
std::vector<Oracle<mpz_class>::Place> integers(const Cloud& points) {
  mpz_class denominator = 1;
  std::vector<std::array<mpq_class, 3>> exact;
  for (const mesh::Point& p : points) {
    exact.push_back({mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)});
    for (const mpq_class& c : exact.back())
      if (c.get_den() > denominator) denominator = c.get_den();
  }
  std::vector<Oracle<mpz_class>::Place> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = exact[i][k].get_num() * (denominator / exact[i][k].get_den());
  return result;
}

std::size_t places(const std::vector<Lattice>& points) {
  return std::set<Lattice>(points.begin(), points.end()).size();
}

TEST(Triangulation, IsThatOfBruteForce) {
  Random random(20261201);
  std::size_t solid = 0, with_ties = 0;
  constexpr std::array kSteps{1.0, 0x1p-40, 0x1p-1060, 0x1p+900};
  for (std::size_t trial = 0; trial < 6000; ++trial) {
    const auto points = small_set(trial, trial % 20 == 0 ? 14 : 9, random);
    Options options;
    options.seed = random();
    const Triangulation made(real(points, kSteps[trial / 8 % kSteps.size()]), options);
    const Tetrahedra expected = Oracle<Wide>::delaunay(wide(points));
    ASSERT_EQ(made.tetrahedra(), expected) << "trial " << trial;
    ASSERT_EQ(made.size(), expected.size());
    ASSERT_EQ(made.points(), points.size());
    ASSERT_EQ(made.duplicates(), points.size() - places(points));
    ASSERT_EQ(made.dimension() == 3, !expected.empty());
    solid += expected.empty() ? 0 : 1;
    with_ties += trial % 8 == 0 ? 0 : 1;
  }
  EXPECT_GT(solid, 5000U);
  EXPECT_GT(with_ties, 5000U);
}

TEST(Triangulation, OfWholeBoxesIsThatOfBruteForce) {
  for (const auto& points : {lattice_box(2, 2, 2), lattice_box(2, 3, 2), lattice_box(3, 3, 2),
                             lattice_box(3, 3, 3), lattice_sphere(9)})
    ASSERT_EQ(Triangulation(real(points)).tetrahedra(), Oracle<Wide>::delaunay(wide(points)));
}

/// Doubles of any exponent, where differences of coordinates are not doubles.
TEST(Triangulation, OfWideRangesIsThatOfBruteForce) {
  Random random(20261202);
  for (int trial = 0; trial < 300; ++trial) {
    Cloud points = uniform(5 + random() % 4, random);
    const int range = trial % 3 == 0 ? 20 : trial % 3 == 1 ? 90 : 300;
    for (mesh::Point& p : points)
      for (double* c : {&p.x, &p.y, &p.z}) {
        const int exponent = static_cast<int>(random() % static_cast<unsigned>(2 * range)) - range;
        *c = (random() % 2 == 0 ? 1 : -1) * *c * std::pow(10.0, exponent);
      }
    ASSERT_EQ(Triangulation(points).tetrahedra(), Oracle<mpz_class>::delaunay(integers(points)))
        << "trial " << trial;
  }
}

/// Lattices of step 0.1: rounded, so that ties are broken by roundings of the input.
TEST(Triangulation, OfRoundedLatticesIsThatOfBruteForce) {
  Random random(20261203);
  for (int trial = 0; trial < 300; ++trial) {
    const Cloud points = real(some_of(lattice_box(3, 4, 3), 5 + random() % 4, random), 0.1);
    ASSERT_EQ(Triangulation(points).tetrahedra(), Oracle<mpz_class>::delaunay(integers(points)))
        << "trial " << trial;
  }
}

/// As sets of places.
std::set<std::set<Lattice>> by_places(const std::vector<Lattice>& points, const Tetrahedra& mesh) {
  std::set<std::set<Lattice>> result;
  for (const auto& t : mesh)
    result.insert({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
  return result;
}

TEST(Triangulation, DependsOnThePlacesOnly) {
  Random random(20261204);
  for (std::size_t trial = 0; trial < 1000; ++trial) {
    auto points = small_set(trial, 60, random);
    const auto once = by_places(points, Triangulation(real(points)).tetrahedra());
    points.push_back(points[random() % points.size()]);
    std::shuffle(points.begin(), points.end(), random);
    const Tetrahedra again = Triangulation(real(points)).tetrahedra();
    ASSERT_EQ(by_places(points, again), once);
    ASSERT_EQ(again.size(), once.size());
    std::map<Lattice, std::uint32_t> least;
    for (std::uint32_t i = 0; i < points.size(); ++i) least.emplace(points[i], i);
    for (const auto& t : again)
      for (const std::uint32_t v : t) ASSERT_EQ(least.at(points[v]), v);
  }
}

TEST(Triangulation, DoesNotDependOnTheOptions) {
  Random random(20261205);
  for (std::size_t trial = 0; trial < 400; ++trial) {
    const Cloud points = real(small_set(trial, 60, random));
    const auto expected = Triangulation(points).tetrahedra();
    for (const References references : {References::short_, References::long_})
      for (const int threads : {1, 3})
        ASSERT_EQ(Triangulation(points, {threads, random(), references}).tetrahedra(), expected);
  }
}

TEST(Triangulation, CanBeMoved) {
  Random random(20261206);
  const Cloud points = uniform(100, random);
  Triangulation first(points);
  const auto expected = first.tetrahedra();
  Triangulation second(std::move(first));
  EXPECT_EQ(second.tetrahedra(), expected);
  Triangulation third(uniform(5, random));
  third = std::move(second);
  EXPECT_EQ(third.tetrahedra(), expected);
  EXPECT_GT(third.bytes(), 100U * 32U);
}

}  // namespace
