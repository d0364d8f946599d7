// Claim. The shellable meshes of 1..6 hexahedra, their fronts and their boundaries are as many as
// tests/counts/known_counts.tsv says.
// Oracle. Two roads: fronts up to isomorphism by breadth-first search on canonical states, and
// whole meshes by certificates of nauty, which know no front. The numbers themselves come from a
// third program.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "enum/canon/nauty/hex_symmetry.hpp"
#include "enum/flips/scars.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using flips::Flip;
using flips::Front;
using flips::Shelling;

/// A front up to isomorphism, whatever its size: its code, and of the relation in all canonical
/// labellings the least.
using Key = std::pair<canon::Code, std::set<std::pair<int, int>>>;
Key key_of(const Front& front) {
  canon::CanonicalFlags flags;
  canon::canonical_flags(front.boundary, flags);
  Key key{flags.code, {}};
  for (int i = 0; i < flags.count; ++i) {
    const auto label =
        canon::labelling_from(front.boundary, flags.flags[static_cast<std::size_t>(i)]);
    std::set<std::pair<int, int>> related;
    for (int a = 0; a < front.boundary.vertices(); ++a)
      for (int b = 0; b < a; ++b)
        if ((front.related[static_cast<std::size_t>(a)] >> b & 1U) != 0)
          related.insert(std::minmax<int>(label[static_cast<std::size_t>(a)],
                                          label[static_cast<std::size_t>(b)]));
    if (i == 0 || related < key.second) key.second = related;
  }
  return key;
}

TEST(Census, FrontsAndBoundariesOfShellableMeshes) {
  const std::vector<std::size_t> fronts{1, 1, 3, 12, 60, 441};
  const std::vector<std::size_t> boundaries{1, 1, 3, 12, 59, 421};
  const std::vector<std::size_t> cumulative{1, 2, 5, 17, 74, 489};
  std::map<Key, Front> level{{key_of(flips::single_hexahedron()), flips::single_hexahedron()}};
  std::set<canon::Code> seen;
  for (std::size_t h = 1; h <= 6; ++h) {
    std::set<canon::Code> codes;
    for (const auto& [key, front] : level) codes.insert(key.first);
    seen.insert(codes.begin(), codes.end());
    EXPECT_EQ(level.size(), fronts[h - 1]) << h;
    EXPECT_EQ(codes.size(), boundaries[h - 1]) << h;
    EXPECT_EQ(seen.size(), cumulative[h - 1]) << h;
    std::map<Key, Front> next;
    for (const auto& entry : level) {
      const Front& front = entry.second;
      flips::for_each_glueable(front, flips::kMaxFrontQuads,
                               [&](Flip flip, const flips::Prism& prism) {
                                 const Front made = flips::glued(front, flip, prism).front;
                                 next.emplace(key_of(made), made);
                               });
    }
    level = std::move(next);
  }
}

TEST(Census, StatesAreFrontsUpToIsomorphism) {
  const std::vector<std::size_t> fronts{1, 1, 3, 12, 60};
  std::set<flips::State> level{flips::canonical_state(flips::single_hexahedron()).state};
  for (const std::size_t expected : fronts) {
    EXPECT_EQ(level.size(), expected);
    std::set<flips::State> next;
    for (const auto& state : level) {
      const Front front = flips::front_of(state);
      EXPECT_EQ(flips::canonical_state(front).state, state);
      flips::for_each_glueable(
          front, flips::kMaxSearchQuads, [&](Flip flip, const flips::Prism& prism) {
            next.insert(flips::canonical_state(flips::glued(front, flip, prism).front).state);
          });
    }
    level = std::move(next);
  }
}

TEST(Census, WholeMeshesByNauty) {
  const std::vector<std::size_t> meshes{1, 1, 3, 12, 60, 441};
  std::map<std::vector<std::uint64_t>, Shelling> level;
  const auto certificate = [](const Shelling& shelling) {
    return canon::graph_form(support::mesh_of(support::cells_of(shelling))).certificate;
  };
  level.emplace(certificate(Shelling()), Shelling());
  for (const std::size_t expected : meshes) {
    EXPECT_EQ(level.size(), expected);
    if (expected == meshes.back()) break;
    std::map<std::vector<std::uint64_t>, Shelling> next;
    for (auto& [key, shelling] : level)
      for (const Flip flip :
           support::candidate_flips(shelling.front().boundary, flips::kMaxFrontQuads)) {
        if (!shelling.push(flip)) continue;
        next.emplace(certificate(shelling), shelling);
        shelling.pop();
      }
    level = std::move(next);
  }
}

}  // namespace
