// Claim. There are exactly 174 classes of triangulations of the hexahedron: the certificate made
// with an untrusted solver is accepted. Certificates with a change that matters are refused.
// Oracle. The counts of the literature. The classes come from models of the rules, each of which
// must be a triangulation or have an obstruction. If an element of the input is left out, the
// formula is satisfiable, and every proof must be refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <variant>

#include "realize/solve/elaborate.hpp"
#include "realize/solve/sat.hpp"
#include "tables/check/completeness.hpp"
#include "tables/check/completeness_rules.hpp"
#include "tables/check/completeness_shapes.hpp"
#include "tables/check/malformed.hpp"

namespace hexatlas::check {
namespace {

/// The clauses that one more class or obstruction adds.
void block(solve::SatSolver& solver, const CompletenessInput& one) {
  const std::vector<Literals> clauses = completeness_clauses(one);
  for (std::size_t i = rule_clauses().size(); i < clauses.size(); ++i) solver.add(clauses[i]);
}

/// Models of the rules, with all images of each, until there is none.
CompletenessInput enumerated() {
  CompletenessInput input;
  solve::SatSolver solver(kCompletenessVariables);
  for (const Literals& clause : rule_clauses()) solver.add(clause);
  while (const auto model = solver.solve(0)) {
    std::vector<std::uint16_t> tetrahedra;
    for (std::size_t i = 0; i < kCandidates; ++i) {
      const auto variable = static_cast<std::size_t>(member_variable(i));
      if ((*model)[variable - 1]) tetrahedra.push_back(candidates().at(i));
    }
    if (fault_of_triangulation(tetrahedra).empty()) {
      input.classes.push_back(tetrahedra);
      block(solver, {{tetrahedra}, {}});
      continue;
    }
    const std::vector<Obstruction> obstructions = obstructions_in(tetrahedra);
    if (obstructions.empty()) throw std::runtime_error("a model without obstruction is no ball");
    input.obstructions.push_back(obstructions[0]);
    block(solver, {{}, {obstructions[0]}});
  }
  return input;
}

std::string proof_of(const CompletenessInput& input) {
  const std::vector<Literals> clauses = completeness_clauses(input);
  const auto answer = solve::solve_or_prove(clauses, kCompletenessVariables, {0, true});
  const auto lemmas = solve::elaborate(clauses, std::get<solve::RupProof>(answer));
  if (!lemmas) throw std::runtime_error("no proof");
  std::string text;
  std::size_t number = clauses.size();
  for (const auto& lemma : *lemmas) {
    text += std::to_string(++number);
    for (const auto literal : lemma.clause) text += " " + std::to_string(literal);
    text += " 0";
    for (const auto hint : lemma.hints) text += " " + std::to_string(hint);
    text += " 0\n";
  }
  return text;
}

bool accepts(const CompletenessInput& input, std::string_view proof) {
  try {
    return check_completeness(input, proof, "proof").complete;
  } catch (const Malformed&) {
    return false;
  }
}

class CompletenessProof : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    certified = enumerated();
    proof = proof_of(certified);
  }

  static inline CompletenessInput certified;
  static inline std::string proof;
};

TEST_F(CompletenessProof, ThereAre174Classes) {
  const CompletenessVerdict verdict = check_completeness(certified, proof, "proof");
  EXPECT_TRUE(verdict.complete) << verdict.fault;
  EXPECT_EQ(verdict.fault, "");
  EXPECT_EQ(verdict.classes, 174U);
  EXPECT_EQ(verdict.labelled, 6966U);
}

TEST_F(CompletenessProof, DoesNotDependOnTheOrderAndTheMembers) {
  CompletenessInput other = certified;
  std::reverse(other.classes.begin(), other.classes.end());
  std::reverse(other.obstructions.begin(), other.obstructions.end());
  std::size_t turn = 0;
  for (auto& tetrahedra : other.classes) {
    for (auto& each : tetrahedra) each = image_of(each, cube_symmetries()[turn % 48]);
    ++turn;
  }
  EXPECT_TRUE(accepts(other, proof));
}

TEST_F(CompletenessProof, RefusesIncompleteLists) {
  for (std::size_t i = 0; i < certified.classes.size(); i += 5) {
    CompletenessInput other = certified;
    other.classes.erase(other.classes.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(accepts(other, proof));
  }
  CompletenessInput twice = certified;
  twice.classes.back() = twice.classes.front();
  EXPECT_FALSE(accepts(twice, proof));
  CompletenessInput more = certified;
  more.classes.push_back(more.classes.front());
  EXPECT_FALSE(accepts(more, proof));
  CompletenessInput without = certified;
  without.obstructions.clear();
  EXPECT_FALSE(accepts(without, proof));
}

TEST_F(CompletenessProof, RefusesProofsThatAreCutOrMutated) {
  std::mt19937_64 random(1);
  CompletenessInput incomplete = certified;
  incomplete.classes.pop_back();
  std::size_t refused = 0;
  constexpr std::size_t kRounds = 60;
  for (std::size_t round = 0; round < kRounds; ++round) {
    std::string mutated = proof;
    for (int i = 0; i < 20; ++i) {
      mutated[random() % mutated.size()] = "0123456789 -\nd"[random() % 14];
    }
    refused += accepts(certified, mutated) ? 0U : 1U;
    EXPECT_FALSE(accepts(incomplete, mutated));
    EXPECT_FALSE(accepts(certified, std::string_view(proof).substr(0, random() % proof.size())));
  }
  // A change may be harmless, such as a literal more in a lemma; twenty of them are not.
  EXPECT_EQ(refused, kRounds);
}

/// A catalogue of the classes, as far as the completeness needs one.
std::string catalogue_of(const CompletenessInput& input, const std::string& definition,
                         const std::string& facets) {
  std::string text = "hexatlas catalogue 1\ndefinition " + definition +
                     "\nkind cell\nname hexahedron\nvertices 8\ninterior 0\n"
                     "boundary-tetrahedra no\nfacets " +
                     facets + "\nsymmetries 48\nclasses 174\nlabelled 6966\nexhaustive yes\n";
  std::size_t number = 0;
  for (const auto& tetrahedra : input.classes) {
    text += "class " + std::to_string(++number) + " 1";
    for (const std::uint16_t tetrahedron : tetrahedra) {
      text += ' ';
      for (const unsigned v : cube_vertices(tetrahedron)) text += std::to_string(v);
    }
    text += '\n';
  }
  return text + "end " + std::string(64, '0') + "\n";
}

TEST_F(CompletenessProof, ReadsTexts) {
  const std::string definition(64, 'a');
  const std::string cube = "0462 1375 0154 2673 0231 4576";
  const auto verdict_of = [](const std::string& listed, const std::string& certificate_bytes) {
    return check_completeness_bytes(listed, "completeness.hxc", certificate_bytes,
                                    "completeness.hxl");
  };
  const std::string listed = catalogue_of(certified, definition, cube);
  const std::string text = certificate_text(definition, certified.obstructions, proof);
  EXPECT_TRUE(verdict_of(listed, text).complete);
  const auto refuses = [&](const std::string& a, const std::string& b) {
    const CompletenessVerdict verdict = verdict_of(a, b);
    return !verdict.complete && !verdict.fault.empty();
  };
  EXPECT_TRUE(refuses(catalogue_of(certified, std::string(64, 'b'), cube), text));
  EXPECT_TRUE(refuses(catalogue_of(certified, definition, "0246 1375 0154 2673 0231 4576"), text));
  EXPECT_TRUE(refuses(listed, certificate_text(definition, {}, proof)));
  std::string wrong = text;
  wrong.replace(wrong.find("obstructions "), 13, "obstructions 1");
  EXPECT_THROW((void)verdict_of(listed, wrong), Malformed);
  EXPECT_THROW((void)verdict_of(listed, text.substr(0, 100)), Malformed);
}

}  // namespace
}  // namespace hexatlas::check
