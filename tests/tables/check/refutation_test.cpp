// Claim. Exactly the premises of the format are recognized; each holds for all points that realize
// a triangulation; refutations are accepted with all three kinds of lines, and final polynomials
// only where they are contradictions. Oracle. tests/sabotage/refutation_oracle.hpp lists the
// premises from their definitions, and all clauses of up to six literals are asked. Signs of random
// points that realize a class satisfy them. Refutations are found by cases. Clauses of final
// polynomials hold for random points.
#include "tables/check/refutation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/sabotage/sample_catalogues.hpp"
#include "tests/share.hpp"

namespace hexatlas::check {
namespace {

using namespace sabotage;

Tetrahedra bits_of_all(const Complex& tetrahedra) {
  Tetrahedra words;
  for (const Simplex& t : tetrahedra) {
    words.push_back(static_cast<VertexBits>(numbers_of({t}, first_numbers(16))[0]));
  }
  return words;
}

std::vector<int> signs_of(const Complex& tetrahedra, const SlowCell* cell, int vertices) {
  std::vector<int> signs;
  for (const int literal : sign_literals(tetrahedra, cell, SignVariables(vertices))) {
    signs.push_back(literal > 0 ? 1 : -1);
  }
  return signs;
}

/// Calls `use` with all clauses of `size` different variables among 1 .. `variables`, ascending by
/// variable.
template <class Use>
void for_each_clause(int variables, std::size_t size, const Use& use) {
  for (const Simplex& set : subsets(first_numbers(variables), size)) {
    for (unsigned bits = 0; bits < 1U << size; ++bits) {
      Literals clause;
      for (std::size_t i = 0; i < size; ++i) {
        clause.push_back(((bits >> i) & 1U) != 0 ? -set[i] - 1 : set[i] + 1);
      }
      use(clause);
    }
  }
}

TEST(Refutation, ExactlyThePremisesAreRecognized) {
  const std::array samples = {octahedron(), prism(), tetrahedron(2)};
  for (std::size_t s = 0; s < samples.size(); s += support::kStride) {
    const SampleCell& sample = samples[s];
    const TextCatalogue c = catalogue_of(sample);
    const TextClass& item = c.list.back();
    for (const std::string condition : {"embedded", "convex"}) {
      const auto expected = all_premises(item.tetrahedra, 6, &sample.cell, condition);
      const Tetrahedra words = bits_of_all(item.tetrahedra);
      const std::vector<int> signs = signs_of(item.tetrahedra, &sample.cell, 6);
      const SignedTriangulation triangulation{6, words, signs};
      std::size_t found = 0;
      for (std::size_t size = 1; size <= 6; ++size) {
        for_each_clause(15, size, [&](const Literals& clause) {
          if (premise_of(clause, triangulation,
                         condition == "convex" ? Condition::kConvex : Condition::kEmbedded) ==
              Premise::kNone) {
            return;
          }
          ++found;
          Clause ascending(clause.begin(), clause.end());
          std::sort(ascending.begin(), ascending.end());
          EXPECT_TRUE(expected.contains(ascending)) << testing::PrintToString(clause);
        });
      }
      EXPECT_EQ(found, expected.size()) << sample.name << condition;
    }
  }
}

TEST(Refutation, AllPremisesOfTheCubeAreRecognized) {
  const TextCatalogue c = catalogue_of_cubes();
  const SlowCell cell = c.cell();
  const std::array<Condition, 3> conditions = {Condition::kEmbedded, Condition::kConvex,
                                               Condition::kJacobian};
  const std::array<std::string, 3> names = {"embedded", "convex", "jacobian"};
  std::mt19937_64 random(1);
  for (std::size_t k = 0; k < c.list.size(); k += support::kStride) {
    const TextClass& item = c.list[k];
    const Tetrahedra words = bits_of_all(item.tetrahedra);
    const std::vector<int> signs = signs_of(item.tetrahedra, &cell, 8);
    const SignedTriangulation triangulation{8, words, signs};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto premises = all_premises(item.tetrahedra, 8, &cell, names[i]);
      for (const Clause& clause : premises) {
        Literals literals(clause.begin(), clause.end());
        EXPECT_NE(premise_of(literals, triangulation, conditions[i]), Premise::kNone);
        literals[random() % literals.size()] *= -1;
        Clause changed(literals.begin(), literals.end());
        std::sort(changed.begin(), changed.end());
        EXPECT_EQ(premise_of(literals, triangulation, conditions[i]) != Premise::kNone,
                  premises.contains(changed));
      }
    }
  }
}

/// Literals that are true of the points; none if four are in a plane.
std::set<int> true_literals(const Points& points) {
  const SignVariables variables(static_cast<int>(points.size()));
  std::set<int> literals;
  for (int v = 1; v <= variables.count(); ++v) {
    // six_volumes is the determinant of the differences from the first point.
    const Int128 volume = six_volumes(points, variables.points(v));
    if (volume == 0) return {};
    literals.insert(volume > 0 ? v : -v);
  }
  return literals;
}

bool holds(const Clause& clause, const std::set<int>& literals) {
  return std::any_of(clause.begin(), clause.end(),
                     [&](int literal) { return literals.contains(literal); });
}

TEST(Refutation, PremisesHoldForAllRealizations) {
  std::mt19937_64 random(5);
  int tested = 0;
  for (const SampleCell& sample : {octahedron(), prism(), tetrahedron(2), pyramid(1)}) {
    const TextCatalogue c = catalogue_of(sample);
    for (const TextClass& item : c.list) {
      for (const std::string condition : {"embedded", "convex"}) {
        const auto premises =
            all_premises(item.tetrahedra, static_cast<int>(c.vertices), &sample.cell, condition);
        for (int round = 0; round < 5; ++round) {
          const Points points = realization_of(c, item, condition == "convex", 2000, random);
          const std::set<int> literals = true_literals(points);
          if (points.empty() || literals.empty()) continue;
          ++tested;
          for (const Clause& clause : premises) EXPECT_TRUE(holds(clause, literals));
        }
      }
    }
  }
  EXPECT_GT(tested, 20);
}

/// An interior vertex is never a corner of the convex hull, and the octahedron about two of its
/// diagonals is not convex.
TEST(Refutation, ContradictionsFoundByCasesAreAccepted) {
  std::uint64_t refuted = 0;
  for (const SampleCell& sample : {tetrahedron(1), tetrahedron(2), pyramid(1), octahedron()}) {
    TextCatalogue c = catalogue_of(sample);
    for (TextClass& item : c.list) {
      EXPECT_TRUE(refutation_of(c, item, "embedded").empty());
      const auto lines = refutation_of(c, item, "convex");
      if (lines.empty()) continue;
      item.properties = {{"convex", "refuted", {}, lines}};
      ++refuted;
    }
    const CatalogueVerdict verdict = check_catalogue_bytes(sealed(body_of(c)), "test");
    EXPECT_TRUE(verdict.accepted) << verdict.reason;
    if (sample.interior > 0) {
      EXPECT_EQ(verdict.conditions[1].refuted, c.list.size());
    }
  }
  EXPECT_GE(refuted, 7U);
}

TEST(Refutation, TheShortestOne) {
  // With one interior vertex 4, the signs of the five points are known but that of 0123.
  const std::string body = body_of(catalogue_of(tetrahedron(1)));
  const std::string head = body + "convex refuted\n";
  const auto lines = lines_of(body);
  ASSERT_EQ(lines.back(), "class 1 24 0124 0134 0234 1234");
  const auto judged = [](const std::string& text) {
    return check_catalogue_bytes(sealed(text), "test");
  };
  // Facet 021 is counter-clockwise from outside, so 0124 is positive, 0134 negative, and so on.
  const std::string signs = "c 2 0\nc -3 0\nc 4 0\nc -5 0\n";
  EXPECT_TRUE(judged(head + signs + "c 1 -2 3 -4 5 0\nc -1 -2 3 -4 5 0\nl 0 1 2 3 4 5 6 0\nqed\n")
                  .accepted);
  EXPECT_EQ(judged(head + signs + "l 0 1 2 3 4 0\nqed\n").broken, CatalogueLaw::kLemma);
  EXPECT_EQ(judged(head + "c -2 0\nqed\n").broken, CatalogueLaw::kPremise);
  EXPECT_EQ(judged(head + signs + "qed\n").broken, CatalogueLaw::kContradiction);
  EXPECT_EQ(judged(body + "embedded refuted\n" + signs +
                   "c 1 -2 3 -4 5 0\nc -1 -2 3 -4 5 0\nl 0 1 2 3 4 5 6 0\nqed\n")
                .broken,
            CatalogueLaw::kPremise);
}

/// Three relations of six points that contradict one another. The clause is a consequence of the
/// others.
TEST(Refutation, FinalPolynomials) {
  const std::vector<std::string> literals = {"-1", "-2", "3",   "-4", "6",
                                             "7",  "8",  "-10", "11", "13"};
  const std::vector<std::string> terms = {"1 0 2 1 3 4 5 2 3", "1 0 4 1 2 3 5 3 1",
                                          "1 0 5 1 2 3 4 1 3"};
  // A refutation of two interior vertices in convex position, with the clause between the others.
  const TextCatalogue c = catalogue_of(tetrahedron(2));
  const auto judged = [&](const std::vector<std::string>& clause,
                          const std::vector<std::string>& sum) {
    TextCatalogue changed = c;
    std::vector<std::string> lines = refutation_of(c, c.list[0], "convex");
    const auto first_lemma = std::find_if(
        lines.begin(), lines.end(), [](const std::string& line) { return line.starts_with("l "); });
    // Its hints are premises, since it is the only lemma.
    EXPECT_TRUE(first_lemma->starts_with("l 0 "));
    std::string line = "f";
    for (const std::string& word : clause) line += " " + word;
    line += " 0";
    for (const std::string& term : sum) line += " " + term;
    lines.insert(first_lemma, line);
    changed.list[0].properties = {{"convex", "refuted", {}, lines}};
    return check_catalogue_bytes(sealed(body_of(changed)), "test");
  };
  EXPECT_TRUE(judged(literals, terms).accepted) << judged(literals, terms).reason;
  EXPECT_EQ(judged(literals, terms).polynomials, 1U);
  std::vector<std::string> more = literals;
  more.emplace_back("15");
  EXPECT_TRUE(judged(more, terms).accepted);
  more.back() = "1";
  EXPECT_EQ(judged(more, terms).broken, CatalogueLaw::kPolynomial);

  int refused = 0;
  const auto expect_refused = [&](const std::vector<std::string>& clause,
                                  const std::vector<std::string>& sum) {
    EXPECT_EQ(judged(clause, sum).broken, CatalogueLaw::kPolynomial);
    ++refused;
  };
  for (std::size_t i = 0; i < literals.size(); ++i) {
    std::vector<std::string> changed = literals;
    changed[i] = changed[i][0] == '-' ? changed[i].substr(1) : "-" + changed[i];
    expect_refused(changed, terms);
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
    expect_refused(changed, terms);
  }
  for (std::size_t i = 0; i < terms.size(); ++i) {
    std::vector<std::string> changed = terms;
    changed[i][0] = '2';
    expect_refused(literals, changed);
    changed = terms;
    std::swap(*changed[i].rbegin(), *(changed[i].rbegin() + 2));
    expect_refused(literals, changed);
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
    expect_refused(literals, changed);
  }
  EXPECT_EQ(refused, 29);

  Clause clause;
  for (const std::string& literal : literals) clause.push_back(std::stoi(literal));
  std::mt19937_64 random(23);
  int tested = 0;
  for (int round = 0; round < 20'000; ++round) {
    const std::set<int> signs = true_literals(random_points(6, 50, random));
    if (signs.empty()) continue;
    ++tested;
    EXPECT_TRUE(holds(clause, signs));
  }
  EXPECT_GT(tested, 10'000);
}

}  // namespace
}  // namespace hexatlas::check
