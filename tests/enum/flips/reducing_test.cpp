// Claim. A layer below all quads leaves the same cavity again, in which only quads relate; a layer
// below the end of a block removes a zone; a layer that is refused changes nothing. reduce() never
// makes more quads, leaves no single flip that makes fewer, and all that it takes may be taken; it
// is the same again, and another one for other seeds. remove_zones() takes blocks apart, for any
// numbering, and keeps to its price. Oracle. All patches of all quads tried; every hexahedron taken
// again from the start, which Peeling allows or not; vertices of layers told by the hexahedra;
// blocks by formula.
#include "enum/flips/reducing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/pillow.hpp"
#include "tests/enum/flips/peelings.hpp"
#include "tests/enum/support.hpp"
#include "tests/meshing/hexahedrize/spheres.hpp"

namespace {

using namespace hexatlas;
using complex::BoundaryQuad;
using complex::QuadSphere;
using complex::VertexId;
using flips::Peeling;
using support::choices;
using support::peeling_of;
using support::seen;

constexpr double kAnyPrice = std::numeric_limits<double>::infinity();

BoundaryQuad least_first(BoundaryQuad quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  return quad;
}
std::set<BoundaryQuad> set_of(const std::vector<BoundaryQuad>& quads) {
  std::set<BoundaryQuad> result;
  for (const BoundaryQuad& quad : quads) result.insert(least_first(quad));
  return result;
}

/// The hexahedra that `peeled` has taken since, taken one by one from the start, each by some patch
/// that may be taken: their prefixes are legal.
void expect_legal(const QuadSphere& sphere, const Peeling& peeled) {
  Peeling fresh = peeling_of(sphere);
  for (const complex::Hexahedron& cell : peeled.taken()) {
    bool found = false;
    for (std::uint32_t q = 0; q < fresh.quad_numbers() && !found; ++q)
      for (std::uint8_t sides = 0; sides < 16 && fresh.is_live(q) && !found; ++sides) {
        Peeling::Prism prism;
        if (!std::count(cell.begin(), cell.end(), fresh.origin(4 * q + 0)) ||
            !std::count(cell.begin(), cell.end(), fresh.origin(4 * q + 2)) ||
            !fresh.may_take({q, sides}, prism))
          continue;
        fresh.take({q, sides}, prism);
        found = fresh.taken().back() == cell;
        if (!found) fresh.put_back();
      }
    ASSERT_TRUE(found) << "hexahedron " << fresh.taken().size();
  }
  EXPECT_EQ(set_of(fresh.cavity()), set_of(peeled.cavity()));
}

std::vector<QuadSphere> spheres() {
  return {support::grid_cube(1),         support::grid_cube(3),
          support::trapezohedron(6),     support::trapezohedron(21),
          support::block({5, 2, 1}),     support::random_sphere(40, 1, 3),
          support::random_sphere(60, 2), support::random_sphere(90, 3, 80)};
}

TEST(Pillow, BelowAllQuadsLeavesTheSameCavityUnrelated) {
  for (const QuadSphere& sphere : spheres()) {
    Peeling peeling = peeling_of(sphere);
    flips::reduce(peeling, {.depth = 1});  // something is related then
    const auto before = peeling.cavity();
    const std::size_t taken = peeling.taken().size();
    const std::uint32_t vertices = peeling.vertices();
    ASSERT_TRUE(flips::take_layer(peeling, peeling.live_quads()).has_value());
    ASSERT_EQ(peeling.taken().size(), taken + before.size());
    support::expect_consistent(peeling);
    // Each hexahedron has a quad above and one below, which says what each vertex became.
    std::map<VertexId, std::set<VertexId>> below;
    const auto old_quads = set_of(before);
    for (std::size_t i = taken; i < peeling.taken().size(); ++i) {
      const auto& cell = peeling.taken()[i];
      std::size_t former = 0;
      for (std::size_t k = 0; k < 8; ++k) former += cell[k] < vertices ? 1 : 0;
      ASSERT_EQ(former, 4U);
      for (std::size_t k = 0; k < 8; ++k)
        for (const std::size_t other : {k ^ 1U, k ^ 2U, k ^ 4U})
          if (cell[k] < vertices && cell[other] >= vertices) below[cell[k]].insert(cell[other]);
    }
    std::set<BoundaryQuad> moved;
    for (BoundaryQuad quad : before) {
      for (VertexId& v : quad) {
        ASSERT_EQ(below[v].size(), 1U);
        v = *below[v].begin();
      }
      moved.insert(least_first(quad));
    }
    EXPECT_EQ(set_of(peeling.cavity()), moved);
    std::set<std::pair<VertexId, VertexId>> in_quads;
    for (const auto& quad : peeling.cavity())
      for (const VertexId a : quad)
        for (const VertexId b : quad) in_quads.emplace(a, b);
    for (VertexId a = vertices; a < peeling.vertices(); ++a)
      for (VertexId b = vertices; b < a; ++b)
        ASSERT_EQ(peeling.are_related(a, b), in_quads.contains({a, b}));
    if (sphere.quads.size() <= 60) expect_legal(sphere, peeling);
  }
}

/// The quads of a block of k x l x m on its side x = 0: its surface is listed from there on.
std::vector<std::uint32_t> first_side(const std::array<VertexId, 3>& cubes) {
  std::vector<std::uint32_t> quads(std::size_t{cubes[1]} * cubes[2]);
  for (std::uint32_t q = 0; q < quads.size(); ++q) quads[q] = q;
  return quads;
}

TEST(Pillow, BelowTheEndOfABlockRemovesItsZone) {
  for (const std::array<VertexId, 3>& cubes :
       {std::array<VertexId, 3>{2, 1, 1}, {4, 3, 2}, {3, 3, 3}}) {
    const QuadSphere sphere = support::block(cubes);
    Peeling peeling = peeling_of(sphere);
    const auto side = first_side(cubes);
    ASSERT_TRUE(flips::take_layer(peeling, side).has_value());
    EXPECT_EQ(peeling.taken().size(), side.size());
    EXPECT_EQ(peeling.quads(), sphere.quads.size() - 2 * (cubes[1] + cubes[2]));
    EXPECT_EQ(peeling.vertices(), sphere.vertices() + (cubes[1] - 1) * (cubes[2] - 1));
    expect_legal(sphere, peeling);
    support::expect_consistent(peeling);
  }
}

TEST(Pillow, RefusedChangesNothing) {
  // Of a block one cube thick the other side would be met: forbidden at a corner, the first flip.
  Peeling thin = peeling_of(support::block({1, 4, 3}));
  const auto before = seen(thin);
  EXPECT_FALSE(flips::take_layer(thin, first_side({1, 4, 3})).has_value());
  EXPECT_EQ(seen(thin), before);
  // Two quads of a grid: no disc whose surroundings are a zone. And all random sets that fail.
  support::Random random(79);
  std::size_t refused = 0, refused_late = 0;
  for (const QuadSphere& sphere : spheres()) {
    Peeling peeling = peeling_of(sphere);
    for (int step = 0; step < 12; ++step) {
      const auto next = choices(peeling, 0);
      if (next.empty()) break;
      const auto& choice = next[random.below(next.size())];
      peeling.take(choice.patch, choice.prism);
      // A ball of quads around one: those within some steps.
      const auto live = peeling.live_quads();
      std::vector<std::uint32_t> disc{live[random.below(live.size())]};
      const std::size_t size = 1 + random.below(9);
      for (std::size_t i = 0; i < disc.size() && disc.size() < size; ++i)
        for (unsigned k = 0; k < 4; ++k) {
          const std::uint32_t near = peeling.twin(4 * disc[i] + k) / 4;
          if (std::find(disc.begin(), disc.end(), near) == disc.end()) disc.push_back(near);
        }
      const auto was = seen(peeling);
      if (flips::take_layer(peeling, disc)) {
        EXPECT_EQ(peeling.taken().size(), was.taken.size() + disc.size());
        support::expect_consistent(peeling);
        continue;
      }
      ++refused;
      refused_late += disc.size() > 3 ? 1 : 0;
      ASSERT_EQ(seen(peeling), was);
    }
  }
  EXPECT_GT(refused, 20U);
  EXPECT_GT(refused_late, 10U);
}

TEST(Reduce, LeavesNoFlipThatMakesFewer) {
  for (const int depth : {1, 2, 6})
    for (const QuadSphere& sphere : spheres()) {
      Peeling peeling = peeling_of(sphere);
      flips::reduce(peeling, {.depth = depth});
      EXPECT_LE(peeling.quads(), sphere.quads.size());
      EXPECT_TRUE(choices(peeling, -2).empty()) << sphere.quads.size() << " quads";
      support::expect_consistent(peeling);
    }
}

TEST(Reduce, IsTheSameAgainAndLegalForAllSeeds) {
  const QuadSphere sphere = support::random_sphere(100, 9);
  std::set<std::vector<complex::Hexahedron>> ways;
  for (const std::uint64_t seed : {0U, 1U, 2U, 3U, 0U, 2U}) {
    Peeling peeling = peeling_of(sphere), again = peeling_of(sphere);
    flips::reduce(peeling, {.seed = seed});
    flips::reduce(again, {.seed = seed});
    EXPECT_EQ(seen(peeling), seen(again));
    expect_legal(sphere, peeling);
    ways.insert(peeling.taken());
    EXPECT_LT(peeling.quads(), sphere.quads.size());
    // Undone, it is the sphere that was given.
    while (!peeling.taken().empty()) peeling.put_back();
    EXPECT_EQ(seen(peeling), seen(peeling_of(sphere)));
  }
  EXPECT_GE(ways.size(), 3U);
}

TEST(Reduce, LongerSequencesReachFewerQuads) {
  std::size_t at_once = 0, in_six = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const QuadSphere sphere = support::random_sphere(120, seed, 10);
    Peeling short_ones = peeling_of(sphere), long_ones = peeling_of(sphere);
    flips::reduce(short_ones, {.depth = 1});
    flips::reduce(long_ones, {.depth = 6});
    at_once += short_ones.quads();
    in_six += long_ones.quads();
  }
  EXPECT_LT(in_six, at_once);
}

QuadSphere renumbered(QuadSphere sphere, support::Random& random) {
  std::vector<VertexId> name(sphere.vertices());
  for (VertexId v = 0; v < name.size(); ++v) name[v] = v;
  random.shuffle(name);
  for (auto& quad : sphere.quads) {
    for (VertexId& v : quad) v = name[v];
    std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(random.below(4)),
                quad.end());
  }
  random.shuffle(sphere.quads);
  return sphere;
}

TEST(Zones, TakeBlocksApartInAnyNumbering) {
  support::Random random(83);
  for (const std::array<VertexId, 3>& cubes : {std::array<VertexId, 3>{1, 1, 1},
                                               {2, 1, 1},
                                               {7, 3, 1},
                                               {3, 3, 3},
                                               {9, 9, 1},
                                               {4, 5, 6},
                                               {8, 6, 4}})
    for (int numbering = 0; numbering < 8; ++numbering) {
      const QuadSphere block = support::block(cubes);
      const QuadSphere sphere = numbering == 0 ? block : renumbered(block, random);
      Peeling peeling = peeling_of(sphere);
      EXPECT_EQ(flips::remove_zones(peeling, kAnyPrice), cubes[0] + cubes[1] + cubes[2] - 3);
      EXPECT_EQ(peeling.quads(), 6U);
      EXPECT_EQ(peeling.taken().size() + 1, std::size_t{cubes[0]} * cubes[1] * cubes[2]);
      support::expect_consistent(peeling);
      if (sphere.quads.size() < 60) expect_legal(sphere, peeling);
    }
}

TEST(Zones, KeepToTheirPrice) {
  // The first layer off a cube of n: n^2 hexahedra for the 4 n quads of the zone, n / 4 for each.
  for (const VertexId n : {4U, 8U}) {
    Peeling peeling = peeling_of(support::grid_cube(n));
    const auto before = seen(peeling);
    EXPECT_EQ(flips::remove_zones(peeling, n / 4.0 - 0.01), 0U);
    EXPECT_EQ(seen(peeling), before);
    EXPECT_GT(flips::remove_zones(peeling, n / 4.0), 0U);
  }
}

}  // namespace
