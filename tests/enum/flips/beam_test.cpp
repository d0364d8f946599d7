// Claim. An exhaustive beam reaches every boundary that a shelling reaches, at its least level,
// with dominance and without; limits keep what they say; each state comes with the mesh that it
// claims. Oracle. Plain breadth-first search on states, which knows neither beam nor dominance;
// meshes checked by sets.
#include "enum/flips/beam.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>
#include <vector>

#include "enum/core/errors.hpp"
#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using flips::Beam;
using flips::BeamOptions;
using flips::State;

constexpr std::size_t kUnlimited = 100'000'000;

State single() { return flips::canonical_state(flips::single_hexahedron()).state; }

BeamOptions unlimited(int max_quads, bool use_dominance = true) {
  BeamOptions options;
  options.max_quads = max_quads;
  options.fronts_per_class = kUnlimited;
  options.fronts_per_level = kUnlimited;
  options.use_dominance = use_dominance;
  return options;
}

std::map<canon::Code, int> first_levels(const Beam& beam) {
  std::map<canon::Code, int> result;
  for (const auto& code : beam.codes()) result[code] = beam.first_level(code).value();
  return result;
}

/// Least level of each boundary, up to a level.
std::map<canon::Code, int> plain_search(int max_quads, int levels) {
  std::map<canon::Code, int> first;
  std::set<State> seen{single()};
  std::vector<State> level{single()};
  first[single().code] = 0;
  for (int l = 1; l <= levels && !level.empty(); ++l) {
    std::vector<State> next;
    for (const State& state : level) {
      const auto front = flips::front_of(state);
      flips::for_each_glueable(front, max_quads, [&](flips::Flip flip, const flips::Prism& prism) {
        const State made = flips::canonical_state(flips::glued(front, flip, prism).front).state;
        if (!seen.insert(made).second) return;
        next.push_back(made);
        first.try_emplace(made.code, l);
      });
    }
    level = std::move(next);
  }
  return first;
}

TEST(Beam, FindsTheLeastLevelsOfPlainSearch) {
  for (const auto& [max_quads, levels] : {std::pair(14, 9), std::pair(16, 7), std::pair(18, 6)}) {
    const auto expected = plain_search(max_quads, levels);
    for (const bool dominance : {true, false}) {
      Beam beam(single(), unlimited(max_quads, dominance));
      while (beam.level() < levels && beam.expand_level() > 0) {
      }
      EXPECT_TRUE(beam.is_exhaustive());
      EXPECT_EQ(first_levels(beam), expected) << max_quads << " quads, dominance " << dominance;
    }
  }
}

TEST(Beam, LevelsOfSmallBoundariesAreThoseOfTheCensus) {
  Beam beam(single(), unlimited(24, false));
  std::vector<std::size_t> fronts{beam.frontier().size()};
  for (int level = 1; level <= 4; ++level) fronts.push_back(beam.expand_level());
  EXPECT_EQ(fronts,
            (std::vector<std::size_t>{1, 1, 3, 12, 60}));  // no front occurs at two levels yet
}

TEST(Beam, ReachesTheSameBoundariesWithoutDominance) {
  // To the end on both sides. The signatures change only if the search itself does.
  struct Run {
    int max_quads;
    bool dominance;
    std::size_t classes, fronts;
    std::uint64_t candidates;
  };
  std::map<int, std::map<canon::Code, int>> least;
  for (const Run& run : {Run{16, true, 14, 201, 796}, Run{16, false, 14, 651, 2'087},
                         Run{18, true, 46, 2'590, 8'732}}) {
    Beam beam(single(), unlimited(run.max_quads, run.dominance));
    while (beam.expand_level() > 0) {
    }
    EXPECT_TRUE(beam.is_exhaustive());
    EXPECT_TRUE(beam.frontier().empty());
    EXPECT_EQ(beam.codes().size(), run.classes);
    EXPECT_EQ(beam.fronts(), run.fronts);
    EXPECT_EQ(beam.candidates(), run.candidates);
    const auto [known, is_new] = least.try_emplace(run.max_quads, first_levels(beam));
    EXPECT_EQ(first_levels(beam), known->second) << "dominance " << run.dominance;
    for (const auto& code : beam.codes()) {
      EXPECT_LE(code.quads, run.max_quads);
      EXPECT_TRUE(canon::decode(code)->is_three_connected());
    }
  }
}

TEST(Beam, KeepsAtMostTheLimitPerClass) {
  // The first level at which a class overflows is that of an unlimited search, cut off.
  const auto counts = [](const Beam& beam) {
    std::map<canon::Code, std::size_t> result;
    for (const auto id : beam.frontier()) ++result[beam.state(id).code];
    return result;
  };
  constexpr int kQuads = 20;
  std::vector<std::map<canon::Code, std::size_t>> full;
  Beam all(single(), unlimited(kQuads, false));
  std::size_t largest = 0;
  while (largest <= 300 && all.expand_level() > 0) {
    full.push_back(counts(all));
    for (const auto& [code, count] : full.back()) largest = std::max(largest, count);
  }
  ASSERT_GT(largest, 257U);
  for (const std::size_t limit : {1U, 2U, 255U, 256U, 257U}) {
    BeamOptions options = unlimited(kQuads, false);
    options.fronts_per_class = limit;
    Beam beam(single(), options);
    for (const auto& level : full) {
      beam.expand_level();
      auto expected = level;
      bool overflows = false;
      for (auto& [code, count] : expected) {
        overflows = overflows || count > limit;
        count = std::min(count, limit);
      }
      EXPECT_EQ(counts(beam), expected) << limit;
      EXPECT_EQ(beam.is_exhaustive(), !overflows) << limit;
      if (overflows) break;
    }
  }
}

TEST(Beam, KeepsAtMostTheLimitPerLevel) {
  BeamOptions options = unlimited(18);
  options.fronts_per_level = 50;
  Beam beam(single(), options);
  for (int level = 1; level <= 12; ++level) {
    EXPECT_LE(beam.expand_level(), 50U);
    for (const auto id : beam.frontier()) EXPECT_EQ(beam.level_of(id), level);
  }
  EXPECT_FALSE(beam.is_exhaustive());
}

TEST(Beam, StaysWithinItsMemoryAndSaysSo) {
  BeamOptions options = unlimited(20);
  options.max_fronts = 2'000;
  Beam beam(single(), options);
  while (beam.expand_level() > 0) EXPECT_LE(beam.fronts(), options.max_fronts);
  EXPECT_GT(beam.fronts(), options.max_fronts / 2);
  EXPECT_FALSE(beam.is_exhaustive());
  for (const canon::Code& code : beam.codes()) EXPECT_FALSE(beam.fronts_of(code).empty());
  EXPECT_EQ(Beam::from_bytes(beam.to_bytes(), single(), options, "saved").codes(), beam.codes());
}

TEST(Beam, OptionsAreChecked) {
  for (const int quads : {4, flips::kMaxStateQuads + 1})
    EXPECT_THROW(Beam(single(), unlimited(quads)), core::PreconditionViolated);
  BeamOptions options;
  options.threads = 0;
  EXPECT_THROW(Beam(single(), options), core::PreconditionViolated);
  options = {};
  options.scars_per_irregularity = flips::kMaxPerIrregularity + 1;
  EXPECT_THROW(Beam(single(), options), core::PreconditionViolated);
  options = {};
  options.scars_per_simple_zone = flips::kMaxPerSimpleZone + 1;
  EXPECT_THROW(Beam(single(), options), core::PreconditionViolated);
}

TEST(Beam, GivesEveryClassItsTurn) {
  // Whatever the limit, as many classes of a level are expanded as it allows.
  BeamOptions options = unlimited(20);
  options.fronts_per_level = 40;
  Beam few(single(), options);
  for (int level = 1; level <= 8; ++level) {
    (void)few.expand_level();
    std::set<canon::Code> chosen, reached;
    for (const auto id : few.frontier()) chosen.insert(few.state(id).code);
    for (const auto& code : few.codes())
      for (const auto& record : few.fronts_of(code))
        if (record.level == level) reached.insert(code);
    EXPECT_EQ(chosen.size(), std::min<std::size_t>(40, reached.size())) << level;
  }
}

TEST(Beam, QuadsIrregularityAndSimpleZonesCountAsSoManyScars) {
  struct Prices {
    unsigned quad, irregularity, simple_zone;
  };
  for (const Prices prices :
       {Prices{0, 0, 0}, Prices{3, 0, 0}, Prices{50, 0, 0}, Prices{0, 1, 0}, Prices{0, 50, 0},
        Prices{0, 0, 1}, Prices{0, 0, 500}, Prices{2, 3, 27}}) {
    BeamOptions options = unlimited(20);
    options.fronts_per_class = 1;  // then all of a level stay known, and the order is seen
    options.fronts_per_level = 30;
    options.scars_per_quad = prices.quad;
    options.scars_per_irregularity = prices.irregularity;
    options.scars_per_simple_zone = prices.simple_zone;
    Beam beam(single(), options);
    const auto cost = [&](const State& state) {
      return state.scars.size() + support::price_in_scars(state.code, options);
    };
    std::size_t passed_over = 0;
    for (int level = 1; level <= 10; ++level) {
      (void)beam.expand_level();
      const std::set<flips::FrontId> chosen(beam.frontier().begin(), beam.frontier().end());
      int greatest = std::numeric_limits<int>::min();
      for (const auto id : chosen) greatest = std::max(greatest, cost(beam.state(id)));
      for (const auto& code : beam.codes())
        for (const auto& record : beam.fronts_of(code)) {
          if (record.level != level || chosen.contains(record.id)) continue;
          ++passed_over;
          EXPECT_GE(cost(beam.state(record.id)), greatest);
        }
    }
    EXPECT_GT(passed_over, 10U) << prices.quad << ' ' << prices.irregularity << ' '
                                << prices.simple_zone;
  }
}

TEST(Beam, StatesHaveUpToThirtyQuads) {
  support::Random random(17);
  int large = 0;
  for (int i = 0; i < 300; ++i) {
    const auto shelling = support::random_shelling(30, flips::kMaxStateQuads, random);
    const flips::Front& front = shelling.front();
    large += front.boundary.quads() > flips::kMaxSearchQuads ? 1 : 0;
    const flips::CanonicalState canonical = flips::canonical_state(front);
    EXPECT_EQ(flips::canonical_state(flips::front_of(canonical.state)).state, canonical.state);
    // Each pair is a scar where the front relates it, up to the highest vertices.
    const auto quads = flips::relation_of_quads(front.boundary);
    for (int a = 0; a < front.boundary.vertices(); ++a)
      for (int b = 0; b < a; ++b) {
        const auto u = static_cast<complex::Vertex>(a), v = static_cast<complex::Vertex>(b);
        const bool is_scar = ((front.related[u] & ~quads[u]) >> v & 1U) != 0;
        EXPECT_EQ(canonical.state.scars.has(canonical.label[u], canonical.label[v]), is_scar);
      }
  }
  EXPECT_GT(large, 20);
}

TEST(Beam, EachStateComesWithItsMesh) {
  Beam beam(single(), unlimited(16));
  while (beam.level() < 14 && beam.expand_level() > 0) {
  }
  std::size_t checked = 0;
  for (const auto& code : beam.codes())
    for (const auto& record : beam.fronts_of(code)) {
      if (++checked > 3'000) break;
      const auto filling = flips::filling_of(beam, record.id);
      ASSERT_EQ(filling.mesh.hexahedra.size(), static_cast<std::size_t>(record.level) + 1);
      ASSERT_EQ(support::fault_of_filling(filling.mesh, code), "") << canon::to_text(code);
      // The scars are those of the mesh: related pairs in no quad of the boundary.
      const auto boundary = canon::decode(code).value();
      const auto quads = flips::relation_of_quads(boundary);
      for (int a = 0; a < boundary.vertices(); ++a)
        for (int b = 0; b < a; ++b) {
          const auto u = static_cast<complex::Vertex>(a);
          const auto v = static_cast<complex::Vertex>(b);
          const bool related = std::any_of(filling.mesh.hexahedra.begin(),
                                           filling.mesh.hexahedra.end(), [&](const auto& cell) {
                                             return std::count(cell.begin(), cell.end(), u) +
                                                        std::count(cell.begin(), cell.end(), v) ==
                                                    2;
                                           });
          ASSERT_EQ(record.scars.has(u, v), related && (quads[u] & flips::bit(v)) == 0);
        }
    }
  EXPECT_GT(checked, 100U);
}

TEST(Scars, AreSetsOfPairs) {
  support::Random random(59);
  for (int i = 0; i < 200; ++i) {
    flips::Scars a, b;
    std::set<std::pair<int, int>> in_a, in_b;
    for (std::size_t k = random.below(30); k > 0; --k) {
      const auto u = static_cast<complex::Vertex>(random.below(26));
      const auto v = static_cast<complex::Vertex>(random.below(26));
      if (u == v) continue;
      const bool both = random.coin();
      a.add(u, v);
      in_a.insert(std::minmax<int>(u, v));
      if (both) b.add(v, u);
      if (both) in_b.insert(std::minmax<int>(u, v));
    }
    EXPECT_EQ(static_cast<std::size_t>(a.size()), in_a.size());
    EXPECT_TRUE(b.is_subset_of(a));
    EXPECT_EQ(a.is_subset_of(b), in_a == in_b);
    EXPECT_EQ(a.is_disjoint_from(b), in_b.empty());
    canon::Labelling name{};
    std::vector<complex::Vertex> shuffled(26);
    for (std::size_t v = 0; v < 26; ++v) shuffled[v] = static_cast<complex::Vertex>(v);
    random.shuffle(shuffled);
    std::copy(shuffled.begin(), shuffled.end(), name.begin());
    const auto renamed = a.renamed(name);
    EXPECT_EQ(renamed.size(), a.size());
    for (const auto& [u, v] : in_a)
      EXPECT_TRUE(
          renamed.has(name[static_cast<std::size_t>(u)], name[static_cast<std::size_t>(v)]));
  }
}

}  // namespace
