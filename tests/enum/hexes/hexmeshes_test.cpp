// Claim. Classes are met once each, their sizes add up to the meshes that the search without
// symmetry finds; threads, shards, stops and saved searches change nothing; the topology is right.
// Oracle. HexSearch without symmetry, itself tested against a brute force; the fillings of the cube
// in the literature (two with at most 7 hexahedra).
#include "enum/hexes/hexmeshes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/core/errors.hpp"
#include "enum/search/depth_first.hpp"
#include "tables/build/hexmesh_search.hpp"
#include "tests/enum/hexes/found_meshes.hpp"

namespace {

using namespace hexatlas;
using build::HexmeshTask;
using hexes::HexFrontier;
using hexes::Hexmesh;
using hexes::HexmeshProblem;
using hexes::Topology;
using support::boundary_of;

HexFrontier all_of(const HexmeshProblem& problem, int threads = 1) {
  HexFrontier frontier = problem.begin();
  problem.go_on(frontier, {.threads = threads}, {});
  EXPECT_TRUE(frontier.is_finished());
  return frontier;
}

TEST(Hexmeshes, ClassesAddUpToTheLabelledMeshes) {
  std::size_t classes = 0;
  for (const complex::Quadrangulation& boundary : support::three_connected(10)) {
    const auto limits = support::limits_for(boundary, boundary.quads() == 6 ? 9 : 7);
    const auto labelled = support::search_all(boundary, limits).counts.solutions;
    const HexmeshProblem problem(boundary, limits);
    std::uint64_t sum = 0;
    for (const Hexmesh& found : all_of(problem).found) {
      EXPECT_EQ(problem.symmetries() % found.automorphisms, 0);
      sum += static_cast<std::uint64_t>(problem.symmetries() / found.automorphisms);
      ++classes;
    }
    EXPECT_EQ(sum, labelled);
  }
  EXPECT_GE(classes, 4U);
}

TEST(Hexmeshes, OfTheCubeAreTwoBallsWithAtMostSevenHexahedra) {
  const auto cube = complex::Quadrangulation::cube();
  const HexFrontier frontier = all_of(HexmeshProblem(cube, support::limits_for(cube, 7)));
  ASSERT_EQ(frontier.found.size(), 2U);
  for (const Hexmesh& found : frontier.found) {
    EXPECT_EQ(found.topology, Topology::ball);
    EXPECT_EQ(found.automorphisms, 48);
  }
}

TEST(Hexmeshes, DoNotDependOnThreadsAndShards) {
  const auto boundary = boundary_of("q1:022972977f");
  const HexmeshProblem problem(boundary, support::limits_for(boundary, 10, true));
  const HexFrontier whole = all_of(problem);
  const HexFrontier two = all_of(problem, 2);
  EXPECT_EQ(two.counts, whole.counts);
  EXPECT_EQ(two.found.size(), whole.found.size());
  for (const std::size_t parts : {2U, 3U, 5U}) {
    search::Counts sum;
    std::size_t classes = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      HexFrontier frontier = problem.begin(part, parts);
      problem.go_on(frontier, {}, {});
      sum += frontier.counts;
      classes += frontier.found.size();
    }
    EXPECT_EQ(sum, whole.counts);
    EXPECT_EQ(classes, whole.found.size());
  }
}

TEST(Hexmeshes, AreSavedAndGoneOnWith) {
  const auto boundary = boundary_of("q1:022972977f");
  const HexmeshTask task{boundary, support::limits_for(boundary, 10, true), 0, 1};
  const HexmeshProblem problem(boundary, task.limits);
  const HexFrontier whole = all_of(problem);
  HexFrontier frontier = problem.begin();
  int saves = 0;
  for (; !frontier.is_finished(); ++saves) {
    problem.go_on(frontier, {.max_nodes = 60}, {});
    const std::string text = build::to_text(task, frontier);
    frontier = build::frontier_from(text, task, "saved");
    EXPECT_EQ(build::to_text(task, frontier), text);
  }
  EXPECT_GT(saves, 2);
  EXPECT_EQ(frontier.counts, whole.counts);
  EXPECT_EQ(frontier.found.size(), whole.found.size());
}

TEST(Hexmeshes, DamagedOrForeignSavesAreRefused) {
  const auto boundary = boundary_of("q1:022972977f");
  const HexmeshTask task{boundary, support::limits_for(boundary, 8, true), 0, 1};
  const HexmeshProblem problem(boundary, task.limits);
  HexFrontier frontier = problem.begin();
  problem.go_on(frontier, {.max_nodes = 100}, {});
  const std::string text = build::to_text(task, frontier);
  const auto refused = [&](const std::string& other, const HexmeshTask& of) {
    EXPECT_THROW((void)build::frontier_from(other, of, "saved"), core::InvalidInput);
  };
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string damaged = text;
    damaged[at] = damaged[at] == '1' ? '2' : '1';
    if (damaged != text) refused(damaged, task);
    refused(text.substr(0, at), task);
  }
  HexmeshTask other = task;
  other.limits.max_hexahedra = 9;
  refused(text, other);
  other = task;
  other.parts = 2;
  refused(text, other);
  other = task;
  other.limits.ball = false;
  refused(text, other);
}

TEST(Hexmeshes, OfSchneidersPyramidWithTwentyHexahedraAreNoBalls) {
  // Found by the search; it obeys the rules of the strict rule, and cannot be oriented.
  const std::vector<complex::Hexahedron> prisms{
      {0, 1, 2, 3, 18, 19, 20, 21},     {2, 1, 4, 5, 20, 19, 22, 23},
      {4, 1, 6, 7, 22, 19, 24, 25},     {6, 1, 0, 8, 24, 19, 18, 26},
      {6, 8, 9, 10, 2, 5, 15, 14},      {6, 8, 5, 2, 24, 26, 23, 20},
      {10, 6, 2, 14, 17, 7, 3, 12},     {6, 2, 3, 7, 24, 20, 21, 25},
      {8, 9, 15, 5, 0, 11, 16, 4},      {5, 8, 0, 4, 23, 26, 18, 22},
      {12, 11, 0, 3, 17, 16, 4, 7},     {0, 3, 7, 4, 18, 21, 25, 22},
      {18, 19, 20, 21, 9, 13, 12, 11},  {18, 19, 13, 9, 26, 24, 17, 10},
      {19, 20, 12, 13, 22, 23, 14, 15}, {19, 13, 17, 24, 22, 15, 16, 25},
      {24, 26, 23, 20, 17, 10, 14, 12}, {20, 24, 17, 12, 21, 25, 16, 11},
      {23, 26, 18, 22, 14, 10, 9, 15},  {18, 22, 15, 9, 21, 25, 16, 11}};
  complex::HexComplex mesh{27, {}};
  for (const auto& prism : prisms) {
    auto& cell = mesh.hexahedra.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) cell[std::array{0, 1, 3, 2, 4, 5, 7, 6}[i]] = prism[i];
  }
  std::map<std::vector<complex::VertexId>, int> count;
  for (const auto& cell : mesh.hexahedra)
    for (auto quad : oracle::outer_quads(cell)) {
      std::sort(quad.begin(), quad.end());
      ++count[{quad.begin(), quad.end()}];
    }
  std::set<std::vector<complex::VertexId>> outer, expected;
  for (const auto& [quad, times] : count)
    if (times == 1) outer.insert(quad);
  for (auto quad : boundary_of("q1:02228a2a5777df7f").list_of_quads()) {
    std::sort(quad.begin(), quad.end());
    expected.insert({quad.begin(), quad.end()});
  }
  EXPECT_EQ(outer, expected);
  EXPECT_EQ(hexes::topology_of(mesh), Topology::no_ball);
}

// A complex of ten hexahedra that obeys all laws of a ball near each point, but has a circle that
// bounds nothing.
TEST(Topology, OfAComplexWithHomologyIsNoBall) {
  const auto boundary = boundary_of("q1:02220a48a529577dfdff");
  const hexes::SearchLimits limits{.max_hexahedra = 10, .max_interior = 11, .ball = true};
  hexes::HexSearch search(boundary, limits);
  std::size_t complete = 0;
  (void)search::explore(search, {}, {}, [&](const hexes::HexSearch& found) {
    const complex::HexComplex mesh = hexes::complex_of(found.mesh());
    ++complete;
    EXPECT_FALSE(complex::validate(mesh));
    EXPECT_FALSE(complex::shelling_of(mesh));
    EXPECT_EQ(hexes::topology_of(mesh), Topology::no_ball);
    return true;
  });
  EXPECT_GT(complete, 0U);
  const hexes::HexmeshProblem problem(boundary, limits);
  hexes::HexFrontier frontier = problem.begin();
  problem.go_on(frontier, {}, {});
  EXPECT_TRUE(frontier.is_finished());
  EXPECT_TRUE(frontier.found.empty());
}

}  // namespace
