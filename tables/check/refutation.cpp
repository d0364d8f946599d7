#include "tables/check/refutation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include "tables/check/circuits.hpp"
#include "tables/check/edge_lemma.hpp"
#include "tables/check/text_lines.hpp"
#include "tables/check/wide.hpp"

namespace hexatlas::check {

namespace {

/// Weights are below this, so that sums of as many as a file can hold stay within 128 bits.
constexpr std::uint64_t kWeightBound = std::uint64_t{1} << 40;

class RefutationJudge {
 public:
  RefutationJudge(const RefutationText& text, const std::string& file,
                  const SignedTriangulation& triangulation, Condition condition,
                  RefutationCounts& counts)
      : lines_(file, text.lines, text.first),
        triangulation_(triangulation),
        condition_(condition),
        counts_(counts),
        variables_(sign_variables(triangulation.vertices)),
        checker_(variables_) {}

  CatalogueFinding judge() {
    CatalogueFinding found;
    while (!found && lines_.peek() == "c") found = judge_premise();
    while (!found && lines_.peek() == "f") found = judge_polynomial();
    while (!found && lines_.peek() == "l") found = judge_lemma();
    if (found) return found;
    if (!lines_.at_end()) lines_.next().fail("expected lines 'c', then 'f', then 'l', then 'qed'");
    if (checker_.has_empty_clause()) return std::nullopt;
    return BrokenLaw{CatalogueLaw::kContradiction, "the refutation ends without the empty clause"};
  }

 private:
  [[nodiscard]] static Literals read_clause(LineWords& line) {
    Literals clause;
    while (true) {
      const std::int64_t literal = line.integer();
      if (literal == 0) return clause;
      constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
      if (literal < -kMost || literal > kMost) line.fail("a literal is out of range");
      clause.push_back(static_cast<std::int32_t>(literal));
    }
  }

  [[nodiscard]] static BrokenLaw broken(CatalogueLaw law, const LineWords& line,
                                        const std::string& what) {
    return {law, "line " + std::to_string(line.number()) + ": " + what};
  }

  CatalogueFinding judge_premise() {
    LineWords line = lines_.next();
    line.expect("c");
    const Literals clause = read_clause(line);
    line.expect_end();
    if (premise_of(clause, triangulation_, condition_) == Premise::kNone ||
        !checker_.add_premise(clause)) {
      return broken(CatalogueLaw::kPremise, line, "the clause is no premise");
    }
    ++counts_.premises;
    return std::nullopt;
  }

  CatalogueFinding judge_polynomial() {
    LineWords line = lines_.next();
    line.expect("f");
    const Literals clause = read_clause(line);
    const auto denied = denied_signs(clause, triangulation_.vertices);
    if (!denied) {
      return broken(CatalogueLaw::kPolynomial, line, "a variable is unknown or occurs twice");
    }
    std::vector<Wide> sums(variables_, 0);
    if (line.at_end()) line.fail("a final polynomial without a term");
    bool of_edges = false;
    while (!line.at_end()) {
      const std::string_view first = line.word();
      if (first == "e" && !of_edges && condition_ == Condition::kJacobian) {
        of_edges = true;
        if (line.at_end()) line.fail("`e` without a term");
        continue;
      }
      const std::uint64_t weight = weight_from(line, first);
      if (!(of_edges ? add_edge_term(line, weight, *denied, sums)
                     : add_term(line, weight, *denied, sums))) {
        return broken(CatalogueLaw::kPolynomial, line, "a term does not follow from the signs");
      }
    }
    if (std::any_of(sums.begin(), sums.end(), [](Wide sum) { return sum != 0; })) {
      return broken(CatalogueLaw::kPolynomial, line, "the terms do not cancel");
    }
    if (!checker_.add_premise(clause)) {
      return broken(CatalogueLaw::kPolynomial, line, "the clause has an unknown variable");
    }
    ++counts_.polynomials;
    return std::nullopt;
  }

  /// Adds w (log |Tp| - log |Tq|); false if the signs do not tell that |Tp| > |Tq|.
  bool add_term(LineWords& line, std::uint64_t weight, const std::vector<DeniedSign>& denied,
                std::vector<Wide>& sums) const {
    const VertexBits common = read_points(line, 2);
    const VertexBits others = read_points(line, 4);
    if ((common & others) != 0) line.fail("a term has a point twice");
    const std::size_t larger = read_product(line);
    const std::size_t smaller = read_product(line);
    if (larger == smaller) line.fail("a term has the same product twice");
    const auto signs = product_signs(common, others, denied);
    if (!signs) return false;
    // T1 + T2 + T3 = 0: the one of the other sign outweighs the two others together.
    const std::size_t third = 3 - larger - smaller;
    if ((*signs)[larger] == (*signs)[smaller] || (*signs)[larger] == (*signs)[third]) return false;
    const auto brackets = product_brackets(common, others);
    for (std::size_t i = 0; i < 2; ++i) {
      sums[place_of(brackets[larger][i])] += static_cast<Wide>(weight);
      sums[place_of(brackets[smaller][i])] -= static_cast<Wide>(weight);
    }
    return true;
  }

  /// The same for an inequality of the edge lemma.
  static bool add_edge_term(LineWords& line, std::uint64_t weight,
                            const std::vector<DeniedSign>& denied, std::vector<Wide>& sums) {
    const std::uint64_t tail = line.natural();
    const std::uint64_t axis = line.natural();
    const std::uint64_t apex = line.natural();
    const std::uint64_t side = line.natural();
    const std::uint64_t larger = line.natural();
    if (larger != 1 && larger != 2) line.fail("the larger product is neither 1 nor 2");
    const auto edge = edge_case(tail, axis, apex, side);
    if (!edge) line.fail("the numbers name no edge, apex and side");
    if (!implies_larger(*edge, denied, larger)) return false;
    const Wide plus = larger == 1 ? static_cast<Wide>(weight) : -static_cast<Wide>(weight);
    for (const SignedBracket& bracket : {edge->y0, edge->x1})
      sums[place_of(bracket.four())] += plus;
    for (const SignedBracket& bracket : {edge->y1, edge->x0})
      sums[place_of(bracket.four())] -= plus;
    return true;
  }

  [[nodiscard]] static std::uint64_t weight_from(const LineWords& line, std::string_view word) {
    std::uint64_t weight = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), weight);
    if (error != std::errc{} || end != word.data() + word.size() || word.front() == '0' ||
        weight >= kWeightBound) {
      line.fail("the weight of a term is out of range");
    }
    return weight;
  }

  /// `count` vertices, ascending.
  [[nodiscard]] VertexBits read_points(LineWords& line, int count) const {
    unsigned bits = 0;
    for (int i = 0; i < count; ++i) {
      const std::uint64_t vertex = line.natural();
      if (vertex >= static_cast<std::uint64_t>(triangulation_.vertices)) {
        line.fail("a point of a term is no vertex");
      }
      const unsigned bit = 1U << vertex;
      if (bit <= bits) line.fail("the points of a term do not ascend");
      bits |= bit;
    }
    return static_cast<VertexBits>(bits);
  }

  [[nodiscard]] static std::size_t read_product(LineWords& line) {
    const std::uint64_t product = line.natural();
    if (product < 1 || product > 3) line.fail("a product of a term is not among 1, 2, 3");
    return static_cast<std::size_t>(product - 1);
  }

  CatalogueFinding judge_lemma() {
    LineWords line = lines_.next();
    line.expect("l");
    const Literals clause = read_clause(line);
    std::vector<std::uint32_t> hints;
    for (std::uint64_t hint = line.natural(); hint != 0; hint = line.natural()) {
      if (hint > std::numeric_limits<std::uint32_t>::max()) line.fail("a hint is out of range");
      hints.push_back(static_cast<std::uint32_t>(hint));
    }
    line.expect_end();
    if (checker_.has_empty_clause()) {
      return broken(CatalogueLaw::kContradiction, line, "a lemma after the empty clause");
    }
    if (!checker_.add_lemma(clause, hints)) {
      return broken(CatalogueLaw::kLemma, line, "the lemma does not follow by its hints");
    }
    ++counts_.lemmas;
    return std::nullopt;
  }

  TextLines lines_;
  const SignedTriangulation& triangulation_;
  Condition condition_;
  RefutationCounts& counts_;
  std::size_t variables_;
  LratChecker checker_;
};

}  // namespace

CatalogueFinding check_refutation(const RefutationText& text, const std::string& file,
                                  const SignedTriangulation& triangulation, Condition condition,
                                  RefutationCounts& counts) {
  return RefutationJudge(text, file, triangulation, condition, counts).judge();
}

}  // namespace hexatlas::check
