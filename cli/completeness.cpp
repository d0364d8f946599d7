#include "cli/completeness.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "enum/core/checks.hpp"
#include "realize/solve/elaborate.hpp"
#include "realize/solve/sat.hpp"
#include "tables/check/completeness.hpp"

namespace hexatlas::cli {
namespace {

/// The candidate tetrahedra by variable: the sets of four vertices of the cube that lie on no
/// facet, ascending, from variable 7.
std::vector<std::uint16_t> chosen_tetrahedra(const solve::Assignment& assignment) {
  const complex::Cell cube = *complex::cell_named("hexahedron");
  std::vector<std::uint16_t> chosen;
  std::size_t variable = 6;
  for (unsigned set = 0; set < 256; ++set) {
    if (std::popcount(set) != 4) continue;
    bool on_facet = false;
    for (const auto& facet : cube.facets) on_facet = on_facet || facet.vertices() == set;
    if (on_facet) continue;
    if (assignment[variable]) chosen.push_back(static_cast<std::uint16_t>(set));
    ++variable;
  }
  return chosen;
}

std::string lrat_text(std::size_t premises, const std::vector<certificate::Lemma>& lemmas) {
  std::string text;
  std::size_t number = premises;
  for (const certificate::Lemma& lemma : lemmas) {
    text += std::to_string(++number);
    for (const auto literal : lemma.clause) text += " " + std::to_string(literal);
    text += " 0";
    for (const auto hint : lemma.hints) text += " " + std::to_string(hint);
    text += " 0\n";
  }
  return text;
}

}  // namespace

std::optional<std::string> completeness_certificate(const format::Catalogue& catalogue,
                                                    const StepReport& report) {
  check::CompletenessInput input;
  for (const auto& entry : catalogue.classes)
    input.classes.emplace_back(entry.triangulation.tetrahedra.begin(),
                               entry.triangulation.tetrahedra.end());
  for (;;) {
    const std::vector<check::Literals> clauses = check::completeness_clauses(input);
    report(fmt::format("refuting that there is another: {} clauses, {} obstructions",
                       clauses.size(), input.obstructions.size()));
    const auto answer =
        solve::solve_or_prove(clauses, check::kCompletenessVariables, {.inprocessing = true});
    if (const auto* assignment = std::get_if<solve::Assignment>(&answer)) {
      auto found = check::obstructions_in(chosen_tetrahedra(*assignment));
      if (found.empty()) return std::nullopt;
      input.obstructions.insert(input.obstructions.end(), found.begin(), found.end());
      continue;
    }
    report("elaborating the proof");
    const auto lemmas = solve::elaborate(clauses, std::get<solve::RupProof>(answer));
    core::ensures(lemmas.has_value(), "the proof of the solver ends in the empty clause");
    return check::certificate_text(std::string(format::definition_digest()), input.obstructions,
                                   lrat_text(clauses.size(), *lemmas));
  }
}

}  // namespace hexatlas::cli
