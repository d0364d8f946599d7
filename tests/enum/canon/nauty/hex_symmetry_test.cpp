// Claim. The certificate of nauty and the planar code, two roads that share no code, agree on which
// quadrangulations are isomorphic and on group orders; certificates of meshes do not depend on
// labels or threads. Oracle. Each road for the other; symmetry groups of boxes from geometry.
#include "enum/canon/nauty/hex_symmetry.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <thread>
#include <vector>

#include "tests/enum/support.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;
using Certificate = std::vector<std::uint64_t>;

TEST(HexSymmetry, AgreesWithThePlanarCodeOn3ConnectedQuadrangulations) {
  constexpr int kMost = support::kSanitized ? 11 : 12;
  support::Random random(5);
  auto level = support::four_cycle_class();
  std::map<int, std::size_t> classes;
  for (int n = 3; n <= kMost; ++n) {
    level = support::grown(level);
    std::map<Certificate, canon::Code> code_of;
    for (const auto& [code, map] : level) {
      const auto q = support::quadrangulation(map);
      if (!q.is_three_connected()) continue;
      ++classes[n];
      const auto graph = canon::graph_form(q);
      EXPECT_TRUE(code_of.emplace(graph.certificate, code).second) << canon::to_text(code);
      EXPECT_EQ(graph.automorphisms,
                static_cast<std::uint64_t>(canon::canonical_form(q).automorphisms));
      for (int i = 0; i < 4; ++i) {
        const auto copy = support::scrambled(q, random, i % 2 == 1);
        EXPECT_EQ(canon::graph_form(copy).certificate, graph.certificate);
        EXPECT_EQ(canon::canonical_form(copy).code, code);
      }
    }
  }
  std::map<int, std::size_t> expected{{6, 1}, {8, 1}, {9, 1}, {10, 3}, {11, 3}, {12, 11}};
  std::erase_if(expected, [](const auto& row) { return row.first > kMost; });
  EXPECT_EQ(classes, expected);
}

TEST(HexSymmetry, GroupsOfBoxes) {
  const auto order = [](unsigned x, unsigned y, unsigned z) {
    return canon::graph_form(support::mesh_of(oracle::grid(x, y, z))).automorphisms;
  };
  EXPECT_EQ(order(1, 1, 1), 48U);
  EXPECT_EQ(order(2, 1, 1), 16U);
  EXPECT_EQ(order(2, 2, 1), 16U);
  EXPECT_EQ(order(2, 2, 2), 48U);
  EXPECT_EQ(order(3, 2, 1), 8U);
  EXPECT_EQ(order(3, 3, 3), 48U);
  EXPECT_EQ(order(4, 3, 2), 8U);
}

TEST(HexSymmetry, CertificatesDoNotDependOnLabels) {
  support::Random random(7);
  for (int i = 0; i < 40; ++i) {
    const auto cells =
        support::cells_of(support::random_shelling(1 + random.below(12), 40, random));
    const auto mesh = support::mesh_of(cells);
    const auto form = canon::graph_form(mesh);
    for (const bool mirrored : {false, true}) {
      const auto copy = canon::graph_form(support::scrambled(mesh, random, mirrored));
      EXPECT_EQ(copy.certificate, form.certificate);
      EXPECT_EQ(copy.automorphisms, form.automorphisms);
    }
  }
}

TEST(HexSymmetry, DifferentMeshesDiffer) {
  // Four cubes: in a row, in a square, in an L, in a T, in an S; and two tripods. Pairwise
  // different by the number of pairs that share a facet or by their shapes.
  const std::vector<std::vector<std::array<unsigned, 3>>> shapes{
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}};
  const auto box = oracle::grid(4, 4, 4);
  std::set<Certificate> certificates;
  for (const auto& shape : shapes) {
    std::vector<oracle::Cell> cells;
    for (const auto& [x, y, z] : shape) cells.push_back(box[x + 4 * (y + 4 * z)]);
    std::map<std::uint32_t, std::uint32_t> number;
    for (auto& cell : cells)
      for (auto& v : cell)
        v = number.try_emplace(v, static_cast<std::uint32_t>(number.size())).first->second;
    certificates.insert(canon::graph_form(support::mesh_of(cells)).certificate);
  }
  EXPECT_EQ(certificates.size(), shapes.size());
}

}  // namespace
