// Claim. rooted_three_connected(n) is the sum of 8n / |Aut| over all 3-connected quadrangulations
// with n quads, exactly, up to 32 quads.
// Oracle. Pinned numbers that were computed elsewhere by substitution into c-nets; the sum over all
// 3-connected quadrangulations made by vertex splits; the equations of rooted-count.md, solved here
// in another way: cores by the algebraic function of Tutte's numbers, arithmetic modulo 2^64.
#include "tables/check/rooted_count.hpp"

#include <gtest/gtest.h>

#include "tests/counts/quadrangulations.hpp"
#include "tests/share.hpp"

namespace hexatlas::check {
namespace {

TEST(RootedCount, IsThePinnedOne) {
  const std::vector<std::uint64_t> known = {1, 0, 4, 6, 29, 88, 310, 1066, 3700, 13036, 46092};
  const std::vector<std::uint64_t> counted = rooted_three_connected(16);
  ASSERT_EQ(counted.size(), 17U);
  for (std::size_t n = 0; n < 6; ++n) EXPECT_EQ(counted[n], 0U);
  EXPECT_EQ(std::vector<std::uint64_t>(counted.begin() + 6, counted.end()), known);
  for (const std::uint32_t few : {0U, 1U, 2U, 6U}) {
    const std::vector<std::uint64_t> beginning = rooted_three_connected(few);
    EXPECT_TRUE(std::equal(beginning.begin(), beginning.end(), counted.begin()));
    EXPECT_EQ(beginning.size(), few + 1);
  }
}

TEST(RootedCount, IsTheSumOverVertexSplits) {
  constexpr int kMaxQuads = support::by_length(10, 12);
  const auto table = counts::quadrangulations(
      kMaxQuads, [](const complex::Quadrangulation&, const canon::Code&) {});
  const std::vector<std::uint64_t> counted = rooted_three_connected(kMaxQuads);
  for (const auto& [quads, sum] : table.rooted_three_connected) {
    EXPECT_EQ(counted[static_cast<std::size_t>(quads)], sum) << quads;
  }
}

/// Power series modulo 2^64 up to one degree.
using Residues = std::vector<std::uint64_t>;

Residues operator*(const Residues& a, const Residues& b) {
  Residues product(a.size(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; i + j < a.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}
Residues operator+(Residues a, const Residues& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}
Residues operator-(Residues a, const Residues& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}
Residues monomial(std::size_t terms, std::size_t degree, std::uint64_t factor) {
  Residues series(terms, 0);
  series[degree] = factor;
  return series;
}

/// D = t (1 - 2t) / (1 - t)^2 for z = t (1 - t)^2, so t = D (1 - t)^2 + 2 t^2 as a series in D, and
/// the cores are D - 2 D^2 / (1 + D) - z.
Residues cores_by_algebra(std::size_t terms) {
  const Residues one = monomial(terms, 0, 1);
  const Residues u = monomial(terms, 1, 1);
  Residues t(terms, 0);
  for (std::size_t i = 0; i < terms; ++i) t = u * (one - t) * (one - t) + t * t + t * t;
  Residues alternating(terms, 0);  // u^2 / (1 + u)
  for (std::size_t i = 2; i < terms; ++i) alternating[i] = i % 2 == 0 ? 1 : ~std::uint64_t{0};
  return u - alternating - alternating - t * (one - t) * (one - t);
}

TEST(RootedCount, IsTheSolutionOfTheEquationsModulo2To64) {
  constexpr std::size_t kTerms = kMostCountedQuads;
  const Residues core = cores_by_algebra(kTerms);
  const Residues one = monomial(kTerms, 0, 1);
  const Residues z = monomial(kTerms, 1, 1);
  // S, A = S + H and 1 / (1 - A) side by side, from nothing.
  Residues series(kTerms, 0), repeated = one, with_core(kTerms, 0);
  for (std::size_t round = 0; round < 2 * kTerms; ++round) {
    const Residues parts = series + with_core;
    repeated = one + parts * repeated;
    series = parts * parts * repeated + z * (repeated * repeated - one);
    const Residues all = z + series + series + with_core;
    Residues power = one, sum(kTerms, 0);
    for (std::size_t j = 1; j < kTerms; ++j) {
      power = power * all;
      for (std::size_t i = 0; i < kTerms; ++i) sum[i] += core[j] * power[i];
    }
    with_core = sum;
  }
  const Residues parts = series + with_core;
  const Residues twice = parts * parts * repeated;
  const Residues total = with_core + twice + twice;
  const std::vector<std::uint64_t> counted = rooted_three_connected(kMostCountedQuads);
  for (std::size_t n = 1; n <= kTerms; ++n) EXPECT_EQ(counted[n], total[n - 1]) << n;
}

}  // namespace
}  // namespace hexatlas::check
