// Claim. The search meets each mesh within its limits exactly once, with any prunings switched off
// or on, in any pieces; undo is exact; the number of nodes is that of this version. Oracle. The
// search without prunings; the fillings of the cube in the literature (two with at most 7
// hexahedra: hex-templates); known meshes of the table's least boundaries.
#include "enum/hexes/search.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/core/errors.hpp"
#include "tests/enum/hexes/found_meshes.hpp"

namespace {

using namespace hexatlas;
using complex::Quadrangulation;
using hexes::HexSearch;
using hexes::Prunings;
using support::boundary_of;
using support::limits_for;
using support::search_all;
using support::three_connected;

const char* const kCube = "q1:08a5df";
const char* const kSpindle = "q1:088a577f";
const char* const kPyramid = "q1:02228a2a5777df7f";

const Prunings kNone{.face_budget = false,
                     .links = false,
                     .corner_budget = false,
                     .ears = false,
                     .candidates = false,
                     .cover = false,
                     .partners = false,
                     .balance = false,
                     .barred_tops = false};

/// None; each without the others; ears belong to the corner budget.
std::vector<Prunings> each_alone() {
  std::vector<Prunings> result(9, kNone);
  result[1].face_budget = true;
  result[2].links = true;
  result[3].corner_budget = true;
  result[4].corner_budget = result[4].ears = true;
  result[5].candidates = true;
  result[6].cover = true;
  result[7].partners = true;
  result[8].balance = true;
  return result;
}

bool is_ball(const HexSearch& found) {
  const auto mesh = hexes::complex_of(found.mesh());
  return !complex::validate(mesh) && complex::shelling_of(mesh);
}

TEST(HexSearch, PruningsLoseNothing) {
  std::size_t meshes = 0;
  for (const Quadrangulation& boundary : three_connected(10)) {
    const auto limits = limits_for(boundary, 6);
    const auto all_on = search_all(boundary, limits);
    meshes += all_on.meshes.size();
    for (const Prunings& prunings : each_alone()) {
      const auto found = search_all(boundary, limits, prunings);
      EXPECT_EQ(found.meshes, all_on.meshes);
      EXPECT_EQ(found.counts.solutions, all_on.counts.solutions);
      EXPECT_GE(found.counts.nodes, all_on.counts.nodes);
    }
  }
  EXPECT_GE(meshes, 2U);
}

TEST(HexSearch, PruningsLoseNoneOfTheFillingsOfTheCube) {
  const Quadrangulation cube = boundary_of(kCube);
  for (int hexahedra = 7; hexahedra <= 8; ++hexahedra) {
    const auto found = search_all(cube, limits_for(cube, hexahedra));
    EXPECT_EQ(found.meshes.size(), 2U);
    EXPECT_EQ(found.counts.solutions, 2U);
    EXPECT_EQ(search_all(cube, limits_for(cube, hexahedra), kNone).meshes, found.meshes);
  }
}

TEST(HexSearch, LosesNoBallWhereOnlyBallsAreAskedFor) {
  for (const Quadrangulation& boundary : three_connected(10)) {
    const int most = boundary.quads() == 6 ? 8 : 6;
    const auto all = search_all(boundary, limits_for(boundary, most), kNone, is_ball);
    for (const Prunings& prunings : each_alone())
      EXPECT_EQ(search_all(boundary, limits_for(boundary, most, true), prunings, is_ball).meshes,
                all.meshes);
    EXPECT_EQ(search_all(boundary, limits_for(boundary, most, true), {}, is_ball).meshes,
              all.meshes);
  }
}

/// Where interior vertices are what is scarce.
TEST(HexSearch, PartnersLoseNoBall) {
  std::uint64_t with = 0, without = 0;
  for (const Quadrangulation& boundary : three_connected(10))
    for (int interior = 0; interior <= 8; ++interior) {
      const int most = boundary.quads() == 6 ? 9 : 8;
      const hexes::SearchLimits limits{most, interior, true};
      const auto found = search_all(boundary, limits, {}, is_ball);
      const auto all = search_all(boundary, limits, {.partners = false}, is_ball);
      EXPECT_EQ(found.meshes, all.meshes) << interior;
      with += found.counts.nodes;
      without += all.counts.nodes;
    }
  EXPECT_LT(with, without);
}

/// The images of a complex under the automorphisms of its boundary.
std::set<support::Mesh> images_of(const complex::HexComplex& mesh,
                                  const Quadrangulation& boundary) {
  const auto boundary_vertices = static_cast<std::uint32_t>(boundary.vertices());
  std::set<support::Mesh> images;
  for (const auto& map : hexes::automorphisms_of(boundary)) {
    auto cells = mesh.hexahedra;
    for (auto& cell : cells)
      for (auto& v : cell)
        if (v < boundary_vertices) v = map[v];
    images.insert(support::named(cells, boundary_vertices));
  }
  return images;
}

TEST(HexSearch, FindsOneImageOfEachMeshUpToSymmetry) {
  for (const Quadrangulation& boundary : three_connected(10)) {
    hexes::SearchLimits limits = limits_for(boundary, boundary.quads() == 6 ? 8 : 6);
    const auto all = search_all(boundary, limits);
    limits.up_to_symmetry = true;
    for (const bool barred_tops : {false, true}) {
      HexSearch problem(boundary, limits, {.barred_tops = barred_tops});
      std::set<support::Mesh> images;
      const auto result = search::explore(problem, {}, {}, [&](const HexSearch& found) {
        const auto of_this = images_of(hexes::complex_of(found.mesh()), boundary);
        EXPECT_EQ(of_this.size() * static_cast<std::size_t>(found.automorphisms()),
                  hexes::automorphisms_of(boundary).size());
        for (const auto& image : of_this) EXPECT_FALSE(images.contains(image));
        images.insert(of_this.begin(), of_this.end());
        return true;
      });
      EXPECT_LE(result.counts.nodes, all.counts.nodes);
      EXPECT_EQ(images, all.meshes);
    }
  }
}

TEST(HexSearch, FindsBallsThatObeyTheLaws) {
  for (const Quadrangulation& boundary : three_connected(10)) {
    HexSearch problem(boundary, limits_for(boundary, 6, true));
    (void)search::explore(problem, {}, {}, [&](const HexSearch& found) {
      const auto mesh = hexes::complex_of(found.mesh());
      EXPECT_FALSE(complex::validate(mesh));
      std::vector<complex::BoundaryQuad> quads;
      for (const auto& quad : boundary.list_of_quads())
        quads.push_back({quad[0], quad[1], quad[2], quad[3]});
      EXPECT_TRUE(complex::has_boundary(mesh, quads));
      return true;
    });
  }
}

struct Signature {
  const char* code = nullptr;
  int hexahedra = 0;
  bool ball = false;
  search::Counts counts;
};

TEST(HexSearch, HasTheNodesOfThisVersion) {
  for (const Signature& pinned : {
           Signature{kCube, 7, true, {2, 38}},
           Signature{kCube, 7, false, {2, 43}},
           Signature{kSpindle, 14, true, {0, 895}},
           Signature{kSpindle, 14, false, {0, 2602}},
           Signature{kPyramid, 9, true, {0, 651}},
           Signature{kPyramid, 9, false, {0, 1731}},
       }) {
    const Quadrangulation boundary = boundary_of(pinned.code);
    const auto found = search_all(boundary, limits_for(boundary, pinned.hexahedra, pinned.ball));
    EXPECT_EQ(found.counts.solutions, pinned.counts.solutions) << pinned.code;
    EXPECT_EQ(found.counts.nodes, pinned.counts.nodes) << pinned.code << pinned.ball;
  }
  const auto few_interior = search_all(boundary_of(kPyramid), {hexes::kMaxHexahedra, 8, true});
  EXPECT_EQ(few_interior.counts, (search::Counts{0, 2171}));
}

TEST(HexSearch, KeepsToItsLimits) {
  const Quadrangulation cube = boundary_of(kCube);
  EXPECT_EQ(search_all(cube, {7, 7, false}).meshes.size(), 1U);
  EXPECT_EQ(search_all(cube, {7, 8, false}).meshes.size(), 2U);
  EXPECT_EQ(search_all(cube, {6, 30, false}).meshes.size(), 1U);
  EXPECT_EQ(search_all(cube, {0, 0, false}).meshes.size(), 0U);
  EXPECT_EQ(hexes::most_interior_vertices(6, 7), 12);
  EXPECT_EQ(hexes::most_interior_vertices(16, 1), 0);
  EXPECT_THROW(HexSearch(cube, {hexes::kMaxHexahedra + 1, 0, false}), core::PreconditionViolated);
  EXPECT_THROW(HexSearch(cube, {1, hexes::kMaxMeshVertices, false}), core::PreconditionViolated);
}

TEST(HexSearch, MayBeCutIntoPieces) {
  const Quadrangulation pyramid = boundary_of(kPyramid);
  const auto limits = limits_for(pyramid, 9);
  const search::Counts whole = search_all(pyramid, limits).counts;
  for (const std::size_t depth : {std::size_t{1}, std::size_t{6}, std::size_t{11}}) {
    HexSearch problem(pyramid, limits);
    const auto nothing = [](const HexSearch&) { return true; };
    auto top = search::explore(problem, {}, {.depth = depth}, nothing);
    search::Counts sum = top.counts;
    while (!top.unexplored.empty()) {
      const auto root = std::move(top.unexplored.back());
      top.unexplored.pop_back();
      auto part = search::explore(problem, root, {.nodes = 1000}, nothing);
      sum += part.counts;
      for (auto& left : part.unexplored) top.unexplored.push_back(std::move(left));
    }
    EXPECT_EQ(sum, whole);
  }
}

void expect_exact_undo(bool ball) {
  const Quadrangulation pyramid = boundary_of(kPyramid);
  HexSearch problem(pyramid, limits_for(pyramid, 12, ball));
  support::Random random(3);
  const auto choices = [&] {
    std::vector<int> result;
    for (const HexSearch::Choice choice : problem.choices()) result.push_back(choice.top);
    return result;
  };
  int completed = 0;
  for (int walk = 0; walk < 300; ++walk) {
    std::vector<std::vector<int>> before;
    for (int tries = 0; tries < 40; ++tries) {
      const std::vector<int> now = choices();
      if (now.empty()) break;
      const auto top = static_cast<hexes::Vertex>(now[random.below(now.size())]);
      if (problem.apply({top}))
        before.push_back(now);
      else
        EXPECT_EQ(choices(), now);
    }
    completed += static_cast<int>(problem.mesh().cells().size());
    for (; !before.empty(); before.pop_back()) {
      problem.undo();
      EXPECT_EQ(choices(), before.back());
    }
    EXPECT_EQ(problem.mesh().open_count(), pyramid.quads());
    EXPECT_EQ(problem.mesh().vertices(), pyramid.vertices());
  }
  EXPECT_GT(completed, 200);
}

TEST(HexSearch, UndoIsExact) {
  expect_exact_undo(false);
  expect_exact_undo(true);
}

}  // namespace
