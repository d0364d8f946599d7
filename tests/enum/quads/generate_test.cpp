// Claim. The generator visits one quadrangulation of each class, with the order of its group; its
// sums are right; shards are disjoint and together the whole; it stops when told to.
// Oracle. All simple quadrangulations by vertex splits, kept in a map by canonical code: the same
// sets of codes and the same groups. The published counts [A007022], [A078666] and those of
// plantri; Tutte's formula for rooted simple maps; rooted 3-connected counts by substitution into
// c-nets. For irregularities, degrees counted in lists of quads. Among themselves: the 3-connected
// ones are those of minimum degree 3 that pass the linear test.
#include "enum/quads/generate.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "enum/core/errors.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using quads::Class;
using quads::Sums;

// How many quads are gone to.
constexpr int kSplitQuads = support::by_length(10, 12);
constexpr int kCodedSimple = support::by_length(11, 14);
constexpr int kSimple = support::by_length(13, 16);
constexpr int kConnected = support::by_length(19, 22);

constexpr std::array kClasses{Class::simple, Class::min_degree_3, Class::three_connected};

bool is_in(const complex::Quadrangulation& q, Class which) {
  if (which == Class::three_connected) return q.is_three_connected();
  const auto degrees = q.degrees();
  const auto least = *std::min_element(degrees.begin(), degrees.begin() + q.vertices());
  return which == Class::simple || least >= 3;
}

Sums sums_of(const complex::Quadrangulation& q) {
  const auto form = canon::canonical_form(q);
  return {1, form.automorphisms == form.rotations ? 2U : 1U,
          static_cast<std::uint64_t>(8 * q.quads() / form.automorphisms), true};
}

/// The codes of all maps visited; each must be new, valid, in the class, and have the group stated.
struct Collector {
  Class which;
  int size;
  std::set<canon::Code> codes;

  void operator()(const complex::Quadrangulation& q, int automorphisms, int rotations) {
    ASSERT_FALSE(q.validate());
    ASSERT_EQ(q.quads(), size);
    EXPECT_TRUE(is_in(q, which));
    const auto form = canon::canonical_form(q);
    EXPECT_TRUE(codes.insert(form.code).second) << canon::to_text(form.code);
    EXPECT_EQ(automorphisms, form.automorphisms) << canon::to_text(form.code);
    EXPECT_EQ(rotations, form.rotations) << canon::to_text(form.code);
  }
};

TEST(Generate, SameCodesAndSumsAsVertexSplits) {
  auto level = support::four_cycle_class();
  for (int n = 2; n <= kSplitQuads; ++n) {
    if (n > 2) level = support::grown(level);
    for (const Class which : kClasses) {
      std::set<canon::Code> expected;
      Sums expected_sums;
      for (const auto& [code, map] : level) {
        const auto q = support::quadrangulation(map);
        if (!is_in(q, which)) continue;
        expected.insert(code);
        expected_sums += sums_of(q);
      }
      Collector met{which, n, {}};
      EXPECT_EQ(quads::generate(which, n, std::ref(met)), expected_sums) << n;
      EXPECT_EQ(met.codes, expected) << n;
    }
  }
}

TEST(Generate, NoCodeTwiceAndGroupsAreRight) {
  for (const Class which : kClasses)
    for (int n = 2; n <= (which == Class::simple ? kCodedSimple : 16); ++n) {
      Collector met{which, n, {}};
      const Sums sums = quads::generate(which, n, std::ref(met));
      EXPECT_EQ(sums.classes, met.codes.size());
      EXPECT_EQ(sums, quads::generate(which, n));
    }
}

TEST(Generate, ThreeConnectedAreThoseOfMinimumDegree3ThatPassTheTest) {
  for (int n = 6; n <= kConnected; ++n) {
    Sums filtered;
    quads::generate(Class::min_degree_3, n,
                    [&](const complex::Quadrangulation& q, int automorphisms, int rotations) {
                      if (q.is_three_connected())
                        filtered += {1, automorphisms == rotations ? 2U : 1U,
                                     static_cast<std::uint64_t>(8 * n / automorphisms), true};
                    });
    EXPECT_EQ(quads::generate(Class::three_connected, n), filtered) << n;
  }
}

struct Row {
  std::uint64_t min_degree_3, three_connected, orientation_preserving;
};
const std::map<int, Row> kPublished{{6, {1, 1, 1}},
                                    {7, {0, 0, 0}},
                                    {8, {1, 1, 1}},
                                    {9, {1, 1, 1}},
                                    {10, {3, 3, 4}},
                                    {11, {3, 3, 3}},
                                    {12, {12, 11, 15}},
                                    {13, {19, 18, 25}},
                                    {14, {64, 58, 92}},
                                    {15, {155, 139, 234}},
                                    {16, {510, 451, 803}},
                                    {17, {1514, 1326, 2469}},
                                    {18, {5146, 4461, 8512}},
                                    {19, {16966, 14554, 28290}},
                                    {20, {58782, 49957, 98148}},
                                    {21, {203269, 171159, 338673}},
                                    {22, {716607, 598102, 1188338}}};

TEST(Generate, NoneIsMoreIrregularThanATrapezohedron) {
  int at_bound = 0;
  for (int n = 6; n <= 16; ++n)
    (void)quads::generate(Class::three_connected, n,
                          [&](const complex::Quadrangulation& q, int automorphisms, int) {
                            const int irregularity = support::irregularity_of(q);
                            EXPECT_EQ(q.irregularity(), irregularity);
                            const int bound = (n - 8) * (n - 8) + 2 * n;
                            EXPECT_LE(2 * irregularity, bound);
                            if (2 * irregularity < bound) return;
                            ++at_bound;
                            EXPECT_EQ(automorphisms, n == 6 ? 48 : 2 * n) << "a trapezohedron";
                          });
  EXPECT_EQ(at_bound, 6) << "one for each even number";
}

TEST(Generate, SimpleZonesAreClassesOfOppositeEdges) {
  std::map<int, int> boundaries;  // for each number of simple zones
  for (int n = 6; n <= 16; ++n)
    (void)quads::generate(Class::three_connected, n,
                          [&](const complex::Quadrangulation& q, int, int) {
                            const int simple = support::simple_zones_of(q);
                            EXPECT_EQ(q.simple_zones(), simple);
                            ++boundaries[simple];
                          });
  EXPECT_GT(boundaries[0], 10);
  EXPECT_GE(boundaries.rbegin()->first, 4) << "some have many";
}

TEST(Generate, PublishedCounts) {
  for (const auto& [n, row] : kPublished) {
    if (n > kConnected) continue;
    EXPECT_EQ(quads::generate(Class::min_degree_3, n).classes, row.min_degree_3) << n;
    const Sums sums = quads::generate(Class::three_connected, n);
    EXPECT_EQ(sums.classes, row.three_connected) << n;
    EXPECT_EQ(sums.orientation_preserving, row.orientation_preserving) << n;
  }
  const std::vector<std::uint64_t> simple{1,   1,    2,     3,     9,      18,      62,      198,
                                          803, 3378, 15882, 77185, 393075, 2049974, 10938182};
  for (int n = 2; n <= kSimple; ++n) {
    const Sums sums = quads::generate(Class::simple, n);
    EXPECT_EQ(sums.classes, simple[static_cast<std::size_t>(n - 2)]) << n;
    EXPECT_EQ(sums.rooted, oracle::rooted_simple(static_cast<std::uint64_t>(n))) << n;
  }
}

TEST(Generate, RootedSumsOf3ConnectedOnes) {
  const std::vector<std::uint64_t> c_nets{1, 0, 4, 6, 29, 88, 310, 1066, 3700, 13036, 46092};
  for (int n = 2; n <= 16; ++n)
    EXPECT_EQ(quads::generate(Class::three_connected, n).rooted,
              n < 6 ? 0 : c_nets[static_cast<std::size_t>(n - 6)])
        << n;
}

TEST(Generate, ShardsAreDisjointAndTogetherTheWhole) {
  for (const Class which : kClasses)
    for (const int n : {2, 6, 10, which == Class::simple ? 12 : 17})
      for (const std::uint64_t parts : {1U, 2U, 3U, 7U, 100U}) {
        if (n > 10 && parts == 100) continue;
        Sums sum;
        std::set<canon::Code> codes;
        const auto collect = [&](const complex::Quadrangulation& q, int, int) {
          EXPECT_TRUE(codes.insert(canon::canonical_form(q).code).second);
        };
        const bool is_small = n <= 10 || parts == 3;
        for (std::uint64_t part = 0; part < parts; ++part)
          sum += quads::generate(which, n, is_small ? quads::Visit(collect) : quads::Visit(),
                                 {.shard = {part, parts}});
        EXPECT_EQ(sum, quads::generate(which, n)) << n << " in " << parts;
        EXPECT_EQ(codes.size(), is_small ? sum.classes : 0);
      }
}

TEST(Generate, ShardsAreOfLikeSize) {
  const std::uint64_t whole = quads::generate(Class::three_connected, 19).classes;
  for (std::uint64_t part = 0; part < 4; ++part) {
    const Sums sums = quads::generate(Class::three_connected, 19, {}, {.shard = {part, 4}});
    EXPECT_GT(sums.classes, whole / 8);
    EXPECT_LT(sums.classes, whole / 2);
  }
}

TEST(Generate, ManyShardsAreOfLikeSize) {
  // Every quadrangulation of 18 quads is dealt out: 4,461 to 512 parts, nearly 9 to each.
  std::uint64_t least = 100, most = 0;
  for (std::uint64_t part = 0; part < 512; part += 7) {
    const Sums sums = quads::generate(Class::three_connected, 18, {}, {.shard = {part, 512}});
    least = std::min(least, sums.classes);
    most = std::max(most, sums.classes);
  }
  EXPECT_EQ(least, 8U);
  EXPECT_EQ(most, 9U);
}

TEST(Generate, StopsWhenTold) {
  std::atomic<bool> stop{false};
  std::uint64_t met = 0;
  const Sums sums = quads::generate(Class::three_connected, 40,
                                    [&](const complex::Quadrangulation&, int, int) {
                                      if (++met == 1000) stop.store(true);
                                    },
                                    {.stop = &stop});
  EXPECT_FALSE(sums.complete);
  EXPECT_EQ(sums.classes, met);
  EXPECT_LT(met, 2000U);
}

TEST(Generate, RefusesWhatItCannotDo) {
  EXPECT_THROW(quads::generate(Class::simple, 1), core::PreconditionViolated);
  EXPECT_THROW(quads::generate(Class::simple, 65), core::PreconditionViolated);
  EXPECT_THROW(quads::generate(Class::simple, 6, {}, {.shard = {2, 2}}),
               core::PreconditionViolated);
}

}  // namespace
