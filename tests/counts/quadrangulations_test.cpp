// Claim. Simple and 3-connected quadrangulations with up to 11 quads (long: 12), counted by code
// and rooted, are as many as known_counts.tsv says; nauty agrees with the planar code on which
// of the 3-connected ones are isomorphic and on the orders of their groups.
// Oracle. known_counts.tsv, whose numbers are those of plantri, the OEIS and Tutte's formulas;
// nauty, which shares no code with the planar code.
#include <gtest/gtest.h>

#include <map>

#include "enum/canon/nauty/hex_symmetry.hpp"
#include "tests/counts/known_counts.hpp"
#include "tests/counts/quadrangulations.hpp"
#include "tests/share.hpp"

namespace {

using namespace hexatlas;

TEST(QuadrangulationCounts, AreTheKnownOnes) {
  constexpr int kMaxQuads = support::by_length(11, 12);
  support::Random random(7);
  std::map<std::vector<std::uint64_t>, canon::Code> code_of;
  const auto compare_with_nauty = [&](const complex::Quadrangulation& q, const canon::Code& code) {
    const canon::GraphForm graph = canon::graph_form(q);
    EXPECT_TRUE(code_of.emplace(graph.certificate, code).second) << canon::to_text(code);
    EXPECT_EQ(graph.automorphisms,
              static_cast<std::uint64_t>(canon::canonical_form(q).automorphisms));
    for (const bool mirrored : {false, true}) {
      const auto copy = support::scrambled(q, random, mirrored);
      EXPECT_EQ(canon::graph_form(copy).certificate, graph.certificate);
      EXPECT_EQ(canon::canonical_form(copy).code, code);
    }
  };
  const auto table = counts::quadrangulations(kMaxQuads, compare_with_nauty);
  EXPECT_EQ(table.simple, counts::known("simple_quadrangulations", 2, kMaxQuads));
  EXPECT_EQ(table.rooted_simple, counts::known("rooted_simple", 2, kMaxQuads));
  EXPECT_EQ(table.three_connected, counts::known("three_connected_quadrangulations", 6, kMaxQuads));
  EXPECT_EQ(table.rooted_three_connected, counts::known("rooted_three_connected", 6, kMaxQuads));
}

TEST(QuadrangulationCounts, RowsFollowTheFormulas) {
  for (const auto& [n, count] : counts::known("rooted_simple"))
    EXPECT_EQ(oracle::rooted_simple(static_cast<std::uint64_t>(n)), count) << n;
  for (const auto& [n, count] : counts::known("rooted_all"))
    EXPECT_EQ(oracle::rooted_all(static_cast<std::uint64_t>(n)), count) << n;
}

}  // namespace
