// Claim. A sign that is proven is right; a facet with a point that is not a number is not decided;
// for points in general position nearly all are. So for each of the implementations.
// Oracle. Exact signs of realize/exact, for each of the four facets.
#include "meshing/delaunay/four_facets.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "meshing/delaunay/site.hpp"
#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"

namespace {

using namespace hexatlas;
using namespace hexatlas::delaunay_tests;
using delaunay::FacetSigns;
using delaunay::FourFacets;
using delaunay::FourSites;
using delaunay::Site;
using exact::Sign;

struct Query {
  std::array<Site, 4> corners, apexes;
  Site p;
};

std::vector<std::pair<std::string, const FourFacets*>> implementations() {
  std::vector<std::pair<std::string, const FourFacets*>> result{
      {"plain", &delaunay::four_facets_plain()}, {"chosen", &delaunay::four_facets()}};
#if defined(__x86_64__)
  if (delaunay::four_facets_avx2() != nullptr && __builtin_cpu_supports("avx2") != 0 &&
      __builtin_cpu_supports("fma") != 0)
    result.emplace_back("avx2", delaunay::four_facets_avx2());
#endif
  return result;
}

FourSites addresses(const std::array<Site, 4>& sites) {
  return {&sites[0], &sites[1], &sites[2], &sites[3]};
}

/// c[j], c[j+1], c[j+2] and the point beyond: of an odd rotation, so its sign alternates.
Sign expected_beyond(const Query& q, unsigned j) {
  std::array<exact::Point3, 4> t{};
  for (unsigned i = 0; i < 4; ++i) t[i] = (i == (j + 3) % 4 ? q.p : q.corners[i]).point();
  return exact::opposite(exact::sign_of_orientation(t[0], t[1], t[2], t[3]));
}

/// The tetrahedron beyond is right-handed with the apex in place of the vertex and two exchanged.
Sign expected_conflict(const Query& q, unsigned j) {
  std::array<exact::Point3, 4> t{};
  for (unsigned i = 0; i < 4; ++i) t[i] = (i == (j + 3) % 4 ? q.apexes[j] : q.corners[i]).point();
  std::swap(t[j], t[(j + 1) % 4]);
  return exact::sign_of_in_sphere(t[0], t[1], t[2], t[3], q.p.point());
}

struct Tally {
  std::size_t asked = 0, undecided = 0;
  void add(const FacetSigns& signs, unsigned j, Sign expected) {
    ++asked;
    if ((signs.undecided >> j & 1U) != 0) {
      ++undecided;
      return;
    }
    ASSERT_NE(expected, Sign::zero);
    ASSERT_EQ((signs.positive >> j & 1U) != 0, expected == Sign::positive);
  }
};

void compare(const FourFacets& functions, const Query& q, Tally& beyond, Tally& conflict) {
  const FacetSigns b = functions.beyond(addresses(q.corners), q.p);
  const FacetSigns c = functions.conflict(addresses(q.corners), addresses(q.apexes), q.p);
  for (const FacetSigns& signs : {b, c}) {
    ASSERT_EQ(signs.positive & signs.undecided, 0U);
    ASSERT_LT(signs.positive | signs.undecided, 16U);
  }
  for (unsigned j = 0; j < 4; ++j) {
    beyond.add(b, j, expected_beyond(q, j));
    conflict.add(c, j, expected_conflict(q, j));
  }
}

Site site(const mesh::Point& p) { return {p.x, p.y, p.z, 0}; }

Query query_of(const Cloud& nine) {
  Query q;
  for (unsigned i = 0; i < 4; ++i) {
    q.corners[i] = site(nine[i]);
    q.apexes[i] = site(nine[4 + i]);
  }
  q.p = site(nine[8]);
  if (exact::sign_of_orientation(q.corners[0].point(), q.corners[1].point(), q.corners[2].point(),
                                 q.corners[3].point()) == Sign::negative)
    std::swap(q.corners[0], q.corners[1]);
  return q;
}

TEST(FourFacets, DecideGeneralPosition) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261241);
    Tally beyond, conflict;
    for (int trial = 0; trial < 20000; ++trial) {
      compare(*functions, query_of(uniform(9, random)), beyond, conflict);
      if (HasFatalFailure()) return;
    }
    EXPECT_LT(static_cast<double>(beyond.undecided), 1e-3 * static_cast<double>(beyond.asked));
    EXPECT_LT(static_cast<double>(conflict.undecided), 1e-3 * static_cast<double>(conflict.asked));
  }
}

/// Nearly cospherical, nearly coplanar; moved far away; of any size.
TEST(FourFacets, AreRightNearZero) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261242);
    Tally beyond, conflict;
    for (int trial = 0; trial < 20000; ++trial) {
      Cloud nine = trial % 3 == 0   ? sphere(9, random)
                   : trial % 3 == 1 ? uniform(9, random, 1, 1, 0)
                                    : real(some_of(lattice_sphere(26), 9, random));
      const double noise = std::pow(2.0, -30 - static_cast<int>(random() % 26));
      const double shift = trial % 5 == 0 ? std::pow(2.0, random() % 30) : 0;
      constexpr std::array kScales{0, 0, -60, 100, -180, -300, -500, -1040, 400, 900};
      const int scale = kScales[random() % kScales.size()];
      for (mesh::Point& p : nine)
        for (double* c : {&p.x, &p.y, &p.z})
          *c = std::ldexp(*c + noise * unit(random) + shift, scale);
      compare(*functions, query_of(nine), beyond, conflict);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(beyond.undecided, 1000U);
    EXPECT_LT(beyond.undecided, beyond.asked * 3 / 4);
    EXPECT_GT(conflict.undecided, 1000U);
    EXPECT_LT(conflict.undecided, conflict.asked * 19 / 20);
  }
}

/// Coordinates of very different sizes, near underflow and overflow too.
TEST(FourFacets, AreRightForAnySizes) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261243);
    Tally beyond, conflict;
    for (int trial = 0; trial < 2000; ++trial) {
      Cloud nine = uniform(9, random);
      const auto range = static_cast<unsigned>(std::array{20, 200, 1000}[random() % 3]);
      const int middle = static_cast<int>(random() % 5) * 100 - 200;
      for (mesh::Point& p : nine)
        for (double* c : {&p.x, &p.y, &p.z}) {
          const int exponent = static_cast<int>(random() % (2 * range)) - static_cast<int>(range);
          *c = std::ldexp(random() % 2 == 0 ? *c : -*c, std::clamp(exponent + middle, -1070, 1020));
        }
      compare(*functions, query_of(nine), beyond, conflict);
      if (HasFatalFailure()) return;
    }
    EXPECT_LT(beyond.undecided, beyond.asked);
    EXPECT_LT(conflict.undecided, conflict.asked);
  }
}

TEST(FourFacets, DecideNothingThatIsZero) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261244);
    Tally beyond, conflict;
    for (int trial = 0; trial < 5000; ++trial) {
      compare(*functions, query_of(real(random_lattice(9, 2, random), 0.1)), beyond, conflict);
      compare(*functions, query_of(real(random_lattice(9, 3, random))), beyond, conflict);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(FourFacets, DoNotDecideWhatIsNotANumber) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Site nowhere{kNaN, kNaN, kNaN, 0};
  for (const auto& [name, functions] : implementations()) {
    Random random(20261245);
    for (int trial = 0; trial < 200; ++trial) {
      for (unsigned i = 0; i < 4; ++i) {
        const Query whole = query_of(uniform(9, random));
        Query q = whole;
        q.corners[i] = nowhere;
        const unsigned with_corner = 15U & ~(1U << (i + 1) % 4);  // all but the opposite facet
        const auto b = functions->beyond(addresses(q.corners), q.p);
        auto c = functions->conflict(addresses(q.corners), addresses(q.apexes), q.p);
        EXPECT_EQ(b.undecided & with_corner, with_corner);
        EXPECT_EQ(c.undecided & with_corner, with_corner);
        EXPECT_EQ((b.positive | c.positive) & with_corner, 0U);
        const auto b0 = functions->beyond(addresses(whole.corners), whole.p);
        const auto c0 =
            functions->conflict(addresses(whole.corners), addresses(whole.apexes), whole.p);
        EXPECT_EQ(b.positive & ~with_corner, b0.positive & ~with_corner);
        EXPECT_EQ(c.positive & ~with_corner, c0.positive & ~with_corner);
        q = whole;
        q.apexes[i] = nowhere;
        c = functions->conflict(addresses(q.corners), addresses(q.apexes), q.p);
        EXPECT_EQ(c.undecided >> i & 1U, 1U);
        EXPECT_EQ(c.positive, c0.positive & ~(1U << i));
        EXPECT_EQ(c.undecided, c0.undecided | 1U << i);
      }
    }
  }
}

}  // namespace
