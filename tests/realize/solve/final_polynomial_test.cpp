// Claim. Final polynomials are found for signs of no points, never for signs of points, and
// is_proof() accepts them only. Oracle. Random integer points; the weighted sum evaluated at random
// values of the logarithms, with signs of determinants computed in this file; mutations.
#include "realize/solve/final_polynomial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "enum/core/errors.hpp"
#include "tests/realize/random_points.hpp"

namespace {

using namespace hexatlas;
using certificate::FinalPolynomial;
using certificate::FinalPolynomialTerm;
using chirotope::Signs;

/// Two of the 24 reorientation classes (Bokowski, Richter-Gebert) of uniform oriented matroids of
/// rank 4 on eight elements that are not those of vectors.
constexpr std::array<std::string_view, 2> kNotOfPoints{
    "+++-+++-++-++-+++-+-+-+---+-++-+--++--+-+--++-+--+-+-+-----+++---+--+-",
    "--+-+---+--++-++------+-----+--+--+-+--+--++-++-------+-++--+---+---++"};

Signs signs_from(std::string_view text) {
  Signs signs;
  for (const char letter : text) signs.push_back(letter == '+' ? 1 : -1);
  return signs;
}

/// A determinant of four points in any order: those ascending, and the sign of the permutation.
std::pair<std::array<int, 4>, int> sorted_determinant(std::array<int, 4> points) {
  int sign = 1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (points[i] > points[k]) sign = -sign;
  std::sort(points.begin(), points.end());
  return {points, sign};
}

/// The products of a term: two determinants each, and a sign in front.
struct Product {
  std::array<std::array<int, 4>, 2> determinants{};
  int sign = 1;
};
Product product(const FinalPolynomialTerm& term, int number) {
  const auto [a, b] = term.common;
  const auto [w, x, y, z] = term.others;
  const std::array<std::array<int, 4>, 3> first{{{a, b, w, x}, {a, b, w, y}, {a, b, w, z}}};
  const std::array<std::array<int, 4>, 3> second{{{a, b, y, z}, {a, b, x, z}, {a, b, x, y}}};
  const auto place = static_cast<std::size_t>(number - 1);
  const auto [one, one_sign] = sorted_determinant(first[place]);
  const auto [two, two_sign] = sorted_determinant(second[place]);
  return {{one, two}, one_sign * two_sign * (number == 2 ? -1 : 1)};
}

std::map<std::array<int, 4>, std::size_t> numbering() {
  std::map<std::array<int, 4>, std::size_t> number;
  for (int d = 3; d < 16; ++d)
    for (int c = 2; c < d; ++c)
      for (int b = 1; b < c; ++b)
        for (int a = 0; a < b; ++a) number.emplace(std::array<int, 4>{a, b, c, d}, number.size());
  return number;
}

/// Tested at random values: a sum that is not 0 identically vanishes with probability below 2^-30.
void expect_proof(const FinalPolynomial& polynomial, const Signs& signs) {
  const auto number = numbering();
  std::mt19937_64 random(7);
  std::vector<std::int64_t> logarithm(number.size());
  for (auto& value : logarithm) value = static_cast<std::int64_t>(random() % (1U << 30U));
  std::int64_t sum = 0;
  for (const FinalPolynomialTerm& term : polynomial.terms) {
    EXPECT_GE(term.weight, 1);
    std::array<int, 4> sign{};
    for (int i = 1; i <= 3; ++i) {
      const Product p = product(term, i);
      sign[static_cast<std::size_t>(i)] = p.sign;
      for (const auto& determinant : p.determinants) {
        const std::size_t place = number.at(determinant);
        sign[static_cast<std::size_t>(i)] *= signs[place];
        const auto literal = static_cast<std::int32_t>(signs[place] > 0 ? -1 : 1) *
                             static_cast<std::int32_t>(place + 1);
        EXPECT_EQ(std::count(polynomial.clause.begin(), polynomial.clause.end(), literal), 1);
        if (i == term.larger) sum += term.weight * logarithm[place];
        if (i == term.smaller) sum -= term.weight * logarithm[place];
      }
    }
    for (std::uint8_t i = 1; i <= 3; ++i) EXPECT_EQ(sign[i] == sign[term.larger], i == term.larger);
  }
  EXPECT_EQ(sum, 0);
}

TEST(FinalPolynomials, SignsOfNoPointsHaveOne) {
  for (const std::string_view text : kNotOfPoints) {
    const Signs signs = signs_from(text);
    ASSERT_TRUE(sample::satisfies_all(signs, chirotope::grassmann_pluecker_clauses(8)));
    ASSERT_TRUE(sample::satisfies_all(signs, chirotope::acyclic_clauses(8)));
    const auto polynomial = solve::find_final_polynomial(8, signs);
    ASSERT_TRUE(polynomial.has_value());
    EXPECT_TRUE(solve::is_proof(*polynomial));
    expect_proof(*polynomial, signs);
    EXPECT_LE(polynomial->clause.size(), 30U);
    EXPECT_EQ(solve::find_final_polynomial(8, signs), polynomial);
    EXPECT_FALSE(sample::satisfies(signs, polynomial->clause));
  }
}

TEST(FinalPolynomials, NoOtherSignsAreNeeded) {
  const Signs signs = signs_from(kNotOfPoints[0]);
  const auto polynomial = solve::find_final_polynomial(8, signs);
  ASSERT_TRUE(polynomial.has_value());
  Signs partial(signs.size(), 0);
  for (const auto literal : polynomial->clause)
    partial[static_cast<std::size_t>(std::abs(literal)) - 1] = literal > 0 ? -1 : 1;
  const auto again = solve::find_final_polynomial(8, partial);
  ASSERT_TRUE(again.has_value());
  expect_proof(*again, signs);
  // Without one of them there is none: the determinants of the answer are indispensable.
  for (const auto literal : again->clause) {
    Signs fewer = partial;
    fewer[static_cast<std::size_t>(std::abs(literal)) - 1] = 0;
    EXPECT_FALSE(solve::find_final_polynomial(8, fewer).has_value());
  }
}

TEST(FinalPolynomials, SignsOfPointsHaveNone) {
  std::vector<FinalPolynomial> polynomials;
  polynomials.reserve(kNotOfPoints.size());
  for (const std::string_view text : kNotOfPoints)
    polynomials.push_back(solve::find_final_polynomial(8, signs_from(text)).value());
  std::mt19937_64 random(1);
  for (int i = 0; i < 20; ++i) {
    const Signs signs = sample::signs_of(sample::random_points(8, 100, random));
    EXPECT_FALSE(solve::find_final_polynomial(8, signs).has_value());
    for (const FinalPolynomial& polynomial : polynomials)
      EXPECT_TRUE(sample::satisfies(signs, polynomial.clause));
  }
  EXPECT_FALSE(solve::find_final_polynomial(8, Signs(70, 0)).has_value());
  EXPECT_FALSE(solve::find_final_polynomial(5, Signs(5, 1)).has_value());
}

TEST(FinalPolynomials, MutationsAreNoProofs) {
  const auto found = solve::find_final_polynomial(8, signs_from(kNotOfPoints[0]));
  ASSERT_TRUE(found.has_value());
  const auto expect_refused = [&](const auto& mutate) {
    FinalPolynomial polynomial = *found;
    mutate(polynomial);
    EXPECT_FALSE(solve::is_proof(polynomial));
  };
  expect_refused([](FinalPolynomial& p) { p.terms.clear(); });
  expect_refused([](FinalPolynomial& p) { p.clause.push_back(-p.clause[0]); });
  expect_refused([](FinalPolynomial& p) { p.clause.push_back(0); });
  expect_refused([](FinalPolynomial& p) { p.clause.push_back(1821); });
  for (std::size_t i = 0; i < found->clause.size(); ++i) {
    expect_refused(
        [&](FinalPolynomial& p) { p.clause.erase(p.clause.begin() + static_cast<int>(i)); });
    expect_refused([&](FinalPolynomial& p) { p.clause[i] = -p.clause[i]; });
  }
  for (std::size_t i = 0; i < found->terms.size(); ++i) {
    expect_refused(
        [&](FinalPolynomial& p) { p.terms.erase(p.terms.begin() + static_cast<int>(i)); });
    expect_refused([&](FinalPolynomial& p) { ++p.terms[i].weight; });
    expect_refused([&](FinalPolynomial& p) { p.terms[i].weight = -p.terms[i].weight; });
    expect_refused([&](FinalPolynomial& p) { std::swap(p.terms[i].larger, p.terms[i].smaller); });
    expect_refused([&](FinalPolynomial& p) { p.terms[i].larger = p.terms[i].smaller; });
    expect_refused([&](FinalPolynomial& p) { p.terms[i].smaller = 4; });
    expect_refused([&](FinalPolynomial& p) {
      p.terms[i].smaller = static_cast<std::uint8_t>(6 - p.terms[i].larger - p.terms[i].smaller);
    });
    expect_refused(
        [&](FinalPolynomial& p) { std::swap(p.terms[i].common[0], p.terms[i].common[1]); });
    expect_refused(
        [&](FinalPolynomial& p) { std::swap(p.terms[i].others[0], p.terms[i].others[1]); });
    expect_refused([&](FinalPolynomial& p) { p.terms[i].others[0] = p.terms[i].common[0]; });
    expect_refused([&](FinalPolynomial& p) { p.terms[i].others[3] = 16; });
  }
}

TEST(FinalPolynomials, NonsenseIsRefused) {
  EXPECT_THROW((void)solve::find_final_polynomial(8, Signs(69)), core::PreconditionViolated);
}

}  // namespace
