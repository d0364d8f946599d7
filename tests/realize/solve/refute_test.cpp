// Claim. The signs of a triangulation have a model or a refutation, and the refutation is valid.
// Oracle. The three triangulations of the hexahedron, with 15 tetrahedra each, that are not
// realizable (Pellerin, Verhetsel, Remacle 2018), and one that is; premises compared with the
// clauses of the conditions, hints checked by strict_rup.hpp.
#include "realize/solve/refute.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <string_view>

#include "enum/core/errors.hpp"
#include "realize/conditions/clauses.hpp"
#include "realize/solve/final_polynomial.hpp"
#include "tests/realize/random_points.hpp"
#include "tests/realize/solve/strict_rup.hpp"

namespace {

using namespace hexatlas;
using certificate::Condition;
using certificate::Refutation;
using chirotope::Signs;
using complex::Triangulation;
using solve::Clause;
using solve::SignSearch;

constexpr std::array<std::string_view, 3> kNotRealizable{
    "0124 0134 1234 0135 0345 2345 1356 2356 0247 2457 0267 1367 0467 1567 2567",
    "0124 0134 1234 0345 2345 0156 0356 2356 0137 2457 0167 0367 2467 1567 2567",
    "0134 0235 1246 1256 0356 2356 1456 0247 1247 0347 1347 0257 1257 0367 0567"};
/// The tetrahedron 1247 in the middle of the cube, and the corners 0, 3, 5, 6.
constexpr std::string_view kFive = "0124 1237 1247 1457 2467";

Triangulation triangulation_from(std::string_view text) {
  Triangulation triangulation{8, {}};
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    complex::VertexSet set = 0;
    for (const char digit : word) set |= complex::bit_of(digit - '0');
    triangulation.tetrahedra.push_back(set);
  }
  std::sort(triangulation.tetrahedra.begin(), triangulation.tetrahedra.end());
  return triangulation;
}

bool is_valid(const Refutation& refutation, const std::vector<Clause>& premises) {
  std::vector<Clause> clauses = refutation.premises;
  for (const Clause& clause : clauses)
    if (std::find(premises.begin(), premises.end(), clause) == premises.end()) return false;
  for (const auto& polynomial : refutation.polynomials) {
    if (!solve::is_proof(polynomial)) return false;
    clauses.push_back(polynomial.clause);
  }
  return sample::is_refutation(clauses, refutation.lemmas);
}

TEST(Refute, ThreeTriangulationsOfTheHexahedronHaveNoSigns) {
  for (const std::string_view text : kNotRealizable) {
    const Triangulation triangulation = triangulation_from(text);
    const auto signs = complex::orientation_of(triangulation);
    ASSERT_TRUE(signs.has_value());
    for (const Condition condition : {Condition::embedded, Condition::convex}) {
      SignSearch search(triangulation, *signs, condition);
      EXPECT_FALSE(search.next(1).has_value());
      const auto refutation = search.refutation(2);
      ASSERT_TRUE(refutation.has_value());
      EXPECT_TRUE(is_valid(*refutation, conditions::premises(triangulation, *signs, condition)));
      EXPECT_TRUE(refutation->polynomials.empty());
      EXPECT_LT(refutation->premises.size(), 100U);
      EXPECT_EQ(search.refutation(2), refutation);
    }
  }
}

TEST(Refute, AModelObeysThePremisesAndWhatIsExcluded) {
  const Triangulation five = triangulation_from(kFive);
  const auto signs = complex::orientation_of(five);
  ASSERT_TRUE(signs.has_value());
  const auto premises = conditions::premises(five, *signs, Condition::convex);
  SignSearch search(five, *signs, Condition::convex);
  std::vector<Signs> models;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto model = search.next(seed);
    ASSERT_TRUE(model.has_value());
    EXPECT_TRUE(sample::satisfies_all(*model, premises));
    EXPECT_EQ(std::count(models.begin(), models.end(), *model), 0);
    EXPECT_EQ(search.may_refute(), seed == 0);
    models.push_back(*model);
    search.exclude(*model);
  }
  EXPECT_THROW((void)search.refutation(1), core::PreconditionViolated);
  EXPECT_FALSE(SignSearch(five, *signs, Condition::convex).refutation(1).has_value());
}

/// Signs of no eight points, though an oriented matroid.
Signs signs_of_no_points() {
  Signs signs;
  for (const char letter :
       std::string_view("+++-+++-++-++-+++-+-+-+---+-++-+--++--+-+--++-+--+-+-+-----+++---+--+-"))
    signs.push_back(letter == '+' ? 1 : -1);
  return signs;
}

TEST(Refute, PolynomialsExcludeAndRefute) {
  const Signs signs = signs_of_no_points();
  const auto polynomial = solve::find_final_polynomial(8, signs);
  ASSERT_TRUE(polynomial.has_value());
  SignSearch search({8, {}}, {}, Condition::embedded);
  search.exclude(*polynomial);
  EXPECT_TRUE(search.may_refute());
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    EXPECT_TRUE(sample::satisfies(search.next(seed).value(), polynomial->clause));
  auto broken = *polynomial;
  broken.terms.pop_back();
  EXPECT_THROW(search.exclude(broken), core::PreconditionViolated);

  // The relations leave room for the signs of the polynomial, its clause does not. That of its
  // mirror image, all signs being reversed, does not matter.
  std::vector<Clause> premises = chirotope::grassmann_pluecker_clauses(8);
  const std::vector<Clause> satisfiable = premises;
  for (const auto literal : polynomial->clause) premises.push_back({-literal});
  EXPECT_FALSE(solve::refute(premises, {}, 70, 1).has_value());
  EXPECT_FALSE(solve::refute(satisfiable, {&*polynomial, 1}, 70, 1).has_value());
  auto mirrored = *polynomial;
  for (auto& literal : mirrored.clause) literal = -literal;
  ASSERT_TRUE(solve::is_proof(mirrored));
  const std::array polynomials{mirrored, *polynomial};
  const auto refutation = solve::refute(premises, polynomials, 70, 1);
  ASSERT_TRUE(refutation.has_value());
  EXPECT_TRUE(is_valid(*refutation, premises));
  ASSERT_EQ(refutation->polynomials.size(), 1U);
  EXPECT_EQ(refutation->polynomials[0], *polynomial);
}

}  // namespace
