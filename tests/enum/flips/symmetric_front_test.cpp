// Claim. Involutions are the automorphisms of order two, one per class; the orbits visited are
// exactly those whose hexahedra may be glued on one after the other so that the involution extends;
// states are equal exactly if the fronts are isomorphic, the search sees all that orbits reach.
// Oracle. Automorphisms of the graph by backtracking; all pairs of flips, with the extension looked
// for among all maps of corners that keep edges.
#include "enum/flips/symmetric_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "enum/flips/crown.hpp"
#include "enum/flips/symmetric_beam.hpp"
#include "enum/quads/generate.hpp"
#include "tests/enum/flips/glued_steps.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;
using complex::Vertex;
using flips::Front;
using flips::SymmetricFront;
using flips::SymmetricState;

using Permutation = std::vector<int>;

std::vector<Quadrangulation> boundaries(int most) {
  std::vector<Quadrangulation> result;
  for (int n = 6; n <= most; n += 2)
    (void)quads::generate(quads::Class::three_connected, n,
                          [&](const Quadrangulation& q, int, int) { result.push_back(q); });
  return result;
}

/// All automorphisms of the graph, which are those of the map: it is 3-connected.
class Automorphisms {
 public:
  explicit Automorphisms(const Quadrangulation& q)
      : image_(static_cast<std::size_t>(q.vertices()), -1) {
    for (int d = 0; d < q.darts(); ++d)
      edges_.emplace(q.origin(static_cast<complex::Dart>(d)),
                     q.origin(Quadrangulation::next(static_cast<complex::Dart>(d))));
    extend(0);
  }
  [[nodiscard]] const std::vector<Permutation>& all() const { return all_; }

 private:
  void extend(int v) {
    const auto n = static_cast<int>(image_.size());
    if (v == n) return all_.push_back(image_);
    for (int w = 0; w < n; ++w) {
      bool fits = std::find(image_.begin(), image_.begin() + v, w) == image_.begin() + v;
      for (int u = 0; u < v && fits; ++u)
        fits = edges_.contains({u, v}) == edges_.contains({image_[static_cast<std::size_t>(u)], w});
      if (!fits) continue;
      image_[static_cast<std::size_t>(v)] = w;
      extend(v + 1);
    }
  }
  std::set<std::pair<int, int>> edges_;
  Permutation image_;
  std::vector<Permutation> all_;
};

Permutation then(const Permutation& first, const Permutation& second) {
  Permutation result(first.size());
  for (std::size_t v = 0; v < first.size(); ++v)
    result[v] = second[static_cast<std::size_t>(first[v])];
  return result;
}

Permutation inverse(const Permutation& p) {
  Permutation result(p.size());
  for (std::size_t v = 0; v < p.size(); ++v)
    result[static_cast<std::size_t>(p[v])] = static_cast<int>(v);
  return result;
}

/// The elements of order two of a group, by class.
std::set<std::set<Permutation>> classes_of_order_two(const std::vector<Permutation>& group,
                                                     const Permutation& identity) {
  std::set<std::set<Permutation>> classes;
  for (const Permutation& p : group) {
    if (p == identity || then(p, p) != identity) continue;
    std::set<Permutation> conjugates;
    for (const Permutation& g : group) conjugates.insert(then(then(inverse(g), p), g));
    classes.insert(conjugates);
  }
  return classes;
}

TEST(Involutions, AreThoseOfTheGraphOneOfEachClass) {
  std::size_t with = 0;
  for (const Quadrangulation& q : boundaries(14)) {
    const auto group = Automorphisms(q).all();
    Permutation identity(static_cast<std::size_t>(q.vertices()));
    std::iota(identity.begin(), identity.end(), 0);
    auto classes = classes_of_order_two(group, identity);
    const auto found = flips::involutions_of(q);
    EXPECT_EQ(found.size(), classes.size());
    with += found.empty() ? 0 : 1;
    for (const flips::Involution& each : found) {
      const Permutation p(each.image.begin(), each.image.begin() + q.vertices());
      const auto at = std::find_if(classes.begin(), classes.end(),
                                   [&](const auto& one) { return one.contains(p); });
      ASSERT_NE(at, classes.end()) << "twice, or no involution";
      classes.erase(at);
      // Reverses orientation: a quad's vertices come round the other way.
      const auto quad = q.vertices_of(0);
      complex::QuadVertices image{};
      for (std::size_t i = 0; i < 4; ++i) image[i] = each.image[quad[i]];
      const auto quads = q.list_of_quads();
      const bool is_quad = std::any_of(quads.begin(), quads.end(), [&](const auto& other) {
        return support::cycle(other) == support::cycle(image);
      });
      EXPECT_EQ(is_quad, !each.is_mirrored);
    }
  }
  EXPECT_GT(with, 50U);
}

// Of a boundary with more symmetries than its scars an involution may be lost whose conjugates, but
// not itself, keep the scars.
TEST(Involutions, ThatKeepScarsAreThoseOfTheGroupThatDoes) {
  support::Random random(70);
  std::size_t with = 0, fewer = 0;
  for (const Quadrangulation& q : boundaries(12)) {
    const auto group = Automorphisms(q).all();
    if (group.size() < 4) continue;
    Permutation identity(static_cast<std::size_t>(q.vertices()));
    std::iota(identity.begin(), identity.end(), 0);
    for (int tries = 0; tries < 6; ++tries) {
      const auto vertex = [&] {
        return static_cast<std::size_t>(random.below(static_cast<std::size_t>(q.vertices())));
      };
      const std::size_t a = vertex();
      const std::size_t b = vertex();
      if (a == b) continue;
      const Permutation& some = group[random.below(group.size())];
      const std::set<std::set<int>> pairs{{static_cast<int>(a), static_cast<int>(b)},
                                          {some[a], some[b]}};
      flips::Scars scars;
      for (const auto& pair : pairs)
        scars.add(static_cast<Vertex>(*pair.begin()), static_cast<Vertex>(*pair.rbegin()));
      std::vector<Permutation> keeping;
      for (const Permutation& g : group) {
        std::set<std::set<int>> moved;
        for (const auto& pair : pairs)
          moved.insert({g[static_cast<std::size_t>(*pair.begin())],
                        g[static_cast<std::size_t>(*pair.rbegin())]});
        if (moved == pairs) keeping.push_back(g);
      }
      auto classes = classes_of_order_two(keeping, identity);
      const auto found = flips::involutions_of(q, scars);
      EXPECT_EQ(found.size(), classes.size());
      with += found.empty() ? 0 : 1;
      fewer += keeping.size() < group.size() ? 1 : 0;
      for (const flips::Involution& each : found) {
        const Permutation p(each.image.begin(), each.image.begin() + q.vertices());
        EXPECT_EQ(std::erase_if(classes, [&](const auto& one) { return one.contains(p); }), 1U);
      }
    }
  }
  EXPECT_GT(with, 30U);
  EXPECT_GT(fewer, 30U);
}

/// The states after all pairs of flips that are an orbit.
std::set<SymmetricState> states_by_pairs(const SymmetricFront& from, int max_quads) {
  const int vertices = from.front.boundary.vertices();
  std::vector<int> name(static_cast<std::size_t>(vertices));
  std::iota(name.begin(), name.end(), 0);
  std::map<int, int> image;
  for (int v = 0; v < vertices; ++v) image[v] = from.image[static_cast<std::size_t>(v)];
  std::set<SymmetricState> result;
  for (const support::Step& first : support::all_steps(from.front, name, vertices)) {
    if (const auto own = support::extension(image, first.cell, first.cell))
      support::add_state(first, *own, max_quads, result);
    for (const support::Step& second : support::all_steps(first.front, first.name, vertices + 4))
      if (const auto both = support::extension(image, first.cell, second.cell))
        support::add_state(second, *both, max_quads, result);
  }
  return result;
}

TEST(Orbits, AreThePairsOfFlipsThatTheInvolutionExchanges) {
  support::Random random(71);
  int orbits = 0;
  int own = 0;
  const auto all = boundaries(12);
  for (std::size_t i = 0; i < all.size(); i += support::kStride) {
    const Quadrangulation& q = all[i];
    for (const flips::Involution& involution : flips::involutions_of(q)) {
      SymmetricFront front{{q, flips::relation_of_quads(q)}, involution.image};
      for (int step = 0; step < 4; ++step) {
        const int max_quads = step % 2 == 0 ? 20 : 16;
        std::vector<flips::GluedOrbit> found;
        std::set<SymmetricState> states;
        flips::for_each_glueable_orbit(front, max_quads, [&](const flips::GluedOrbit& orbit) {
          found.push_back(orbit);
          states.insert(flips::canonical_state(orbit.made).state);
          EXPECT_EQ(flips::glued(front, orbit.orbit).former, orbit.former);
          own += orbit.orbit.size == 1 ? 1 : 0;
        });
        EXPECT_EQ(states, states_by_pairs(front, max_quads));
        orbits += static_cast<int>(found.size());
        if (found.empty()) break;
        front = found[random.below(found.size())].made;
      }
    }
  }
  EXPECT_GT(orbits, support::share_of(500));
  EXPECT_GT(own, support::share_of(50));
}

/// The same front with its vertices, its quads and their corners in another order.
SymmetricFront scrambled(const SymmetricFront& front, bool mirrored, support::Random& random,
                         std::vector<Vertex>& name) {
  const Quadrangulation& q = front.front.boundary;
  name.resize(static_cast<std::size_t>(q.vertices()));
  std::iota(name.begin(), name.end(), Vertex{0});
  random.shuffle(name);
  auto quads = q.list_of_quads();
  for (auto& quad : quads) {
    for (auto& v : quad) v = name[v];
    if (mirrored) std::reverse(quad.begin(), quad.end());
    std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(random.below(4)),
                quad.end());
  }
  random.shuffle(quads);
  SymmetricFront result{{Quadrangulation::from_quads(quads).value(), {}}, {}};
  for (std::size_t v = 0; v < name.size(); ++v) {
    result.image[name[v]] = name[front.image[v]];
    for (std::size_t w = 0; w < name.size(); ++w)
      if ((front.front.related[v] >> w & 1U) != 0)
        result.front.related[name[v]] |= flips::bit(name[w]);
  }
  return result;
}

/// The labelling takes the front to that of its state.
void expect_isomorphism(const SymmetricFront& front) {
  const auto canonical = flips::canonical_state(front);
  const SymmetricFront there = flips::front_of(canonical.state);
  const auto vertices = static_cast<std::size_t>(front.front.boundary.vertices());
  ASSERT_EQ(there.front.boundary.vertices(), front.front.boundary.vertices());
  for (std::size_t v = 0; v < vertices; ++v) {
    EXPECT_EQ(there.image[canonical.label[v]], canonical.label[front.image[v]]);
    for (std::size_t w = 0; w < vertices; ++w)
      EXPECT_EQ(there.front.related[canonical.label[v]] >> canonical.label[w] & 1U,
                front.front.related[v] >> w & 1U);
  }
  std::set<oracle::Cycle> quads;
  for (const auto& quad : there.front.boundary.list_of_quads()) quads.insert(support::cycle(quad));
  for (auto quad : front.front.boundary.list_of_quads()) {
    for (Vertex& v : quad) v = canonical.label[v];
    if (canonical.is_mirrored) std::reverse(quad.begin(), quad.end());
    EXPECT_TRUE(quads.contains(support::cycle(quad)));
  }
}

TEST(Orbits, OfTheIdentityAreTheHexahedra) {
  support::Random random(64);
  for (int i = 0; i < 20; ++i) {
    const auto shelling = support::random_shelling(2 + random.below(6), 24, random);
    const flips::State state = flips::canonical_state(shelling.front()).state;
    const Front front = flips::front_of(state);
    std::vector<flips::Orbit> flips_alone;
    std::vector<canon::Code> codes;
    flips::for_each_glueable(front, 26, [&](flips::Flip flip, const flips::Prism& prism) {
      flips_alone.push_back({{flip, {}}, 1});
      codes.push_back(canon::canonical_form(flips::glued(front, flip, prism).front.boundary).code);
    });
    std::vector<flips::Orbit> orbits;
    std::vector<canon::Code> made;
    flips::for_each_glueable_orbit(flips::front_without_symmetry(front.boundary, state.scars), 26,
                                   [&](const flips::GluedOrbit& each) {
                                     orbits.push_back(each.orbit);
                                     made.push_back(flips::canonical_state(each.made).state.code);
                                   });
    EXPECT_EQ(orbits, flips_alone);
    EXPECT_EQ(made, codes);
  }
}

TEST(SymmetricStates, AreThoseOfIsomorphicFronts) {
  support::Random random(72);
  std::set<SymmetricState> states;
  std::size_t widest = 0;
  for (const Quadrangulation& q : boundaries(12))
    for (const flips::Involution& involution : flips::involutions_of(q)) {
      SymmetricFront front{{q, flips::relation_of_quads(q)}, involution.image};
      for (int step = 0; step < 12; ++step) {
        expect_isomorphism(front);
        const auto canonical = flips::canonical_state(front);
        states.insert(canonical.state);
        widest = std::max(widest, std::size_t{canonical.state.code.quads});
        std::vector<Vertex> name;
        for (const bool mirrored : {false, true})
          EXPECT_EQ(flips::canonical_state(scrambled(front, mirrored, random, name)).state,
                    canonical.state);
        std::vector<flips::GluedOrbit> found;
        flips::for_each_glueable_orbit(
            front, flips::kMaxSymmetricQuads,
            [&](const flips::GluedOrbit& orbit) { found.push_back(orbit); });
        if (found.empty()) break;
        front = found[random.below(found.size())].made;
      }
    }
  EXPECT_GT(states.size(), 150U);
  EXPECT_EQ(widest, std::size_t{flips::kMaxSymmetricQuads});
}

/// All states with so many hexahedra, by closure; each at the least number it is reached with.
std::map<SymmetricState, int> closure(const SymmetricFront& start, int max_quads, int hexahedra) {
  std::map<SymmetricState, int> least{{flips::canonical_state(start).state, 0}};
  for (int h = 0; h < hexahedra; ++h)
    for (const auto& [state, level] : std::map(least)) {
      if (level != h) continue;
      const auto reach = [&](const flips::GluedOrbit& orbit) {
        const int after = h + orbit.orbit.size;
        if (after > hexahedra) return;
        int& known = least.emplace(flips::canonical_state(orbit.made).state, after).first->second;
        known = std::min(known, after);
      };
      flips::for_each_glueable_orbit(flips::front_of(state), max_quads, reach);
      flips::for_each_glueable_crown(flips::front_of(state), max_quads, reach);
    }
  return least;
}

TEST(SymmetricBeam, WithoutLimitsSeesAllThatOrbitsReach) {
  for (const char* text : {"q1:088a577f", "q1:022972977f", "q1:08a5df"}) {
    const auto q = support::boundary_of(text);
    for (const flips::Involution& involution : flips::involutions_of(q)) {
      const SymmetricFront start{{q, flips::relation_of_quads(q)}, involution.image};
      for (const int threads : {1, 3}) {
        flips::BeamOptions options;
        options.max_quads = 16;
        options.fronts_per_class = options.fronts_per_level = 1'000'000;
        options.threads = threads;
        flips::SymmetricBeam beam({flips::start_of_collars(start)}, flips::Growth::inward, options);
        std::map<SymmetricState, int> seen;
        for (bool has_more = true; has_more && beam.level() <= 6; has_more = beam.expand_level())
          for (const auto& node : beam.nodes()) {
            EXPECT_TRUE(seen.emplace(node.state, beam.level()).second);
            EXPECT_EQ(static_cast<int>(beam.layers_to(node).hexahedra.size()), beam.level());
          }
        EXPECT_TRUE(beam.is_exhaustive());
        EXPECT_EQ(seen, closure(start, options.max_quads, 6)) << text;
      }
    }
  }
}

flips::SymmetricBeam spindle_beam(const flips::BeamOptions& options) {
  const auto q = support::boundary_of("q1:088a577f");
  const SymmetricFront start{{q, flips::relation_of_quads(q)}, flips::involutions_of(q)[0].image};
  return {{flips::start_of_collars(start)}, flips::Growth::inward, options};
}

flips::BeamOptions beam_limits(std::size_t per_class, std::size_t per_level, int threads) {
  flips::BeamOptions options;
  options.max_quads = 28;
  options.fronts_per_class = per_class;
  options.fronts_per_level = per_level;
  options.threads = threads;
  return options;
}

TEST(SymmetricBeam, KeepsItsLimits) {
  const auto states = [](std::size_t per_class, std::size_t per_level) {
    flips::SymmetricBeam beam = spindle_beam(beam_limits(per_class, per_level, 2));
    std::size_t count = 0;
    while (beam.level() < 10 && beam.expand_level()) count += beam.nodes().size();
    EXPECT_EQ(beam.is_exhaustive(), per_class > 1'000) << "limits that bite, and others";
    return count;
  };
  EXPECT_LT(states(2, 10), states(2, 100));
  EXPECT_LT(states(1, 100'000), states(10'000, 100'000));
  flips::BeamOptions small = beam_limits(1'000, 1'000, 1);
  small.max_fronts = 500;
  flips::SymmetricBeam beam = spindle_beam(small);
  std::size_t most = 0;
  for (int level = 0; level < 20 && beam.expand_level(); ++level)
    most = std::max(most, beam.nodes().size());
  EXPECT_FALSE(beam.is_exhaustive());
  EXPECT_LE(most, small.max_fronts);
  EXPECT_GT(most, small.max_fronts / 10);
}

TEST(SymmetricBeam, ExpandsTheMostPromising) {
  constexpr std::size_t kWidth = 20;
  flips::SymmetricBeam beam = spindle_beam(beam_limits(1'000, kWidth, 2));
  flips::SymmetricBeam without = spindle_beam(beam_limits(1'000, kWidth, 2));
  while (beam.nodes().size() < 4 * kWidth) {
    ASSERT_TRUE(beam.expand_level(std::vector(beam.nodes().size(), flips::kNoPromise)));
    ASSERT_TRUE(without.expand_level());
    ASSERT_EQ(beam.nodes().size(), without.nodes().size()) << "nothing promised, nothing changed";
  }
  std::vector<flips::Promise> promises(beam.nodes().size(), flips::kNoPromise);
  for (std::size_t i = 0; i < promises.size(); i += 3)
    promises[i] = static_cast<flips::Promise>(1'000 - i);
  std::set<SymmetricState> promising;  // the last of them
  for (std::size_t i = promises.size(); i-- > 0 && promising.size() < kWidth / 2;)
    if (promises[i] != flips::kNoPromise) promising.insert(beam.nodes()[i].state);
  const std::size_t before = beam.expanded().size();
  (void)beam.expand_level(promises);
  std::size_t found = 0;
  for (const auto& node : beam.expanded().subspan(before)) found += promising.count(node.state);
  EXPECT_EQ(beam.expanded().size() - before, kWidth);
  EXPECT_EQ(found, kWidth / 2);
}

TEST(SymmetricBeam, QuadsIrregularityAndSimpleZonesCountAsSoManyScars) {
  struct Prices {
    unsigned quad, irregularity, simple_zone;
  };
  for (const Prices prices :
       {Prices{3, 0, 0}, Prices{0, 5, 0}, Prices{0, 0, 40}, Prices{2, 3, 27}}) {
    flips::BeamOptions options = beam_limits(1, 20, 2);
    options.scars_per_quad = prices.quad;
    options.scars_per_irregularity = prices.irregularity;
    options.scars_per_simple_zone = prices.simple_zone;
    flips::SymmetricBeam beam = spindle_beam(options);
    const auto cost = [&](const SymmetricState& state) {
      return state.scars.size() + support::price_in_scars(state.code, options);
    };
    std::size_t passed_over = 0;
    for (int level = 0; level < 14; ++level) {
      std::map<std::uint64_t, int> least;  // of each class
      for (const auto& node : beam.nodes()) {
        const auto [own, is_new] = least.try_emplace(node.state.hash_of_class(), cost(node.state));
        if (!is_new) own->second = std::min(own->second, cost(node.state));
      }
      const std::size_t before = beam.expanded().size();
      if (!beam.expand_level()) break;
      int greatest = std::numeric_limits<int>::min();
      for (const auto& node : beam.expanded().subspan(before)) {
        greatest = std::max(greatest, cost(node.state));
        EXPECT_EQ(cost(node.state), least[node.state.hash_of_class()]);
        least.erase(node.state.hash_of_class());
      }
      passed_over += least.size();
      for (const auto& [kind, own] : least) EXPECT_GE(own, greatest);
    }
    EXPECT_GT(passed_over, 10U) << prices.quad << ' ' << prices.irregularity;
  }
}

TEST(SymmetricBeam, IsTheSameForAnyNumberOfThreads) {
  flips::SymmetricBeam one = spindle_beam(beam_limits(3, 400, 1));
  flips::SymmetricBeam three = spindle_beam(beam_limits(3, 400, 3));
  std::size_t most = 0;
  while (one.level() < 14 && one.expand_level()) {
    ASSERT_TRUE(three.expand_level());
    ASSERT_EQ(one.nodes().size(), three.nodes().size());
    most = std::max(most, one.nodes().size());
    for (std::size_t i = 0; i < one.nodes().size(); ++i) {
      EXPECT_EQ(one.nodes()[i].state, three.nodes()[i].state);
      EXPECT_EQ(one.nodes()[i].parent, three.nodes()[i].parent);
      EXPECT_EQ(one.nodes()[i].orbit, three.nodes()[i].orbit);
    }
  }
  EXPECT_GT(most, 500U) << "work for several threads";
}

}  // namespace
