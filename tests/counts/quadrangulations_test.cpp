// Claim. Simple and 3-connected quadrangulations with up to 11 quads (long: 14), counted by code
// and rooted, are as many as known_counts.tsv says. Oracle. known_counts.tsv, whose numbers are
// those of plantri, the OEIS and Tutte's formulas.
#include <gtest/gtest.h>

#include "tests/counts/known_counts.hpp"
#include "tests/counts/quadrangulations.hpp"

namespace {

using namespace hexatlas;

TEST(QuadrangulationCounts, AreTheKnownOnes) {
  constexpr int kMaxQuads = HEXATLAS_MAX_QUADS;
  const auto table = counts::quadrangulations(kMaxQuads);
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
