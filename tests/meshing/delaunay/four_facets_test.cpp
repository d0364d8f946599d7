// Claim. A sign that is proven is right, with the ghost vertex too; for points in general position
// nearly all are proven; ties of short integers are. So for each of the implementations.
// Oracle. Exact signs of realize/exact, for each of the four facets; for ties, elimination over
// integers of any length.
#include "meshing/delaunay/four_facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meshing/delaunay/common_unit.hpp"
#include "meshing/delaunay/site.hpp"
#include "realize/exact/in_sphere.hpp"
#include "realize/exact/orientation.hpp"
#include "tests/meshing/delaunay/clouds.hpp"
#include "tests/realize/exact/in_sphere_oracle.hpp"

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
  if (delaunay::four_facets_avx512() != nullptr && __builtin_cpu_supports("avx512vl") != 0 &&
      __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("fma") != 0)
    result.emplace_back("avx512", delaunay::four_facets_avx512());
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

bool is_ghost(const exact::Point3& p) { return std::isnan(p.x); }

/// The tetrahedron beyond is right-handed with the apex in place of the vertex and two exchanged.
std::array<exact::Point3, 4> beyond_facet(const Query& q, unsigned j) {
  std::array<exact::Point3, 4> t{};
  for (unsigned i = 0; i < 4; ++i) t[i] = (i == (j + 3) % 4 ? q.apexes[j] : q.corners[i]).point();
  std::swap(t[j], t[(j + 1) % 4]);
  return t;
}

bool are_different(std::array<exact::Point3, 4> t, const exact::Point3& p) {
  for (unsigned i = 0; i < 4; ++i) {
    if (t[i] == p) return false;
    for (unsigned k = 0; k < i; ++k)
      if (t[i] == t[k]) return false;
  }
  return true;
}

/// None if it does not matter: for equal points.
std::optional<Sign> expected_conflict(const Query& q, unsigned j) {
  std::array<exact::Point3, 4> t = beyond_facet(q, j);
  const auto ghost = std::find_if(t.begin(), t.end(), is_ghost);
  if (ghost != t.end()) {
    *ghost = q.p.point();
    return exact::sign_of_orientation(t[0], t[1], t[2], t[3]);
  }
  if (!are_different(t, q.p.point())) return std::nullopt;
  return exact::sign_of_perturbed_in_sphere(t[0], t[1], t[2], t[3], q.p.point());
}

double short_below(const Query& q) {
  delaunay::CommonUnit unit;
  for (unsigned i = 0; i < 4; ++i)
    for (const Site* site : {&q.corners[i], &q.apexes[i]})
      if (!is_ghost(site->point())) unit.include(*site);
  unit.include(q.p);
  return unit.short_below();
}

struct Tally {
  std::size_t asked = 0, undecided = 0;
  void add(const FacetSigns& signs, unsigned j, std::optional<Sign> expected) {
    if (!expected) return;
    ++asked;
    if ((signs.undecided >> j & 1U) != 0) {
      ++undecided;
      return;
    }
    ASSERT_NE(*expected, Sign::zero);
    ASSERT_EQ((signs.positive >> j & 1U) != 0, *expected == Sign::positive);
  }
};

FacetSigns conflict(const FourFacets& functions, const Query& q, unsigned wanted = 15) {
  return functions.conflict(addresses(q.corners), addresses(q.apexes), q.p, wanted, short_below(q));
}

FacetSigns conflict_thoroughly(const FourFacets& functions, const Query& q) {
  return functions.conflict_thoroughly(addresses(q.corners), addresses(q.apexes), q.p);
}

void compare(const FourFacets& functions, const Query& q, Tally& beyond, Tally& conflicts) {
  const FacetSigns b = functions.beyond(addresses(q.corners), q.p);
  const FacetSigns c = conflict(functions, q), thorough = conflict_thoroughly(functions, q);
  for (const FacetSigns& signs : {b, c, thorough}) {
    ASSERT_EQ(signs.positive & signs.undecided, 0U);
    ASSERT_LT(signs.positive | signs.undecided, 16U);
  }
  Tally of_thorough;
  for (unsigned j = 0; j < 4; ++j) {
    const std::optional<Sign> expected = expected_conflict(q, j);
    beyond.add(b, j, expected_beyond(q, j));
    conflicts.add(c, j, expected);
    of_thorough.add(thorough, j, expected);
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

/// Long and thin tetrahedra: the bounds of their own points decide what those of a cube do not.
TEST(FourFacets, DecideUnevenPoints) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261244);
    Tally beyond, conflict;
    for (int trial = 0; trial < 20000; ++trial) {
      Cloud nine = uniform(9, random);
      for (mesh::Point& p : nine) {
        const double size = std::pow(2.0, -static_cast<double>(random() % 12));
        p = {size * p.x, size * p.y, size * size * p.z};
      }
      compare(*functions, query_of(nine), beyond, conflict);
      if (HasFatalFailure()) return;
    }
    EXPECT_LT(static_cast<double>(conflict.undecided), 1e-3 * static_cast<double>(conflict.asked));
  }
}

/// In a slab, which the product of lengths does not tell from a ball. Of any thickness.
TEST(FourFacets, DecideFlatTetrahedra) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261250);
    Tally plain, thorough;
    for (int trial = 0; trial < 20000; ++trial) {
      Cloud nine = uniform(9, random);
      const auto axis = random() % 3;
      const double thickness = std::pow(2.0, -35 - static_cast<double>(random() % 20));
      for (mesh::Point& p : nine) *std::array{&p.x, &p.y, &p.z}[axis] *= thickness;
      const Query q = query_of(nine);
      const FacetSigns quick =
          functions->conflict_quickly(addresses(q.corners), addresses(q.apexes), q.p);
      const FacetSigns slow = conflict_thoroughly(*functions, q);
      for (unsigned j = 0; j < 4; ++j) {
        const std::optional<Sign> expected = expected_conflict(q, j);
        plain.add(quick, j, expected);
        thorough.add(slow, j, expected);
      }
      if (HasFatalFailure()) return;
    }
    EXPECT_LT(static_cast<double>(thorough.undecided), 1e-3 * static_cast<double>(thorough.asked));
    EXPECT_LT(10 * thorough.undecided, plain.undecided);
  }
}

/// One point so near to p that its squared distance underflows, in the plane that touches the
/// sphere of the others at p, but for their roundings. Those may be far away.
TEST(FourFacets, AreRightBesideWhatUnderflows) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261249);
    Tally beyond, conflict;
    for (int trial = 0; trial < 3000; ++trial) {
      Cloud nine = sphere(9, random);
      const int far = static_cast<int>(random() % 180) - 20;
      for (mesh::Point& p : nine)
        p = {std::ldexp(p.x, far), std::ldexp(p.y, far), std::ldexp(p.z + 1, far)};
      const int near = -440 - static_cast<int>(random() % 110);
      nine[random() % 8] = {std::ldexp(unit(random) - 0.5, near),
                            std::ldexp(unit(random) - 0.5, near), 0};
      nine[8] = {0, 0, 0};
      compare(*functions, query_of(nine), beyond, conflict);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(conflict.undecided, 1000U);
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
    EXPECT_GT(conflict.undecided, 500U);
  }
}

/// Moved far away, of any size that counts; near the limit of what is short, too.
TEST(FourFacets, DecideTiesOfShortIntegers) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261246);
    std::size_t ties = 0, beyond_limit = 0;
    for (int trial = 0; trial < 1500; ++trial) {
      constexpr std::array<std::int64_t, 6> kRanges{1, 2, 3, 20, 208, 260};
      const std::int64_t range = kRanges[random() % kRanges.size()];
      std::vector<Lattice> nine = trial % 3 == 0   ? some_of(lattice_sphere(26), 9, random)
                                  : trial % 3 == 1 ? random_lattice(9, range, random)
                                                   : some_of(lattice_box(3, 3, 3), 9, random);
      // Boxes of any proportions have their corners on a sphere.
      Lattice factors{1, 1, 1};
      if (trial % 3 == 0) factors.fill(1 + static_cast<std::int64_t>(random() % 40));
      if (trial % 3 == 2)
        for (std::int64_t& f : factors) f = random() % 2 == 0 ? 1 : 200;
      const std::int64_t shift = trial % 2 == 0 ? 0 : std::int64_t{1} << (random() % 52);
      for (Lattice& p : nine)
        for (std::size_t k = 0; k < 3; ++k) p[k] = p[k] * factors[k] + shift;
      constexpr std::array kScales{0, -60, 20, -120, 100};
      const Query q = query_of(real(nine, std::ldexp(1, kScales[random() % kScales.size()])));
      const FacetSigns signs = conflict(*functions, q);
      for (unsigned j = 0; j < 4; ++j) {
        const auto t = beyond_facet(q, j);
        const in_sphere_oracle::Tuple five{t[0], t[1], t[2], t[3], q.p.point()};
        if (!are_different(t, q.p.point())) continue;
        const int expected = in_sphere_oracle::perturbed_in_sphere(five);
        if (trial % 3 == 1 && range > 208) {  // may be too long to be proven
          ++beyond_limit;
          if ((signs.undecided >> j & 1U) != 0) continue;
        }
        ASSERT_EQ((signs.undecided >> j & 1U) != 0, expected == 0) << name;
        ASSERT_EQ((signs.positive >> j & 1U) != 0, expected > 0) << name;
        if (in_sphere_oracle::in_sphere(five) == 0) ++ties;
      }
    }
    EXPECT_GT(ties, 1000U);
    EXPECT_GT(beyond_limit, 100U);
  }
}

/// For the facets that matter: what is said of the others is right all the same.
TEST(FourFacets, DecideTiesOfTheFacetsThatMatter) {
  for (const auto& [name, functions] : implementations()) {
    Random random(20261247);
    Tally tally;
    for (int trial = 0; trial < 5000; ++trial) {
      const Query q = query_of(real(some_of(lattice_box(3, 3, 3), 9, random)));
      const auto wanted = static_cast<unsigned>(random() % 16);
      const FacetSigns all = conflict(*functions, q), some = conflict(*functions, q, wanted);
      ASSERT_EQ(some.undecided & wanted, all.undecided & wanted);
      for (unsigned j = 0; j < 4; ++j) tally.add(some, j, expected_conflict(q, j));
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(tally.undecided, 1000U);
  }
}

/// At a corner, at all apexes in turn, and with a point in the plane of the facet of the hull.
TEST(FourFacets, KnowTheGhostVertex) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Site nowhere{kNaN, kNaN, kNaN, 0};
  for (const auto& [name, functions] : implementations()) {
    Random random(20261245);
    Tally general, lattice, tiny, general_thorough, other_thorough;
    for (int trial = 0; trial < 3000; ++trial)
      for (unsigned i = 0; i < 8; ++i) {
        const auto with_ghost = [&](const Cloud& nine) {
          Query q = query_of(nine);
          (i < 4 ? q.corners[i] : q.apexes[i - 4]) = nowhere;
          return q;
        };
        const auto add = [&, &chosen = *functions](const Query& q, Tally& tally,
                                                   Tally& of_thorough) {
          const FacetSigns signs = conflict(chosen, q), thorough = conflict_thoroughly(chosen, q);
          for (unsigned j = 0; j < 4; ++j) {
            const std::optional<Sign> expected = expected_conflict(q, j);
            tally.add(signs, j, expected);
            of_thorough.add(thorough, j, expected);
          }
        };
        Cloud small = uniform(9, random);
        const int scale = static_cast<int>(random() % 300) - 200;
        for (mesh::Point& p : small)
          p = {std::ldexp(p.x, scale), std::ldexp(p.y, scale), std::ldexp(p.z, scale)};
        add(with_ghost(uniform(9, random)), general, general_thorough);
        add(with_ghost(real(random_lattice(9, 2, random))), lattice, other_thorough);
        add(with_ghost(small), tiny, other_thorough);
        if (HasFatalFailure()) return;
      }
    EXPECT_LT(static_cast<double>(general.undecided), 1e-3 * static_cast<double>(general.asked));
    EXPECT_LT(static_cast<double>(general_thorough.undecided),
              1e-3 * static_cast<double>(general_thorough.asked));
    EXPECT_GT(lattice.undecided, 1000U);
    EXPECT_LT(lattice.undecided, lattice.asked / 2);
    EXPECT_LT(tiny.undecided, tiny.asked);
  }
}

TEST(CommonUnit, IsTheLowestBit) {
  Random random(20261248);
  for (int trial = 0; trial < 20000; ++trial) {
    const auto odd = static_cast<double>(random() >> (11U + random() % 53U) | 1U);
    const int exponent = static_cast<int>(random() % 1900) - 1074;
    ASSERT_EQ(delaunay::lowest_bit(std::ldexp(random() % 2 == 0 ? odd : -odd, exponent)),
              std::ldexp(1, exponent));
  }
  EXPECT_EQ(delaunay::lowest_bit(0.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(delaunay::lowest_bit(-0.0), std::numeric_limits<double>::infinity());
  delaunay::CommonUnit unit;
  EXPECT_LT(unit.short_below(), 0);
  unit.include({0x1p7, 0x3p4, 0, 0});
  EXPECT_EQ(unit.short_below(), 0x1p27);
  unit.include({0x1p-180, 0, 0, 0});
  EXPECT_EQ(unit.short_below(), 0x1p-341);
  unit.include({0x1p-181, 0, 0, 0});
  EXPECT_LT(unit.short_below(), 0);
}

}  // namespace
