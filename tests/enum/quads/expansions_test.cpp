// Claim. Expansions make valid maps of the class, and taking them back restores every field; an
// expansion refuted by a rival is never the canonical one; images of darts are the automorphisms.
// Oracle. complex::Quadrangulation::validate(); copies; the full ranking; canon::canonical_form.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/quads/generate.hpp"
#include "enum/quads/planar_map.hpp"
#include "enum/quads/reductions.hpp"
#include "enum/quads/rivals.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using quads::Class;
using quads::Dart;
using quads::PlanarMap;

/// The fields that are in use.
std::vector<int> fields(const PlanarMap& map) {
  std::vector<int> result{map.vertices, map.darts};
  for (std::size_t d = 0; d < static_cast<std::size_t>(map.darts); ++d)
    result.insert(result.end(), {map.origin[d], map.ccw[d], map.cw[d]});
  for (std::size_t v = 0; v < static_cast<std::size_t>(map.vertices); ++v)
    result.insert(result.end(), {map.degree[v], map.first[v]});
  return result;
}

void expect_sound(const PlanarMap& map, int quads) {
  const auto q = quads::quadrangulation_of(map);
  ASSERT_FALSE(q.validate());
  EXPECT_EQ(q.quads(), quads);
  const auto degrees = q.degrees();
  for (std::size_t v = 0; v < static_cast<std::size_t>(map.vertices); ++v) {
    EXPECT_EQ(map.degree[v], degrees[v]);
    EXPECT_EQ(map.origin[map.first[v]], v);
  }
}

/// Calls visit(map) for scrambled copies of all maps of a class with up to `most` quads.
template <class Visit>
void each_map(Class which, int most, Visit&& visit) {
  support::Random random(5);
  for (int n = 2; n <= most; ++n)
    quads::generate(which, n, [&](const complex::Quadrangulation& q, int, int) {
      visit(quads::planar_map_of(support::scrambled(q, random, random.coin())));
    });
}

TEST(Expansions, AreSoundAndTakenBackExactly) {
  each_map(Class::simple, 8, [](PlanarMap map) {
    const auto before = fields(map);
    const int n = map.quads();
    for (int i = 0; i < map.darts; ++i) {
      const auto d = static_cast<Dart>(i);
      const Dart s = map.expand_p0(d);
      expect_sound(map, n + 1);
      EXPECT_EQ(map.degree[map.origin[s]], 2);
      map.reduce_p0();
      EXPECT_EQ(fields(map), before);
      const Dart inner = map.expand_p3(d);
      expect_sound(map, n + 4);
      EXPECT_EQ(quads::p3_corners(map, inner)[0], map.origin[d]);
      map.reduce_p3();
      EXPECT_EQ(fields(map), before);
      if (map.degree[map.origin[d]] < 3) continue;
      const Dart first = map.expand_p1(d);
      expect_sound(map, n + 1);
      EXPECT_EQ(map.degree[map.origin[d]], 3);
      EXPECT_EQ(map.origin[d], map.vertices - 1);
      map.reduce_p1(d, first);
      EXPECT_EQ(fields(map), before);
    }
  });
}

template <Class kClass>
void expect_harmless_rivals(int most) {
  std::size_t refuted = 0;
  each_map(kClass, most, [&refuted](PlanarMap map) {
    const quads::P1Rivals<kClass> rivals(map);
    const int parent_twos =
        static_cast<int>(std::count(map.degree.begin(), map.degree.begin() + map.vertices, 2));
    for (int i = 0; i < map.darts; ++i) {
      const auto h = static_cast<Dart>(i);
      if (map.degree[map.origin[h]] <= 3 || parent_twos > 2 || !rivals.refute(map, h)) continue;
      const Dart first = map.expand_p1(h);
      const auto q = quads::quadrangulation_of(map);
      const bool has_twos =
          std::count(map.degree.begin(), map.degree.begin() + map.vertices, 2) != 0;
      if (!has_twos && (kClass != Class::three_connected || q.is_three_connected())) {
        ++refuted;
        quads::FlagList flags;
        EXPECT_EQ(quads::best_p1_flags<kClass>(map, h, flags), 0U);
      }
      map.reduce_p1(h, first);
    }
  });
  EXPECT_GT(refuted, 100U);
}

TEST(Rivals, RefuteNoCanonicalP1) {
  expect_harmless_rivals<Class::simple>(11);
  expect_harmless_rivals<Class::min_degree_3>(16);
  expect_harmless_rivals<Class::three_connected>(16);
}

TEST(Rivals, RefuteNoCanonicalP0) {
  std::size_t refuted = 0;
  each_map(Class::simple, 9, [&refuted](PlanarMap map) {
    const quads::P0Rivals rivals(map);
    for (int i = 0; i < map.darts; ++i) {
      const auto p = static_cast<Dart>(i);
      if (!rivals.refute(map, p)) continue;
      ++refuted;
      const Dart s = map.expand_p0(p);
      quads::FlagList flags;
      EXPECT_EQ(quads::best_p0_flags(map, s, flags), 0U);
      map.reduce_p0();
    }
  });
  EXPECT_GT(refuted, 100U);
}

TEST(Symmetry, ImagesAreTheAutomorphisms) {
  each_map(Class::simple, 8, [](const PlanarMap& map) {
    quads::FlagList all;
    for (int d = 0; d < map.darts; ++d)
      for (const bool mirrored : {false, true}) all.push_back({static_cast<Dart>(d), mirrored});
    quads::Symmetry symmetry;
    ASSERT_TRUE(quads::least_is_ours(map, all, all.size(), symmetry));
    const auto form = canon::canonical_form(quads::quadrangulation_of(map));
    EXPECT_EQ(symmetry.automorphisms(), form.automorphisms);
    EXPECT_EQ(symmetry.rotations(), form.rotations);
    std::set<std::pair<bool, std::vector<Dart>>> different;
    for (const auto& image : quads::dart_images(map, symmetry)) {
      different.emplace(image.mirrored,
                        std::vector<Dart>(image.of.begin(), image.of.begin() + map.darts));
      for (int i = 0; i < map.darts; ++i) {
        const auto d = static_cast<Dart>(i);
        EXPECT_EQ(image.of[quads::twin(d)], quads::twin(image.of[d]));
        EXPECT_EQ(image.of[map.ccw[d]],
                  image.mirrored ? map.cw[image.of[d]] : map.ccw[image.of[d]]);
      }
    }
    // The mirror symmetry of the 4-cycle that exchanges its quads keeps every dart.
    EXPECT_EQ(different.size(), static_cast<std::size_t>(symmetry.automorphisms()));
  });
}

TEST(PlanarMap, PseudoDoubleWheels) {
  for (int n = 6; n <= complex::kMaxQuads; n += 2) {
    const auto q = quads::quadrangulation_of(quads::pseudo_double_wheel(n));
    ASSERT_FALSE(q.validate());
    EXPECT_TRUE(q.is_three_connected());
    EXPECT_EQ(canon::canonical_form(q).automorphisms, n == 6 ? 48 : 2 * n);
  }
  EXPECT_EQ(canon::canonical_form(quads::quadrangulation_of(quads::pseudo_double_wheel(6))).code,
            canon::canonical_form(complex::Quadrangulation::cube()).code);
  EXPECT_THROW(static_cast<void>(quads::pseudo_double_wheel(7)), core::PreconditionViolated);
}

}  // namespace
