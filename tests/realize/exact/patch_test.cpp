/// Claim. `meets` is exact for segments and bilinear patches that are not folded, in every special
/// position; `is_folded` is exact; `separated` is never wrong, and does not give up on easy pairs.
/// Neither depends on scale, on the corner a quad begins with, or on names of axes.
/// Oracle. tests/oracles/patches.hpp, by other equations and numbers; points of a patch that are
/// made from (s, t); cases whose answer is evident.
#include "realize/exact/patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "enum/core/errors.hpp"
#include "realize/exact/patch_separation.hpp"
#include "tests/oracles/patches.hpp"
#include "tests/share.hpp"

namespace hexatlas::exact {
namespace {

using oracle::QuadPoints;
using oracle::SegmentPoints;
using oracle::Vec;

Point3 as_point(const Vec& v, double scale = 1) {
  return {scale * static_cast<double>(v[0]), scale * static_cast<double>(v[1]),
          scale * static_cast<double>(v[2])};
}

Patch as_patch(const QuadPoints& q, double scale = 1) {
  return {as_point(q[0], scale), as_point(q[1], scale), as_point(q[2], scale),
          as_point(q[3], scale)};
}

Segment as_segment(const SegmentPoints& g, double scale = 1) {
  return {as_point(g.from, scale), as_point(g.to, scale), g.without_from, g.without_to};
}

class RandomPlaces {
 public:
  explicit RandomPlaces(std::uint64_t seed) : random_(seed) {}
  std::int64_t number(std::int64_t range) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(2 * range + 1)) - range;
  }
  Vec point(std::int64_t range) { return {number(range), number(range), number(range)}; }
  QuadPoints quad(std::int64_t range) {
    return {point(range), point(range), point(range), point(range)};
  }
  /// Flat ones are rare among all.
  QuadPoints flat_quad(std::int64_t range) {
    QuadPoints q = quad(range);
    while (!oracle::is_flat(q) || !oracle::is_strictly_convex(q)) {
      q = quad(range);
      if (number(1) == 0) {
        const Vec d = oracle::minus(q[1], q[0]);
        for (std::size_t k = 0; k < 3; ++k) q[3][k] = q[2][k] - d[k];
      }
    }
    return q;
  }

 private:
  std::mt19937_64 random_;
};

/// The patch's equation has the same answer for each way to write the same.
void expect_same_in_all_forms(const SegmentPoints& g, const QuadPoints& q, bool expected) {
  const auto fails = [&](const SegmentPoints& segment, const QuadPoints& quad, double scale) {
    return meets(as_segment(segment, scale), as_patch(quad, scale)) != expected;
  };
  ASSERT_FALSE(fails(g, q, 1));
  ASSERT_FALSE(fails({g.to, g.from, g.without_to, g.without_from}, q, 0x1p-30));
  ASSERT_FALSE(fails(g, {q[1], q[2], q[3], q[0]}, 0x1p900));
  ASSERT_FALSE(fails(g, {q[3], q[2], q[1], q[0]}, 0x1p-1060));
  const auto turned = [](const Vec& v) { return Vec{v[2], -v[0], v[1]}; };
  ASSERT_FALSE(fails({turned(g.from), turned(g.to), g.without_from, g.without_to},
                     {turned(q[2]), turned(q[3]), turned(q[0]), turned(q[1])}, 3));
}

TEST(Patch, SegmentsInSmallPlaces) {
  RandomPlaces places(1);
  int flat = 0;
  int met = 0;
  for (int round = 0; round < support::share_of(30'000); ++round) {
    const std::int64_t range = 1 + round % 3;
    const bool wants_flat = round % 2 == 0;
    const QuadPoints q = wants_flat ? places.flat_quad(range) : places.quad(range);
    if (oracle::is_flat(q) && !oracle::is_strictly_convex(q)) continue;
    SegmentPoints g{places.point(range), places.point(range)};
    const int kind = round % 5;
    if (kind == 1) g.from = q[0];
    if (kind == 2) {
      g.from = q[0];
      g.without_from = true;
    }
    if (kind == 3) {
      g.to = q[1];
      g.without_to = true;
    }
    if (kind == 4) {
      g = {q[0], q[2], true, true};
    }
    if (g.from == g.to) continue;
    const bool expected = oracle::meets(g, q);
    flat += oracle::is_flat(q) ? 1 : 0;
    met += expected ? 1 : 0;
    expect_same_in_all_forms(g, q, expected);
    if (HasFatalFailure()) {
      ADD_FAILURE() << "round " << round;
      return;
    }
  }
  EXPECT_GT(flat, support::share_of(5000));
  EXPECT_GT(met, support::share_of(5000));
}

/// Segments through points x(i/4, j/4), everything times 16.
TEST(Patch, SegmentsThroughPointsOfThePatch) {
  RandomPlaces places(2);
  for (int round = 0; round < 4000; ++round) {
    QuadPoints q = round % 2 == 0 ? places.flat_quad(2) : places.quad(2);
    if (oracle::is_flat(q) && !oracle::is_strictly_convex(q)) continue;
    const std::int64_t i = round % 5;
    const std::int64_t j = round / 5 % 5;
    Vec x{};
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = (4 - i) * (4 - j) * q[0][k] + i * (4 - j) * q[1][k] + i * j * q[2][k] +
             (4 - i) * j * q[3][k];
      for (Vec& corner : q) corner[k] *= 16;
    }
    Vec d = places.point(5);
    if (d == Vec{}) d = {1, 0, 0};
    const auto at = [&](std::int64_t u) {
      return Vec{x[0] + u * d[0], x[1] + u * d[1], x[2] + u * d[2]};
    };
    EXPECT_TRUE(meets(as_segment({at(-1), at(2)}), as_patch(q)));
    EXPECT_TRUE(meets(as_segment({at(0), at(3)}), as_patch(q)));
    EXPECT_TRUE(meets(as_segment({at(-7), at(0)}), as_patch(q)));
  }
}

/// z = x y over the unit square.
constexpr QuadPoints kSaddle{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}};

TEST(Patch, Saddle) {
  const Patch saddle = as_patch(kSaddle);
  const auto is_met = [&](const Point3& from, const Point3& to, bool without_from = false,
                          bool without_to = false) {
    return meets({from, to, without_from, without_to}, saddle);
  };
  EXPECT_TRUE(is_met({0.5, 0.5, 0}, {0.5, 0.5, 0.25}));  // to a point of it
  EXPECT_FALSE(is_met({0.5, 0.5, 0}, {0.5, 0.5, std::nextafter(0.25, 0)}));
  EXPECT_TRUE(is_met({0.5, 0.5, 1}, {0.5, 0.5, 0.25}));
  EXPECT_TRUE(is_met({0, 0.5, -1}, {0, 0.5, 1}));  // through an edge
  EXPECT_FALSE(is_met({-0x1p-60, 0.5, -1}, {-0x1p-60, 0.5, 1}));
  EXPECT_FALSE(is_met({2, 2, 4}, {2, 3, 6}));             // on the quadric, beyond the patch
  EXPECT_FALSE(is_met({0.5, 1.5, 0.75}, {0.5, 3, 1.5}));  // along a ruling
  EXPECT_TRUE(is_met({0.5, 1, 0.5}, {0.5, 3, 1.5}));
  EXPECT_TRUE(is_met({0.5, -1, -0.5}, {0.5, 3, 1.5}));
  EXPECT_TRUE(is_met({0.5, 0.25, 0.125}, {0.5, 0.5, 0.25}));
  EXPECT_TRUE(is_met({0, 0, 0}, {0, 1, 0}));
  EXPECT_TRUE(is_met({0, 0, 0}, {0, 1, 0}, true, true));
  EXPECT_FALSE(is_met({0, 0, 0}, {0, -1, 0}, true));
  EXPECT_TRUE(is_met({0, 0, 0}, {0, -1, 0}));
  // From corner to corner: under the diagonal x = y, z = x^2 lies the chord z = x above.
  EXPECT_TRUE(is_met({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(is_met({0, 0, 0}, {1, 1, 1}, true));
  EXPECT_FALSE(is_met({0, 0, 0}, {1, 1, 1}, true, true));
  // Twice through it, at x = y with z = x - 3/16: x = 1/4 and x = 3/4. Tangent at z = x - 1/4.
  EXPECT_TRUE(is_met({0.375, 0.375, 0.1875}, {0.875, 0.875, 0.6875}));
  EXPECT_FALSE(is_met({0.375, 0.375, 0.1875}, {0.625, 0.625, 0.4375}));
  EXPECT_TRUE(is_met({0, 0, -0.25}, {1, 1, 0.75}));
  EXPECT_FALSE(is_met({0, 0, -0.25 - 0x1p-50}, {1, 1, 0.75 - 0x1p-50}));
  EXPECT_FALSE(is_met({0, 0, -0.25}, {0.25, 0.25, 0}));
  // z = x - 1/8: the roots (1 +- sqrt(1/2)) / 2 are not rational.
  EXPECT_TRUE(is_met({0, 0, -0.125}, {1, 1, 0.875}));
  EXPECT_TRUE(is_met({0.5, 0.5, 0.375}, {1, 1, 0.875}));
  EXPECT_FALSE(is_met({0.25, 0.25, 0.125}, {0.75, 0.75, 0.625}));
  // Tangent at a corner that is left out, with a double root there: z = 0 along x = -y.
  EXPECT_FALSE(is_met({0, 0, 0}, {1, -1, 0}, true));
  EXPECT_FALSE(is_met({0, 0, 0}, {-1, -1, -1}, true));
}

TEST(Patch, FoldedQuads) {
  const auto folded = [](const QuadPoints& q) { return is_folded(as_patch(q)); };
  EXPECT_FALSE(folded(kSaddle));
  EXPECT_FALSE(folded({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
  EXPECT_TRUE(folded({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}));  // crossed edges
  EXPECT_TRUE(folded({{{0, 0, 0}, {3, 0, 0}, {1, 1, 0}, {0, 3, 0}}}));  // a reentrant corner
  EXPECT_TRUE(folded({{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}}}));  // 180 degrees
  EXPECT_TRUE(folded({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}}}));  // equal opposite corners
  EXPECT_TRUE(folded({{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));  // an edge of length zero
  EXPECT_TRUE(folded({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));  // edges on one another
  EXPECT_TRUE(folded({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}}));  // on a line
  EXPECT_TRUE(folded({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}));
  RandomPlaces places(3);
  for (int round = 0; round < 20'000; ++round) {
    QuadPoints q = places.quad(1 + round % 3);
    if (round % 2 == 0) q[0][2] = q[1][2] = q[2][2] = q[3][2];
    const bool expected = oracle::is_flat(q) && !oracle::is_strictly_convex(q);
    ASSERT_EQ(folded(q), expected);
    ASSERT_EQ(folded({q[1], q[2], q[3], q[0]}), expected);
    ASSERT_EQ(is_folded(as_patch(q, 0x1p1000)), expected);
    ASSERT_EQ(is_folded(as_patch(q, 0x1p-1070)), expected);
  }
}

TEST(Patch, RefusesWhatItDoesNotTake) {
  const Patch folded = as_patch({{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}});
  EXPECT_THROW(static_cast<void>(meets({{0, 0, 0}, {1, 0, 0}}, folded)),
               core::PreconditionViolated);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(meets({{0, 0, 0}, {infinite, 0, 0}}, as_patch(kSaddle))),
               core::PreconditionViolated);
  EXPECT_THROW(static_cast<void>(is_folded({Point3{infinite, 0, 0}})), core::PreconditionViolated);
}

constexpr Twins kNoTwins{kNoTwin, kNoTwin, kNoTwin, kNoTwin};

/// What the filter proves is not contradicted by edges that meet.
TEST(Separation, IsNeverWrong) {
  RandomPlaces places(4);
  int separate = 0;
  for (int round = 0; round < 40'000; ++round) {
    const QuadPoints a = round % 3 == 0 ? places.flat_quad(2) : places.quad(2);
    QuadPoints b = round % 5 == 0 ? places.flat_quad(2) : places.quad(2);
    Twins twin = kNoTwins;
    const int shared = round % 4;
    if (shared >= 1) {
      b[0] = a[0];
      twin[0] = 0;
    }
    if (shared >= 2) {
      b[3] = a[1];
      twin[1] = 3;
    }
    const auto is_bad = [](const QuadPoints& q) {
      return oracle::is_flat(q) && !oracle::is_strictly_convex(q);
    };
    if (is_bad(a) || is_bad(b)) continue;
    if (!separated(as_patch(a), as_patch(b), twin)) continue;
    ++separate;
    for (const bool first : {true, false}) {
      const QuadPoints& p = first ? a : b;
      const QuadPoints& q = first ? b : a;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        const auto is_shared = [&](std::size_t k) {
          return (shared >= 1 && k == 0) || (shared >= 2 && k == (first ? 1U : 3U));
        };
        if (is_shared(i) && is_shared(j)) continue;
        ASSERT_FALSE(oracle::meets({p[i], p[j], is_shared(i), is_shared(j)}, q)) << round;
      }
    }
  }
  EXPECT_GT(separate, 2000);
}

TEST(Separation, IsFoundForNeighboursInAGrid) {
  const Patch a = as_patch({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  EXPECT_TRUE(separated(a, as_patch({{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}}),
                        {kNoTwin, 0, 3, kNoTwin}));
  EXPECT_TRUE(separated(a, as_patch({{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}}}),
                        {kNoTwin, 0, 3, kNoTwin}));
  EXPECT_TRUE(separated(a, as_patch({{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}}),
                        {kNoTwin, kNoTwin, 0, kNoTwin}));
  EXPECT_TRUE(separated(a, as_patch({{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}), kNoTwins));
  EXPECT_FALSE(separated(a, a, kNoTwins));
  EXPECT_FALSE(separated(a, a, {0, 1, 2, 3}));
}

TEST(Separation, GivesUpWhereNothingCanBeComputed) {
  const double huge = std::numeric_limits<double>::max();
  const Patch a{Point3{-huge, -huge, 0}, {huge, -huge, 0}, {huge, huge, 0}, {-huge, huge, 0}};
  Patch b = a;
  for (Point3& p : b) p.z = huge;
  EXPECT_FALSE(separated(a, b, kNoTwins));
  EXPECT_FALSE(separated(Patch{}, Patch{}, kNoTwins));
}

}  // namespace
}  // namespace hexatlas::exact
