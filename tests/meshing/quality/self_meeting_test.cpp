/// Claim. first_self_meeting() finds the first folded quad, else the first pair of quads of which
/// an edge of one meets the patch of the other outside what they share; for flat quads, any pair
/// that meets outside what it shares. Renumbering, turning, and exact motions and scales change
/// nothing. Oracle. All pairs, one by one and without filter, by tests/oracles/patches.hpp;
/// surfaces made so that the answer is evident.
#include "meshing/quality/self_meeting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "enum/core/errors.hpp"
#include "tests/oracles/patches.hpp"
#include "tests/share.hpp"

namespace hexatlas::quality {
namespace {

using mesh::SurfaceMesh;
using oracle::QuadPoints;
using oracle::Vec;
using Quad = std::array<mesh::Index, 4>;
using Found = std::optional<SelfMeeting>;

struct IntegerSurface {
  std::vector<Vec> points;
  std::vector<Quad> quads;
};

SurfaceMesh with_doubles(const IntegerSurface& surface) {
  SurfaceMesh result;
  for (const Vec& p : surface.points)
    result.points.push_back(
        {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
  result.quads = surface.quads;
  return result;
}

Found found_in(const IntegerSurface& surface) { return first_self_meeting(with_doubles(surface)); }

QuadPoints points_of(const IntegerSurface& surface, const Quad& quad) {
  return {surface.points[quad[0]], surface.points[quad[1]], surface.points[quad[2]],
          surface.points[quad[3]]};
}

bool has_edge(const Quad& quad, mesh::Index v, mesh::Index w) {
  for (std::size_t i = 0; i < 4; ++i)
    for (const std::size_t j : {(i + 1) % 4, (i + 3) % 4})
      if (quad[i] == v && quad[j] == w) return true;
  return false;
}

bool edges_meet(const IntegerSurface& surface, const Quad& quad, const Quad& other) {
  for (std::size_t i = 0; i < 4; ++i) {
    const mesh::Index v = quad[i];
    const mesh::Index w = quad[(i + 1) % 4];
    const auto is_shared = [&](mesh::Index x) {
      return std::count(other.begin(), other.end(), x) > 0;
    };
    if (has_edge(other, v, w)) continue;
    if (oracle::meets({surface.points[v], surface.points[w], is_shared(v), is_shared(w)},
                      points_of(surface, other)))
      return true;
  }
  return false;
}

Found by_brute_force(const IntegerSurface& surface) {
  const auto count = static_cast<std::uint32_t>(surface.quads.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const QuadPoints q = points_of(surface, surface.quads[i]);
    if (oracle::is_flat(q) && !oracle::is_strictly_convex(q)) return SelfMeeting{i, i};
  }
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t j = i + 1; j < count; ++j)
      if (edges_meet(surface, surface.quads[i], surface.quads[j]) ||
          edges_meet(surface, surface.quads[j], surface.quads[i]))
        return SelfMeeting{i, j};
  return std::nullopt;
}

/// A tube of square rings, closed at both ends; quad 0 is the first end, 1 the last one, and
/// 2 + 4 k + i is side i between rings k and k + 1.
IntegerSurface tube(const std::vector<std::array<Vec, 4>>& rings) {
  IntegerSurface result;
  for (const auto& ring : rings)
    result.points.insert(result.points.end(), ring.begin(), ring.end());
  const auto last = static_cast<mesh::Index>(4 * (rings.size() - 1));
  result.quads = {{3, 2, 1, 0}, {last, last + 1, last + 2, last + 3}};
  for (mesh::Index k = 0; k < last; k += 4)
    for (mesh::Index i = 0; i < 4; ++i)
      result.quads.push_back({k + i, k + (i + 1) % 4, k + 4 + (i + 1) % 4, k + 4 + i});
  return result;
}

/// Across the axis z, from (x, y, z) on.
std::array<Vec, 4> ring(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t side) {
  return {Vec{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}};
}

std::int64_t below(std::mt19937_64& random, std::int64_t n) {
  return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(n));
}

Vec random_vector(std::mt19937_64& random, std::int64_t range) {
  Vec result{};
  for (std::int64_t& x : result) x = below(random, 2 * range + 1) - range;
  return result;
}

TEST(SelfMeeting, Boxes) {
  EXPECT_EQ(found_in({}), std::nullopt);
  EXPECT_EQ(found_in(tube({ring(0, 0, 0, 1), ring(0, 0, 1, 1)})), std::nullopt);
  EXPECT_EQ(found_in(tube({ring(0, 0, 0, 2), ring(0, 0, 1, 1), ring(1, 1, 5, 3)})), std::nullopt);
  // The upper end is turned over inside out: its sides cross in one point each, in pairs.
  EXPECT_NE(found_in(tube({ring(0, 0, 0, 2),
                           {ring(0, 0, 2, 2)[2], ring(0, 0, 2, 2)[3], ring(0, 0, 2, 2)[0],
                            ring(0, 0, 2, 2)[1]}})),
            std::nullopt);
}

/// A foot with its top in z = 2, and a tube from it up, over, and down again to z = bottom.
IntegerSurface hook(std::int64_t bottom) {
  return tube({ring(-1, -1, 0, 11),
               ring(-1, -1, 2, 11),
               ring(0, 0, 2, 2),
               ring(0, 0, 7, 2),
               {Vec{3, 0, 10}, {3, 0, 8}, {3, 2, 8}, {3, 2, 10}},
               {Vec{8, 0, 10}, {6, 0, 8}, {6, 2, 8}, {8, 2, 10}},
               {Vec{8, 0, bottom}, {6, 0, bottom}, {6, 2, bottom}, {8, 2, bottom}}});
}

TEST(SelfMeeting, TubesThatComeBack) {
  EXPECT_EQ(found_in(hook(3)), std::nullopt);
  EXPECT_EQ(by_brute_force(hook(3)), std::nullopt);
  // The end lies on the top of the foot; it pierces the top; it comes out below.
  for (const std::int64_t bottom : {2, 1, 0, -1}) {
    EXPECT_NE(found_in(hook(bottom)), std::nullopt) << bottom;
    EXPECT_EQ(found_in(hook(bottom)), by_brute_force(hook(bottom))) << bottom;
  }
  EXPECT_EQ(found_in(hook(2)), (SelfMeeting{1, 7}));  // the end and one side of the top
  EXPECT_EQ(found_in(hook(0)), (SelfMeeting{0, 1}));
}

TEST(SelfMeeting, TouchesInAPoint) {
  IntegerSurface surface = hook(3);
  const auto lowered = [&](std::size_t v, const Vec& p) {
    IntegerSurface result = surface;
    result.points[v] = p;
    return result;
  };
  const std::size_t v = surface.points.size() - 1;
  // Into the inside of a facet of the foot; on an edge of it; to another vertex; just above.
  const IntegerSurface in_facet = lowered(v, {8, 3, 2});
  EXPECT_EQ(found_in(in_facet), by_brute_force(in_facet));
  ASSERT_NE(found_in(in_facet), std::nullopt);
  for (const Vec& p : {Vec{7, 7, 2}, Vec{2, 2, 2}, Vec{5, 5, 2}}) {
    const IntegerSurface touching = lowered(v, p);
    EXPECT_EQ(found_in(touching), by_brute_force(touching));
    EXPECT_NE(found_in(touching), std::nullopt);
  }
  SurfaceMesh above = with_doubles(in_facet);
  above.points[v].z = std::nextafter(2.0, 3.0);
  EXPECT_EQ(first_self_meeting(above), std::nullopt);
}

TEST(SelfMeeting, EqualPointsOfDifferentVertices) {
  IntegerSurface surface{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {-1, -1, 1}, {0, -1, 0}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  EXPECT_EQ(found_in(surface), (SelfMeeting{0, 1}));
  surface.quads[1][0] = 0;
  EXPECT_EQ(found_in(surface), std::nullopt);
}

/// A square and another quad on the same edge, whose other corners are given.
TEST(SelfMeeting, FoldedAlongAnEdge) {
  const auto folded = [](const Vec& far, const Vec& near) {
    const IntegerSurface surface{{{0, 0, 0}, {0, 1, 0}, {2, 1, 0}, {2, 0, 0}, far, near},
                                 {{0, 1, 2, 3}, {1, 0, 5, 4}}};
    EXPECT_EQ(found_in(surface), by_brute_force(surface));
    return found_in(surface).has_value();
  };
  EXPECT_FALSE(folded({-1, 1, 0}, {-1, 0, 0}));
  EXPECT_FALSE(folded({0, 1, 1}, {0, 0, 1}));
  EXPECT_FALSE(folded({8, 1, 1}, {8, 0, 1}));
  EXPECT_TRUE(folded({1, 1, 0}, {1, 0, 0}));   // on one another
  EXPECT_TRUE(folded({3, 2, 0}, {4, -1, 0}));  // on one another, the other one in
  EXPECT_TRUE(folded({3, 1, 1}, {3, 0, 0}));   // an edge on it, from the common edge on
  EXPECT_FALSE(folded({3, 1, 1}, {3, 0, 1}));
  EXPECT_TRUE(folded({3, 1, 1}, {3, 1, -1}));  // through it
}

TEST(SelfMeeting, TwistedQuadHitByAnEdge) {
  // z = x y / 4 over a square of side 4, and a thin quad that crosses its height at (2, 2).
  const auto hit = [](std::int64_t low, std::int64_t high) {
    const IntegerSurface surface{{{0, 0, 0},
                                  {4, 0, 0},
                                  {4, 4, 4},
                                  {0, 4, 0},
                                  {2, 2, low},
                                  {2, 2, high},
                                  {2, 3, high},
                                  {2, 3, low}},
                                 {{0, 1, 2, 3}, {4, 5, 6, 7}}};
    return found_in(surface).has_value();
  };
  EXPECT_TRUE(hit(0, 3));
  EXPECT_TRUE(hit(1, 3));  // the corner is on the patch; the plane of no three corners has it
  EXPECT_TRUE(hit(-3, 1));
  EXPECT_FALSE(hit(2, 4));
  EXPECT_FALSE(hit(-4, 0));
}

TEST(SelfMeeting, FoldedQuadsComeFirst) {
  IntegerSurface surface = hook(1);
  EXPECT_NE(found_in(surface), std::nullopt);
  surface.points.push_back({100, 100, 100});
  const auto p = static_cast<mesh::Index>(surface.points.size());
  for (const Vec& q : {Vec{102, 100, 100}, Vec{101, 101, 100}, Vec{100, 102, 100}})
    surface.points.push_back(q);
  surface.quads.push_back({p - 1, p, p + 1, p + 2});
  const auto last = static_cast<std::uint32_t>(surface.quads.size() - 1);
  ASSERT_EQ(found_in(surface), (SelfMeeting{last, last}));
  EXPECT_TRUE(found_in(surface)->is_folded_quad());
}

Quad turned(Quad quad, std::size_t by, bool over) {
  std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(by), quad.end());
  if (over) std::swap(quad[1], quad[3]);
  return quad;
}

SurfaceMesh disguised(const SurfaceMesh& surface, std::mt19937_64& random) {
  std::vector<mesh::Index> number(surface.points.size());
  std::iota(number.begin(), number.end(), 0U);
  std::shuffle(number.begin(), number.end(), random);
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::shuffle(axes.begin(), axes.end(), random);
  const std::array<double, 3> scale{std::ldexp(1, static_cast<int>(below(random, 1900)) - 1000),
                                    std::ldexp(-1, static_cast<int>(below(random, 1900)) - 1000),
                                    0};
  const double factor = scale[random() % 2];
  SurfaceMesh result;
  result.points.resize(surface.points.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    const mesh::Point& p = surface.points[i];
    const std::array<double, 3> x{p.x, p.y, -p.z};
    result.points[number[i]] = {factor * x[axes[0]], factor * x[axes[1]], factor * x[axes[2]]};
  }
  for (Quad quad : surface.quads) {
    for (mesh::Index& v : quad) v = number[v];
    result.quads.push_back(turned(quad, random() % 4, random() % 2 == 0));
  }
  return result;
}

TEST(SelfMeeting, RandomSurfacesAgainstBruteForce) {
  std::mt19937_64 random(5);
  int none = 0;
  int folded = 0;
  int pairs = 0;
  for (int round = 0; round < support::share_of(2500); ++round) {
    const std::int64_t step = 1 + round % 3;
    std::vector<std::array<Vec, 4>> rings;
    for (std::int64_t k = 0; k < 2 + round % 3; ++k) {
      rings.push_back(ring(-1, -1, step * k - 2, 2));
      for (Vec& p : rings.back())
        if (below(random, 3) == 0) {
          const Vec by = random_vector(random, 1);
          for (std::size_t i = 0; i < 3; ++i) p[i] += by[i];
        }
    }
    IntegerSurface surface = tube(rings);
    std::shuffle(surface.quads.begin(), surface.quads.end(), random);
    const Found expected = by_brute_force(surface);
    ASSERT_EQ(found_in(surface), expected) << round;
    ASSERT_EQ(first_self_meeting(disguised(with_doubles(surface), random)), expected) << round;
    if (!expected)
      ++none;
    else if (expected->is_folded_quad())
      ++folded;
    else
      ++pairs;
  }
  EXPECT_GT(none, support::share_of(150));
  EXPECT_GT(folded, support::share_of(150));
  EXPECT_GT(pairs, support::share_of(150));
}

QuadPoints random_flat_quad(std::mt19937_64& random, const std::vector<Vec>& given) {
  while (true) {
    QuadPoints q{};
    for (std::size_t i = 0; i < 4; ++i)
      q[i] = i < given.size() ? given[i] : random_vector(random, 2);
    if (random() % 2 == 0)
      for (std::size_t k = 0; k < 3; ++k) q[3][k] = q[0][k] + q[2][k] - q[1][k];
    if (oracle::is_flat(q) && oracle::is_strictly_convex(q)) return q;
  }
}

/// Here every common point counts, not those of edges only.
TEST(SelfMeeting, PairsOfFlatQuads) {
  std::mt19937_64 random(6);
  std::array<int, 2> count{};
  for (int round = 0; round < 20'000; ++round) {
    const std::size_t shared = static_cast<std::size_t>(round) % 3;
    const QuadPoints a = random_flat_quad(random, {});
    const QuadPoints b =
        random_flat_quad(random, {a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shared)});
    IntegerSurface surface;
    surface.points.assign(a.begin(), a.end());
    surface.points.insert(surface.points.end(), b.begin(), b.end());
    surface.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    for (std::size_t i = 0; i < shared; ++i) surface.quads[1][i] = static_cast<mesh::Index>(i);
    const auto is_shared = [&](const Vec& p, std::int64_t w) {
      Vec from{};
      Vec to{};
      for (std::size_t k = 0; k < 3; ++k) {
        from[k] = p[k] - w * a[0][k];
        to[k] = p[k] - w * a[shared == 2 ? 1 : 0][k];
      }
      if (shared == 0) return false;
      return oracle::cross(from, to) == Vec{} && oracle::dot(from, to) <= 0;
    };
    const bool expected = oracle::flat_quads_meet(a, b, is_shared);
    ASSERT_EQ(found_in(surface), expected ? Found(SelfMeeting{0, 1}) : std::nullopt) << round;
    ++count[expected ? 1 : 0];
  }
  EXPECT_GT(count[0], 2000);
  EXPECT_GT(count[1], 2000);
}

TEST(SelfMeeting, SharedCornersAcross) {
  // Two flat quads that share a diagonal of one, an edge of the other: one lies on the other.
  IntegerSurface surface{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {3, 3, 1}, {1, 1, 1}},
                         {{0, 1, 2, 3}, {0, 2, 4, 5}}};
  EXPECT_EQ(found_in(surface), (SelfMeeting{0, 1}));
  surface.points[2] = {2, 2, 1};  // the diagonal leaves the patch
  EXPECT_EQ(found_in(surface), by_brute_force(surface));
  // All corners shared: nothing but edges in common; in another order, edges are diagonals.
  surface = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}}, {{0, 1, 2, 3}, {0, 1, 2, 3}}};
  EXPECT_EQ(found_in(surface), std::nullopt);
  surface.quads[1] = {0, 2, 1, 3};
  EXPECT_EQ(found_in(surface), by_brute_force(surface));
}

/// Large enough for the tree of boxes to have many levels.
SurfaceMesh bumpy_torus(std::size_t n, std::size_t m) {
  SurfaceMesh result;
  const auto angle = [](std::size_t i, std::size_t of) {
    return 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(of);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const double tube = 1 + 0.1 * std::sin(5 * angle(i, n)) * std::cos(3 * angle(j, m));
      const double r = 3 + tube * std::cos(angle(j, m));
      result.points.push_back(
          {r * std::cos(angle(i, n)), r * std::sin(angle(i, n)), tube * std::sin(angle(j, m))});
    }
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<mesh::Index>((i % n) * m + j % m);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      result.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return result;
}

TEST(SelfMeeting, LargeSurfaces) {
  SurfaceMesh surface = bumpy_torus(150, 60);
  EXPECT_EQ(first_self_meeting(surface), std::nullopt);
  surface.points[75 * 60 + 15] = {-3, 0, 3};  // a spike
  EXPECT_EQ(first_self_meeting(surface), std::nullopt);
  // Through the whole tube.
  surface.points[75 * 60 + 15] = {-3, 0, -2};
  const Found pierced = first_self_meeting(surface);
  ASSERT_NE(pierced, std::nullopt);
  std::mt19937_64 random(7);
  for (int k = 0; k < support::share_of(4, 1); ++k)
    EXPECT_EQ(first_self_meeting(disguised(surface, random)), pierced);
}

TEST(SelfMeeting, RefusesIndicesBeyondThePoints) {
  const SurfaceMesh surface{{{0, 0, 0}}, {{0, 1, 2, 3}}, {}};
  EXPECT_THROW(static_cast<void>(first_self_meeting(surface)), core::PreconditionViolated);
}

}  // namespace
}  // namespace hexatlas::quality
