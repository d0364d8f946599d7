// Claim. The clauses of completeness.md hold in every triangulation of the hexahedron, but for the
// one blocking clause of its own; complexes that are no balls break one; what is no list of
// triangulations, once each, or no obstruction, is refused.
// Oracle. A search without formula, symmetries and shellings, for one choice of diagonals of
// each of the seven kinds; discs by their Euler characteristic; counts of the literature.
#include "tables/check/completeness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "tables/check/completeness_rules.hpp"
#include "tables/check/completeness_shapes.hpp"
#include "tests/tables/check/hexahedron_search.hpp"

namespace hexatlas::check {
namespace {

using examples::ClosedComplex;
using Tetrahedra = std::vector<std::uint16_t>;

/// Truth of variable 1 + place.
using Assignment = std::vector<bool>;

Assignment assignment_of(unsigned choice, const ClosedComplex& complex) {
  Assignment truth(kCompletenessVariables, false);
  const auto diagonals = examples::diagonals_of(choice);
  for (unsigned f = 0; f < 6; ++f) {
    const auto least =
        *std::min_element(examples::kCubeCycles[f].begin(), examples::kCubeCycles[f].end());
    truth[f] = (diagonals[f] >> least & 1U) != 0;
  }
  for (std::size_t i = 0; i < complex.tetrahedra.size(); ++i) {
    const std::size_t candidate = candidate_index(complex.tetrahedra[i]).value();
    truth[6 + candidate] = true;
    truth[(complex.signs[i] > 0 ? 70U : 134U) + candidate] = true;
  }
  return truth;
}

bool is_true(const Literals& clause, const Assignment& truth) {
  return std::any_of(clause.begin(), clause.end(), [&truth](std::int32_t literal) {
    return truth[static_cast<std::size_t>(std::abs(literal)) - 1] == (literal > 0);
  });
}

std::vector<std::size_t> broken_by(const Assignment& truth, const std::vector<Literals>& clauses) {
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < clauses.size(); ++i) {
    if (!is_true(clauses[i], truth)) broken.push_back(i);
  }
  return broken;
}

Tetrahedra image(const Tetrahedra& tetrahedra, const CubeSymmetry& symmetry) {
  Tetrahedra result;
  for (const std::uint16_t t : tetrahedra) result.push_back(image_of(t, symmetry));
  std::sort(result.begin(), result.end());
  return result;
}

/// The least image under the symmetries of the cube.
Tetrahedra least_image(const Tetrahedra& tetrahedra) {
  Tetrahedra least = image(tetrahedra, cube_symmetries()[0]);
  for (const CubeSymmetry& symmetry : cube_symmetries()) {
    least = std::min(least, image(tetrahedra, symmetry));
  }
  return least;
}

/// What the search finds for one choice of diagonals.
struct Found {
  unsigned choice = 0;
  std::size_t choices = 0;  ///< of the same kind
  std::vector<ClosedComplex> balls, others;
};

const std::vector<Found>& all_found() {
  static const std::vector<Found> all = [] {
    std::map<Tetrahedra, Found> kinds;
    for (unsigned choice = 0; choice < 64; ++choice) {
      const auto diagonals = examples::diagonals_of(choice);
      Found& kind = kinds[least_image(Tetrahedra(diagonals.begin(), diagonals.end()))];
      kind.choice = choice;
      ++kind.choices;
    }
    std::vector<Found> result;
    for (auto& [diagonals, kind] : kinds) {
      for (ClosedComplex& complex : examples::HexahedronSearch(kind.choice).run()) {
        const bool is_ball = examples::links_are_discs(complex.tetrahedra);
        (is_ball ? kind.balls : kind.others).push_back(std::move(complex));
      }
      result.push_back(std::move(kind));
    }
    return result;
  }();
  return all;
}

const std::vector<Tetrahedra>& all_classes() {
  static const std::vector<Tetrahedra> all = [] {
    std::set<Tetrahedra> least;
    for (const Found& found : all_found()) {
      for (const ClosedComplex& ball : found.balls) least.insert(least_image(ball.tetrahedra));
    }
    return std::vector<Tetrahedra>(least.begin(), least.end());
  }();
  return all;
}

const std::vector<Obstruction>& some_obstructions() {
  static const std::vector<Obstruction> all = [] {
    std::vector<Obstruction> result;
    for (const Found& found : all_found()) {
      for (const ClosedComplex& other : found.others) {
        const auto obstructions = obstructions_in(other.tetrahedra);
        result.insert(result.end(), obstructions.begin(), obstructions.end());
      }
    }
    return result;
  }();
  return all;
}

std::string fault_of(const std::vector<Tetrahedra>& classes,
                     const std::vector<Obstruction>& obstructions) {
  const CompletenessVerdict verdict = check_completeness({classes, obstructions}, "", "proof");
  EXPECT_FALSE(verdict.complete);
  return verdict.fault;
}

constexpr const char* kNoProof = "there is no empty clause";

TEST(Completeness, TheSearchAgreesWithTheLiterature) {
  std::size_t labelled = 0;
  std::size_t choices = 0;
  for (const Found& found : all_found()) {
    labelled += found.choices * found.balls.size();
    choices += found.choices;
  }
  EXPECT_EQ(choices, 64U);
  EXPECT_EQ(all_found().size(), 7U);
  std::map<std::size_t, int> sizes;
  for (const Tetrahedra& tetrahedra : all_classes()) ++sizes[tetrahedra.size()];
  const std::map<std::size_t, int> known = {{5, 1},   {6, 5},   {7, 5},   {8, 7},
                                            {9, 13},  {10, 20}, {11, 35}, {12, 30},
                                            {13, 28}, {14, 19}, {15, 11}};
  EXPECT_EQ(sizes, known);
  const CompletenessVerdict verdict = check_completeness({all_classes(), {}}, "", "proof");
  EXPECT_EQ(verdict.fault, kNoProof);
  EXPECT_EQ(verdict.classes, 174U);
  EXPECT_EQ(verdict.labelled, labelled);
}

TEST(Completeness, TriangulationsBreakTheirOwnBlockingClauseOnly) {
  const std::vector<Literals> clauses = completeness_clauses({all_classes(), some_obstructions()});
  for (const Found& found : all_found()) {
    for (const ClosedComplex& ball : found.balls) {
      ASSERT_EQ(fault_of_triangulation(ball.tetrahedra), "");
      ASSERT_TRUE(obstructions_in(ball.tetrahedra).empty());
      const auto broken = broken_by(assignment_of(found.choice, ball), clauses);
      ASSERT_EQ(broken.size(), 1U);
      Literals own;
      for (const std::uint16_t t : ball.tetrahedra) {
        own.push_back(-member_variable(candidate_index(t).value()));
      }
      std::sort(own.rbegin(), own.rend());
      EXPECT_EQ(clauses[broken[0]], own);
    }
  }
}

TEST(Completeness, OtherComplexesBreakARuleOrHaveAnObstruction) {
  const std::vector<Literals> rules = rule_clauses();
  const std::vector<Literals> clauses = completeness_clauses({{}, some_obstructions()});
  std::size_t by_rule = 0;
  std::size_t by_obstruction = 0;
  for (const Found& found : all_found()) {
    for (const ClosedComplex& other : found.others) {
      const Assignment truth = assignment_of(found.choice, other);
      const bool breaks_rule = !broken_by(truth, rules).empty();
      ASSERT_TRUE(breaks_rule || !obstructions_in(other.tetrahedra).empty());
      ASSERT_FALSE(broken_by(truth, clauses).empty());
      ++(breaks_rule ? by_rule : by_obstruction);
    }
  }
  EXPECT_GT(by_rule, 0U);
  EXPECT_GT(by_obstruction, 0U);
}

TEST(Completeness, EachMutatedTriangulationBreaksAClause) {
  const std::vector<Literals> clauses = completeness_clauses({all_classes(), some_obstructions()});
  std::mt19937_64 random(1);
  const std::vector<Found>& all = all_found();
  for (int round = 0; round < 2000; ++round) {
    const Found& found = all[random() % all.size()];
    Assignment truth = assignment_of(found.choice, found.balls[random() % found.balls.size()]);
    for (std::uint64_t flips = 1 + random() % 4; flips > 0; --flips) {
      const std::size_t variable = random() % truth.size();
      truth[variable] = !truth[variable];
    }
    ASSERT_FALSE(broken_by(truth, clauses).empty());
  }
}

/// The sign of the determinant of a symmetry.
int handedness(const CubeSymmetry& symmetry) {
  std::array<unsigned, 3> axes{};
  for (unsigned k = 0; k < 3; ++k) {
    axes[k] = static_cast<unsigned>(
        std::countr_zero(static_cast<unsigned>(symmetry[1U << k] ^ symmetry[0])));
  }
  const int flips = std::popcount(static_cast<unsigned>(symmetry[0]));
  return (examples::parity_of(axes) + static_cast<unsigned>(flips)) % 2 == 0 ? 1 : -1;
}

/// What a literal says, of the image.
std::int32_t image(std::int32_t literal, const CubeSymmetry& symmetry) {
  const auto place = static_cast<unsigned>(std::abs(literal)) - 1;
  const std::int32_t sign = literal > 0 ? 1 : -1;
  if (place < 6) {
    const CubeSet facet = cube_facet(place);
    const std::vector<unsigned> corners = cube_vertices(facet);
    const CubeSet image_facet = image_of(facet, symmetry);
    const unsigned least = cube_vertices(image_facet)[0];
    const bool at_least = symmetry[corners[0]] == least || symmetry[corners[3]] == least;
    const auto variable = static_cast<std::int32_t>(facets_with(image_facet).at(0)) + 1;
    return at_least ? sign * variable : -sign * variable;
  }
  const CubeSet tetrahedron = candidates().at((place - 6) % 64);
  const std::size_t candidate = candidate_index(image_of(tetrahedron, symmetry)).value();
  if (place < 70) return sign * member_variable(candidate);
  std::array<unsigned, 4> images{};
  for (unsigned i = 0; i < 4; ++i) images[i] = symmetry[cube_vertices(tetrahedron)[i]];
  const bool keeps = (examples::parity_of(images) == 0) == (handedness(symmetry) > 0);
  const bool positive = (place < 134) == keeps;
  return sign * static_cast<std::int32_t>((positive ? 71U : 135U) + candidate);
}

TEST(Completeness, RulesAreClosedUnderTheSymmetriesOfTheCube) {
  const auto sorted = [](Literals clause) {
    std::sort(clause.begin(), clause.end());
    return clause;
  };
  const std::vector<Literals> rules = rule_clauses();
  std::set<Literals> all;
  for (const Literals& clause : rules) all.insert(sorted(clause));
  EXPECT_EQ(all.size(), rules.size());
  EXPECT_EQ(cube_symmetries().size(), 48U);
  for (const CubeSymmetry& symmetry : cube_symmetries()) {
    for (const Literals& clause : rules) {
      Literals images;
      for (const std::int32_t literal : clause) images.push_back(image(literal, symmetry));
      ASSERT_EQ(all.count(sorted(images)), 1U);
    }
  }
}

TEST(Completeness, RefusesWrongClasses) {
  std::vector<Tetrahedra> classes = all_classes();
  EXPECT_EQ(fault_of(classes, {}), kNoProof);
  const auto with_class = [&classes](const Tetrahedra& tetrahedra) {
    std::vector<Tetrahedra> changed = classes;
    changed[5] = tetrahedra;
    return fault_of(changed, {});
  };
  Tetrahedra ball = classes[5];
  EXPECT_EQ(with_class(all_found().at(0).others.at(0).tetrahedra),
            "class 6: no proof found that it is a ball");
  EXPECT_EQ(with_class(classes[2]), "class 6: it is equivalent to one before it");
  EXPECT_EQ(with_class(image(classes[2], cube_symmetries()[31])),
            "class 6: it is equivalent to one before it");
  EXPECT_EQ(with_class(image(ball, cube_symmetries()[31])), kNoProof);
  EXPECT_EQ(with_class({}), "class 6: a facet is not cut in two by a diagonal");
  for (const Found& found : all_found()) {
    for (const ClosedComplex& other : found.others) {
      ASSERT_NE(fault_of_triangulation(other.tetrahedra), "");
    }
  }
  for (std::size_t i = 0; i < ball.size(); ++i) {
    for (unsigned set = 0; set < 512; ++set) {
      Tetrahedra changed = ball;
      changed[i] = static_cast<std::uint16_t>(set);
      ASSERT_EQ(fault_of_triangulation(changed).empty(), set == ball[i]);
    }
  }
  ball.push_back(ball[0]);
  EXPECT_EQ(with_class(ball), "class 6: a tetrahedron is given twice");
  EXPECT_EQ(with_class(Tetrahedra(16, ball[0])),
            "class 6: more tetrahedra than a triangulation can have");
}

TEST(Completeness, RefusesStarsThatMayBePartOfATriangulation) {
  // Stars of vertices of balls, and parts of them.
  for (const Found& found : all_found()) {
    for (const ClosedComplex& ball : found.balls) {
      for (unsigned v = 0; v < 8; ++v) {
        Tetrahedra star = ball.tetrahedra;
        std::erase_if(star, [v](unsigned t) { return (t >> v & 1U) == 0; });
        while (!star.empty()) {
          ASSERT_NE(fault_of_obstruction(v, star), "");
          star.pop_back();
        }
      }
    }
  }
}

TEST(Completeness, RefusesWrongObstructions) {
  const Obstruction good = some_obstructions().at(0);
  EXPECT_EQ(fault_of({}, {good}), kNoProof);
  const auto refuses = [&good](const auto& change) {
    Obstruction changed = good;
    change(changed);
    return fault_of({}, {good, changed}).starts_with("obstruction 2: ");
  };
  EXPECT_TRUE(refuses([](Obstruction& o) { o.vertex = 8; }));
  EXPECT_TRUE(refuses([](Obstruction& o) { o.vertex = (o.vertex + 1) % 8; }));
  EXPECT_TRUE(refuses([](Obstruction& o) { o.tetrahedra.clear(); }));
  EXPECT_TRUE(refuses([](Obstruction& o) { o.tetrahedra.push_back(o.tetrahedra[0]); }));
  EXPECT_TRUE(refuses([](Obstruction& o) { o.tetrahedra[0] = 0x55; }));
  EXPECT_TRUE(refuses([](Obstruction& o) { o.tetrahedra[0] = 0xffff; }));
  EXPECT_TRUE(refuses([](Obstruction& o) { o.tetrahedra.resize(2); }));
}

TEST(Completeness, WritesDimacs) {
  const std::string text = dimacs_of({{1, -7}, {}, {198}});
  EXPECT_EQ(text, "p cnf 198 3\n1 -7 0\n0\n198 0\n");
}

}  // namespace
}  // namespace hexatlas::check
