// Claim. A walk knows the faults of its mesh, which keeps its boundary and obeys the strict rule
// exactly when there are none; it does not depend on the layers at hand. A leap changes the mesh,
// if asked for the parity of its number of hexahedra, too; a mesh that is too small for one stays.
// Oracle. Faults by sets: classes of hexahedra joined through facets, pair by pair. Two meshes are
// told apart by how many hexahedra meet at the vertices of each hexahedron.
#include "enum/flips/walk.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/faults.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using flips::Climate;
using flips::Walk;
using support::cells_of;
using support::faults_of;
using support::grown;

TEST(Walk, KnowsTheFaultsOfItsMesh) {
  const auto beam = grown(18, 30, 3'000, 26);
  const auto codes = beam.codes();
  support::Random random(3);
  std::size_t with_faults = 0, without = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const auto& code = codes[random.below(codes.size())];
    const auto start = flips::filling_of(beam, beam.fronts_of(code).back().id).mesh;
    const auto boundary = oracle::boundary(cells_of(start));
    const std::uint64_t seed = random.bits();
    Walk walk(start, code.quads, beam, seed), other(start, code.quads, beam, seed);
    flips::BallLayers layers(beam);
    const Climate hot(0.8, 0.7);
    const Climate cold(0.3, 0.01);
    for (int step = 0; step < 120; ++step) {
      const Climate& climate = step / 30 % 2 == 0 ? hot : cold;
      flips::BallLayers none(beam);
      const bool is_another = walk.step(climate, layers);
      ASSERT_EQ(other.step(climate, none), is_another);
      ASSERT_EQ(other.mesh().hexahedra, walk.mesh().hexahedra);
      if (!is_another) continue;
      const auto cells = cells_of(walk.mesh());
      ASSERT_EQ(walk.faults(), faults_of(cells));
      ASSERT_EQ(oracle::boundary(cells), boundary);
      ASSERT_EQ(walk.faults() == 0, oracle::obeys_strict_rule(cells) &&
                                        support::fault_of_mesh(walk.mesh(), code).empty());
      ++(walk.faults() == 0 ? without : with_faults);
    }
  }
  EXPECT_GT(with_faults, 20U);
  EXPECT_GT(without, 20U);
}

/// The same for meshes that differ in the numbering only.
std::multiset<std::multiset<std::size_t>> signature(const std::vector<oracle::Cell>& cells) {
  std::map<std::uint32_t, std::size_t> degree;
  for (const auto& cell : cells)
    for (const auto v : cell) ++degree[v];
  std::multiset<std::multiset<std::size_t>> result;
  for (const auto& cell : cells) {
    std::multiset<std::size_t> own;
    for (const auto v : cell) own.insert(degree[v]);
    result.insert(std::move(own));
  }
  return result;
}

struct Leaps {
  int all = 0, of_other_parity = 0, of_other_signature = 0;
};

/// Some leaps from each of the beam's boundaries whose least and last ball differ in parity, or do
/// not, each leap checked.
Leaps some_leaps(const flips::Beam& beam, Walk::Leap kind, bool of_two_parities, int tries) {
  Leaps result;
  for (const auto& code : beam.codes()) {
    const auto records = beam.fronts_of(code);
    if (((records.back().level - records.front().level) % 2 != 0) != of_two_parities) continue;
    const auto start = flips::filling_of(beam, records.back().id).mesh;
    Walk walk(start, code.quads, beam, 11), other(start, code.quads, beam, 11);
    flips::BallLayers layers(beam), none(beam);
    const auto boundary = oracle::boundary(cells_of(start));
    for (int i = 0; i < 3; ++i) {
      const auto before = cells_of(walk.mesh());
      const bool has_leapt = walk.leap(Climate(0.6, 0.2), layers, tries, kind);
      EXPECT_EQ(other.leap(Climate(0.6, 0.2), none, tries, kind), has_leapt);
      EXPECT_EQ(other.mesh().hexahedra, walk.mesh().hexahedra);
      const auto cells = cells_of(walk.mesh());
      EXPECT_EQ(walk.faults(), faults_of(cells));
      EXPECT_EQ(oracle::boundary(cells), boundary);
      if (!has_leapt) {
        EXPECT_EQ(cells, before);
        break;
      }
      ++result.all;
      if ((cells.size() - before.size()) % 2 != 0) ++result.of_other_parity;
      if (signature(cells) != signature(before)) ++result.of_other_signature;
    }
    if (result.all >= 12) break;
  }
  return result;
}

TEST(Walk, LeapsToAnOddNumberOfHexahedraFromAnEvenOneAndBack) {
  const Leaps leaps = some_leaps(grown(20, 30, 2'000, 44), Walk::Leap::other_parity, true, 30);
  EXPECT_GE(leaps.all, 12);
  EXPECT_EQ(leaps.of_other_parity, leaps.all);
}

TEST(Walk, LeapsToAnotherMesh) {
  const Leaps leaps = some_leaps(grown(20, 1, 2'000, 30), Walk::Leap::any_other, false, 300);
  EXPECT_GE(leaps.all, 12);
  EXPECT_EQ(leaps.of_other_signature, leaps.all);
  EXPECT_LT(leaps.of_other_parity, leaps.all);
}

TEST(Walk, HasNoLeapFromASmallMesh) {
  const auto beam = grown(12, 5, 100, 6);
  const auto code = beam.codes().back();
  const auto start = flips::filling_of(beam, beam.fronts_of(code).front().id).mesh;
  Walk walk(start, code.quads, beam, 1);
  flips::BallLayers layers(beam);
  EXPECT_FALSE(walk.leap(Climate(0.6, 0.2), layers, 100, Walk::Leap::other_parity));
  EXPECT_EQ(walk.mesh().hexahedra, start.hexahedra);
}

}  // namespace
