// Claim. A walk knows the faults of its mesh, which keeps its boundary and obeys the strict rule
// exactly when there are none; annealing finds meshes with fewer hexahedra, the same for any number
// of threads.
// Oracle. Faults by sets: classes of hexahedra joined through facets, pair by pair.
#include "enum/flips/annealing.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "enum/flips/meeting.hpp"
#include "tests/enum/flips/small_beam.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;
using flips::Climate;
using flips::Walk;
using support::grown;

std::vector<oracle::Cell> cells_of(const complex::HexComplex& mesh) {
  return {mesh.hexahedra.begin(), mesh.hexahedra.end()};
}

std::set<std::set<std::uint32_t>> facets_of(const oracle::Cell& cell) {
  std::set<std::set<std::uint32_t>> result;
  for (const auto& quad : oracle::boundary({cell})) result.emplace(quad.begin(), quad.end());
  return result;
}

/// How many classes of the cells with both vertices there are beyond the first.
int faults_of_pair(const std::vector<std::set<std::set<std::uint32_t>>>& facets,
                   const std::set<std::uint32_t>& pair, std::set<std::size_t> cells) {
  int classes = 0;
  for (; !cells.empty(); ++classes) {
    std::vector<std::size_t> reached{*cells.begin()};
    cells.erase(cells.begin());
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const auto& facet : facets[reached[i]]) {
        if (!std::includes(facet.begin(), facet.end(), pair.begin(), pair.end())) continue;
        for (std::size_t other = 0; other < facets.size(); ++other)
          if (facets[other].contains(facet) && cells.erase(other) > 0) reached.push_back(other);
      }
  }
  return classes - 1;
}

int faults_of(const std::vector<oracle::Cell>& cells) {
  std::vector<std::set<std::set<std::uint32_t>>> facets;
  std::map<std::set<std::uint32_t>, std::set<std::size_t>> with;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    facets.push_back(facets_of(cells[c]));
    for (const auto a : cells[c])
      for (const auto b : cells[c])
        if (a < b) with[{a, b}].insert(c);
  }
  int faults = 0;
  for (const auto& [pair, own] : with) faults += faults_of_pair(facets, pair, own);
  return faults;
}

TEST(Walk, KnowsTheFaultsOfItsMesh) {
  const auto beam = grown(18, 30, 3'000, 26);
  const auto codes = beam.codes();
  support::Random random(3);
  std::size_t with_faults = 0, without = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const auto& code = codes[random.below(codes.size())];
    const auto start = flips::filling_of(beam, beam.fronts_of(code).back().id).mesh;
    const auto boundary = oracle::boundary(cells_of(start));
    Walk walk(start, code.quads, beam, random.bits());
    const Climate hot{.per_hexahedron = 0.8, .per_fault = 0.7};
    const Climate cold{.per_hexahedron = 0.3, .per_fault = 0.01};
    for (int step = 0; step < 120; ++step) {
      if (!walk.step(step / 30 % 2 == 0 ? hot : cold)) continue;
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

TEST(Annealing, FindsFewerHexahedraForAnyNumberOfThreads) {
  const auto beam = grown(20, 30, 2'000, 34);
  std::size_t reduced = 0;
  for (const auto& code : beam.codes()) {
    const auto records = beam.fronts_of(code);
    if (records.back().level < records.front().level + 6 || code.quads > 16) continue;
    const auto mesh = flips::filling_of(beam, records.back().id).mesh;
    flips::AnnealingOptions options{.rounds = 2, .seed = 7, .threads = 1};
    const auto smaller = flips::smaller_by_annealing(mesh, code.quads, beam, options);
    ASSERT_TRUE(smaller) << canon::to_text(code);
    EXPECT_LT(smaller->hexahedra.size(), mesh.hexahedra.size());
    EXPECT_EQ(support::fault_of_mesh(*smaller, code), "") << canon::to_text(code);
    options.threads = 3;
    const auto again = flips::smaller_by_annealing(mesh, code.quads, beam, options);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->hexahedra, smaller->hexahedra);
    if (++reduced == 8) break;
  }
  EXPECT_EQ(reduced, 8U);
}

TEST(Annealing, SaysWhenItFoundNothing) {
  const auto beam = grown(12, 5, 100, 6);
  const auto code = beam.codes().front();  // the cube
  const auto mesh = flips::filling_of(beam, beam.fronts_of(code).front().id).mesh;
  EXPECT_FALSE(flips::smaller_by_annealing(mesh, code.quads, beam, {.rounds = 2}));
}

}  // namespace
