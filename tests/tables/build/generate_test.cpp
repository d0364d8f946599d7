// Claim. three_connected_codes() lists the 3-connected quadrangulations with an even number of
// quads; generate() finds checked meshes, the same for any number of threads; the named boundaries
// are the surfaces that their descriptions say. Oracle. Vertex splits of tests/oracles; meshes
// checked by sets and by the judge; surfaces made here.
#include "tables/build/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tables/build/named.hpp"
#include "tables/check/table_check.hpp"
#include "tests/counts/known_counts.hpp"
#include "tests/enum/support.hpp"

namespace {

using namespace hexatlas;

TEST(ThreeConnectedCodes, AreThoseOfVertexSplits) {
  std::set<canon::Code> expected;
  auto level = support::four_cycle_class();
  for (int n = 3; n <= 12; ++n) {
    level = support::grown(level);
    for (const auto& [code, map] : level)
      if (n % 2 == 0 && oracle::is_three_connected(map)) expected.insert(code);
  }
  const auto codes = build::three_connected_codes(12);
  EXPECT_TRUE(std::equal(codes.begin(), codes.end(), expected.begin(), expected.end()));
  EXPECT_TRUE(std::is_sorted(codes.begin(), codes.end()));
}

TEST(ThreeConnectedCodes, AreAsManyAsKnown) {
  std::map<int, std::uint64_t> counted;
  for (const auto& code : build::three_connected_codes(14)) ++counted[code.quads];
  auto expected = counts::known("three_connected_quadrangulations", 6, 14);
  std::erase_if(expected, [](const auto& row) { return row.first % 2 == 1; });
  EXPECT_EQ(counted, expected);
}

std::vector<build::Stage> small_stages(int threads) {
  build::Stage stage;
  stage.balls.max_quads = 18;
  stage.balls.fronts_per_class = 5;
  stage.balls.fronts_per_level = 1'000;
  stage.balls.threads = threads;
  stage.max_ball = 12;
  stage.collars = stage.balls;
  stage.collars.fronts_per_level = 200;
  stage.max_collar = 3;
  build::Stage second = stage;
  second.collars.max_quads = 20;
  second.max_collar = 5;
  second.only_missing = true;
  return {stage, second};
}

TEST(Generate, FillsWhatItSays) {
  const auto codes = build::three_connected_codes(12);
  std::size_t reports = 0;
  const auto made = build::generate(codes, small_stages(1), [&](const build::Progress& progress) {
    ++reports;
    EXPECT_LE(progress.done, progress.total);
  });
  EXPECT_GT(reports, 0U);
  EXPECT_EQ(made.rows.size() + made.without_mesh.size(), codes.size());
  EXPECT_GE(made.rows.size(), 4U);
  for (const auto& row : made.rows) {
    EXPECT_EQ(support::fault_of_filling(row.mesh, row.code), "") << canon::to_text(row.code);
    EXPECT_EQ(row.lower_bound, 1);
  }
  const std::string bytes = format::table_bytes(made.rows, {});
  const auto verdict = check::check_table_bytes(bytes);
  EXPECT_TRUE(verdict.accepted) << verdict.reason;
  const auto again = build::generate(codes, small_stages(3), [](const build::Progress&) {});
  EXPECT_EQ(format::table_bytes(again.rows, {}), bytes);
  EXPECT_EQ(again.without_mesh, made.without_mesh);
}

canon::Code code_of(const oracle::QuadList& quads) {
  return canon::canonical_form(complex::Quadrangulation::from_quads(quads).value()).code;
}
std::uint8_t id(unsigned v) { return static_cast<std::uint8_t>(v); }

/// k quads around each of two poles.
oracle::QuadList trapezohedron(unsigned k) {
  oracle::QuadList quads;
  const auto belt = [&](unsigned i) { return id(2 + i % (2 * k)); };
  for (unsigned i = 0; i < k; ++i) {
    quads.push_back({0, belt(2 * i), belt(2 * i + 1), belt(2 * i + 2)});
    quads.push_back({1, belt(2 * i + 3), belt(2 * i + 2), belt(2 * i + 1)});
  }
  return quads;
}

/// A square pyramid: base corners, base mid-edges, base centre, mid-edges to the apex, centres of
/// sides.
oracle::QuadList pyramid() {
  oracle::QuadList quads;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = (i + 1) % 4, h = (i + 3) % 4;
    const auto corner = [](unsigned k) { return id(k); };
    const auto base = [](unsigned k) { return id(4 + k); };     // between corners k and k + 1
    const auto lateral = [](unsigned k) { return id(8 + k); };  // between corner k and the apex
    const auto side = [](unsigned k) { return id(12 + k); };
    const auto centre = id(16), apex = id(17);
    quads.push_back({corner(i), base(h), centre, base(i)});
    quads.push_back({corner(i), base(i), side(i), lateral(i)});
    quads.push_back({base(i), corner(j), lateral(j), side(i)});
    quads.push_back({side(i), lateral(j), apex, lateral(i)});
  }
  return quads;
}

/// Edges of the cube as rhombi: cube vertices 0 .. 7, the points above its facets 8 .. 13.
oracle::QuadList rhombic_dodecahedron() {
  oracle::QuadList quads;
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned v = 0; v < 8; ++v) {
      if ((v >> axis & 1U) != 0) continue;
      const unsigned y = (axis + 1) % 3, z = (axis + 2) % 3;
      const unsigned a = 8 + 2 * y + (v >> y & 1U), b = 8 + 2 * z + (v >> z & 1U);
      const bool turned = ((v >> y ^ v >> z) & 1U) != 0;
      oracle::QuadList::value_type quad{id(v), id(a), id(v | 1U << axis), id(b)};
      if (turned) std::swap(quad[1], quad[3]);
      quads.push_back(quad);
    }
  return quads;
}

TEST(Named, BoundariesAreTheSurfacesDescribed) {
  std::map<std::string, canon::Code> expected{
      {"cube", code_of(trapezohedron(3))},
      {"octagonal-spindle", code_of(trapezohedron(4))},
      {"rhombic-dodecahedron", code_of(rhombic_dodecahedron())},
      {"schneiders-pyramid", code_of(pyramid())}};
  oracle::QuadList two;
  for (const auto& quad : oracle::boundary(oracle::grid(2, 1, 1)))
    two.push_back({id(quad[0]), id(quad[1]), id(quad[2]), id(quad[3])});
  expected["two-cubes"] = code_of(two);
  std::map<std::string, canon::Code> named;
  for (const auto& boundary : build::kNamedBoundaries)
    named[std::string(boundary.name)] = canon::from_text(boundary.code).value();
  EXPECT_EQ(named, expected);
}

}  // namespace
