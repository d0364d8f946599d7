// Claim. Quadrangulation names each broken law; the cube is one; maps with multiple edges are
// accepted as darts; is_three_connected() is 3-connectedness; irregularity() is the sum of
// (degree - 4)^2, at most that of a trapezohedron if it is.
// Oracle. Lists with one fault each, and, for connectivity, the removal of every pair of vertices
// in all simple quadrangulations with 2..10 quads, themselves generated without hexatlas.
#include "enum/complex/quadrangulation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/core/errors.hpp"
#include "tests/oracles/quadrangulations.hpp"

namespace {

using namespace hexatlas;
using complex::Dart;
using complex::Quadrangulation;
using complex::QuadVertices;
using complex::Vertex;
using Quads = std::vector<QuadVertices>;

/// The reference cube written by hand: bottom, top and four walls.
const Quads kCube{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};

std::string fault_of(const Quads& quads) {
  EXPECT_EQ(Quadrangulation::from_quads(quads).has_value(),
            !complex::broken_law(quads).has_value());
  const auto law = complex::broken_law(quads);
  return law ? law->reason : "none";
}

TEST(Quadrangulation, TheCubeIsOne) {
  EXPECT_EQ(fault_of(kCube), "none");
  const Quadrangulation cube = Quadrangulation::cube();
  EXPECT_EQ(cube.quads(), 6);
  EXPECT_EQ(cube.vertices(), 8);
  EXPECT_FALSE(cube.validate());
  EXPECT_TRUE(cube.is_three_connected());
  EXPECT_EQ(cube.list_of_quads().size(), 6U);
  const auto degrees = cube.degrees();
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(degrees[v], 3);
  for (int i = 0; i < cube.darts(); ++i) {
    const auto d = static_cast<Dart>(i);
    EXPECT_EQ(cube.turn_right(cube.turn_left(d)), d);
    EXPECT_EQ(cube.origin(cube.turn_left(d)), cube.origin(d));
  }
}

TEST(Quadrangulation, NamesTheBrokenLaw) {
  EXPECT_EQ(fault_of({}), "the number of quads must be from 1 to 64, here it is 0");
  EXPECT_EQ(fault_of(Quads(65, {0, 1, 2, 3})),
            "the number of quads must be from 1 to 64, here it is 65");

  Quads open = kCube;
  open.pop_back();  // five quads have vertices 0 .. 6 at most
  EXPECT_NE(fault_of(open).find("a sphere of 5 quads has 7 vertices, but vertex 7 occurs"),
            std::string::npos);

  Quads one_only = kCube;
  one_only[5] = {2, 0, 4, 7};
  EXPECT_NE(fault_of(one_only).find("is in one quad only"), std::string::npos);

  Quads turned = kCube;
  turned[0] = {0, 1, 3, 2};
  EXPECT_NE(fault_of(turned).find("used twice in the same direction"), std::string::npos);

  EXPECT_EQ(fault_of({{0, 0, 1, 2}}), "an edge joins a vertex to itself");

  // Two pillows: components with 4 vertices each, while 4 quads of a sphere have 6.
  EXPECT_NE(fault_of({{0, 1, 2, 3}, {3, 2, 1, 0}, {4, 5, 6, 7}, {7, 6, 5, 4}})
                .find("but vertex 6 occurs"),
            std::string::npos);
  // Two pillows that touch in two vertices.
  EXPECT_NE(
      fault_of({{0, 1, 2, 3}, {3, 2, 1, 0}, {0, 4, 2, 5}, {5, 2, 4, 0}}).find("is not a circle"),
      std::string::npos);
}

Quadrangulation pillows(int vertices_of_second) {
  const std::vector<Vertex> origin{0, 1, 2, 3, 3, 2, 1, 0, 4, 5, 6, 7, 7, 6, 5, 4};
  std::vector<Dart> twin;
  for (const int base : {0, 8})
    for (const int d : {6, 5, 4, 7, 2, 1, 0, 3}) twin.push_back(static_cast<Dart>(base + d));
  return Quadrangulation::from_darts(origin, twin, vertices_of_second);
}

TEST(Quadrangulation, DartsAreCheckedForEachLaw) {
  EXPECT_EQ(pillows(8).validate()->reason, "the surface has several components");
  EXPECT_EQ(pillows(9).validate()->reason, "a vertex is in no quad");
  EXPECT_EQ(pillows(7).validate()->reason, "a vertex number is out of range");
  EXPECT_EQ(Quadrangulation().validate()->reason, "there is no quad");

  // One quad with opposite sides glued: a torus with one vertex, two edges.
  const std::vector<Vertex> torus_origin{0, 0, 0, 0};
  const std::vector<Dart> torus_twin{2, 3, 0, 1};
  EXPECT_EQ(Quadrangulation::from_darts(torus_origin, torus_twin, 1).validate()->reason,
            "the Euler characteristic is 0, a sphere has 2");

  const std::vector<Dart> fixed{0, 3, 2, 1};
  const std::vector<Vertex> four{0, 1, 2, 3};
  EXPECT_EQ(Quadrangulation::from_darts(four, fixed, 4).validate()->reason,
            "two quads disagree about the edge that they share");
  const std::vector<Dart> folded{1, 0, 3, 2};
  EXPECT_EQ(Quadrangulation::from_darts(four, folded, 4).validate()->reason,
            "an edge does not join the same vertices in its two quads");
  EXPECT_THROW((void)Quadrangulation::from_darts(four, std::vector<Dart>{1, 0}, 4),
               core::PreconditionViolated);
}

TEST(Quadrangulation, MultipleEdgesAreAllowedAsDarts) {
  // One quad folded onto a path 1-0-2: sides 0 and 1 glued together, as are sides 2 and 3.
  const std::vector<Vertex> path{0, 1, 0, 2};
  const std::vector<Dart> folded{1, 0, 3, 2};
  const Quadrangulation q = Quadrangulation::from_darts(path, folded, 3);
  EXPECT_FALSE(q.validate());
  EXPECT_FALSE(q.is_three_connected());

  // Two folded quads, opened along one edge each and glued there: edges 0-1 twice.
  const std::vector<Vertex> origin{0, 1, 0, 2, 1, 0, 1, 3};
  const std::vector<Dart> twin{4, 5, 3, 2, 0, 1, 7, 6};
  const Quadrangulation two = Quadrangulation::from_darts(origin, twin, 4);
  EXPECT_FALSE(two.validate()) << two.validate()->reason;
  EXPECT_FALSE(Quadrangulation::from_quads(two.list_of_quads()).has_value());
}

TEST(Quadrangulation, ThreeConnectedIfNoTwoVerticesSeparate) {
  std::map<canon::Code, oracle::Rotations> level;
  const auto add = [](std::map<canon::Code, oracle::Rotations>& to, const oracle::Rotations& map) {
    const auto q = Quadrangulation::from_quads(oracle::quads_of(map));
    ASSERT_TRUE(q.has_value());
    to.emplace(canon::canonical_form(*q).code, map);
  };
  add(level, oracle::four_cycle());
  int yes = 0;
  int no = 0;
  for (int n = 2; n <= 10; ++n) {
    std::map<canon::Code, oracle::Rotations> next;
    for (const auto& [code, map] : level) {
      const auto q = Quadrangulation::from_quads(oracle::quads_of(map)).value();
      const bool expected = oracle::is_three_connected(map);
      EXPECT_EQ(q.is_three_connected(), expected) << canon::to_text(code);
      ++(expected ? yes : no);
      int irregularity = 0;
      for (const auto& round : map) {
        const int degree = static_cast<int>(round.size());
        irregularity += (degree - 4) * (degree - 4);
      }
      EXPECT_EQ(q.irregularity(), irregularity) << canon::to_text(code);
      if (expected) {
        EXPECT_LE(2 * irregularity, (n - 8) * (n - 8) + 2 * n);
      }
      if (n < 10)
        for (const auto& split : oracle::splits_of(map)) add(next, split);
    }
    level = std::move(next);
  }
  EXPECT_EQ(yes, 1 + 1 + 1 + 3);  // A007022: n = 6, 8, 9, 10
  EXPECT_EQ(no, 1 + 1 + 2 + 3 + 9 + 18 + 62 + 198 + 803 - yes);
}

}  // namespace
