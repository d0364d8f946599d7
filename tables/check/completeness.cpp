#include "tables/check/completeness.hpp"

#include <algorithm>
#include <bit>
#include <set>
#include <span>
#include <utility>

#include "tables/check/completeness_rules.hpp"
#include "tables/check/completeness_shapes.hpp"

namespace hexatlas::check {

namespace {

static_assert(kCompletenessVariables == kRuleVariables);

/// Bit i set if candidate i is a member.
using Members = std::uint64_t;

/// The members of all images of the tetrahedra under the symmetries of the cube, each once.
std::set<Members> orbit_of(std::span<const CubeSet> tetrahedra) {
  std::set<Members> orbit;
  for (const CubeSymmetry& symmetry : cube_symmetries()) {
    Members members = 0;
    for (const CubeSet tetrahedron : tetrahedra) {
      members |= Members{1} << candidate_index(image_of(tetrahedron, symmetry)).value();
    }
    orbit.insert(members);
  }
  return orbit;
}

void add_blocking(const std::set<Members>& sets, std::vector<Literals>& clauses) {
  for (const Members members : sets) {
    Literals& clause = clauses.emplace_back();
    for (std::size_t i = 0; i < kCandidates; ++i) {
      if ((members >> i & 1U) != 0) clause.push_back(-member_variable(i));
    }
  }
}

/// The parts of a star, tetrahedra at a vertex, that are connected through triangles at it.
std::vector<std::vector<CubeSet>> parts_of_star(std::vector<CubeSet> star) {
  std::vector<std::vector<CubeSet>> parts;
  while (!star.empty()) {
    std::vector<CubeSet> part = {star.back()};
    star.pop_back();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const auto is_apart = [at = part[i]](CubeSet t) {
        return std::popcount(static_cast<CubeSet>(t & at)) < 3;
      };
      const auto rest = std::partition(star.begin(), star.end(), is_apart);
      part.insert(part.end(), rest, star.end());
      star.erase(rest, star.end());
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

std::vector<Literals> completeness_clauses(const CompletenessInput& input) {
  std::vector<Literals> clauses = rule_clauses();
  std::set<Members> labelled;
  for (const auto& tetrahedra : input.classes) labelled.merge(orbit_of(tetrahedra));
  add_blocking(labelled, clauses);
  std::set<Members> obstructions;
  for (const Obstruction& each : input.obstructions) obstructions.merge(orbit_of(each.tetrahedra));
  add_blocking(obstructions, clauses);
  return clauses;
}

std::string dimacs_of(const std::vector<Literals>& clauses) {
  std::string text = "p cnf " + std::to_string(kCompletenessVariables) + " " +
                     std::to_string(clauses.size()) + "\n";
  for (const Literals& clause : clauses) {
    for (const std::int32_t literal : clause) text += std::to_string(literal) + " ";
    text += "0\n";
  }
  return text;
}

std::vector<Obstruction> obstructions_in(const std::vector<std::uint16_t>& tetrahedra) {
  std::vector<Obstruction> found;
  for (unsigned v = 0; v < kCubeVertices; ++v) {
    std::vector<CubeSet> star = tetrahedra;
    std::erase_if(star, [v](CubeSet t) { return (t >> v & 1U) == 0; });
    for (std::vector<CubeSet>& part : parts_of_star(std::move(star))) {
      std::sort(part.begin(), part.end());
      if (fault_of_obstruction(v, part).empty()) found.push_back({v, std::move(part)});
    }
  }
  return found;
}

CompletenessVerdict check_completeness(const CompletenessInput& input, std::string_view proof,
                                       const std::string& file, std::size_t first_line) {
  CompletenessVerdict verdict;
  verdict.classes = input.classes.size();
  std::set<Members> labelled;
  for (std::size_t i = 0; i < input.classes.size(); ++i) {
    verdict.fault = fault_of_triangulation(input.classes[i]);
    if (verdict.fault.empty()) {
      std::set<Members> orbit = orbit_of(input.classes[i]);
      labelled.merge(orbit);
      if (!orbit.empty()) verdict.fault = "it is equivalent to one before it";
    }
    if (!verdict.fault.empty()) {
      verdict.fault = "class " + std::to_string(i + 1) + ": " + verdict.fault;
      return verdict;
    }
  }
  verdict.labelled = labelled.size();
  for (std::size_t i = 0; i < input.obstructions.size(); ++i) {
    const Obstruction& each = input.obstructions[i];
    verdict.fault = fault_of_obstruction(each.vertex, each.tetrahedra);
    if (verdict.fault.empty()) continue;
    verdict.fault = "obstruction " + std::to_string(i + 1) + ": " + verdict.fault;
    return verdict;
  }
  LratChecker checker(kCompletenessVariables);
  for (const Literals& clause : completeness_clauses(input)) {
    if (!checker.add_premise(clause)) verdict.fault = "a clause of the formula has no variable";
  }
  if (verdict.fault.empty()) verdict.fault = fault_of_lrat(checker, proof, file, first_line);
  verdict.complete = verdict.fault.empty();
  return verdict;
}

}  // namespace hexatlas::check
