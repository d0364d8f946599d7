#include "tables/check/chirotope_clauses.hpp"

#include <algorithm>
#include <bit>

#include "tables/check/circuits.hpp"
#include "tables/check/edge_lemma.hpp"
#include "tables/check/triangulation_laws.hpp"

namespace hexatlas::check {

namespace {

/// Members of a set of at most four, ascending.
std::array<std::uint8_t, 4> members_of(VertexBits set) {
  std::array<std::uint8_t, 4> members{};
  std::size_t count = 0;
  for (unsigned rest = set; rest != 0; rest &= rest - 1) {
    members[count++] = static_cast<std::uint8_t>(std::countr_zero(rest));
  }
  return members;
}

/// All sets of four, by place.
const std::vector<VertexBits>& fours() {
  static const std::vector<VertexBits> sets = [] {
    std::vector<VertexBits> result(binomial(kMostCatalogueVertices, 4));
    for_each_subset(0xFFFF, 4, [&](VertexBits four) { result[place_of(four)] = four; });
    return result;
  }();
  return sets;
}

/// 0 if it is not among them.
int sign_among(VertexBits four, const std::vector<DeniedSign>& signs) {
  const auto found = std::find_if(signs.begin(), signs.end(),
                                  [four](const DeniedSign& denied) { return denied.four == four; });
  return found == signs.end() ? 0 : found->sign;
}

bool contradicts_tetrahedron(const DeniedSign& denied, const SignedTriangulation& triangulation) {
  const Tetrahedra& tetrahedra = triangulation.tetrahedra;
  const auto found = std::find(tetrahedra.begin(), tetrahedra.end(), denied.four);
  return found != tetrahedra.end() &&
         triangulation.signs[static_cast<std::size_t>(found - tetrahedra.begin())] == -denied.sign;
}

/// The determinant of the edges at a corner v of the cube, towards v^1, v^2, v^4, is positive if v
/// has an even number of bits, else negative.
bool contradicts_corner(const DeniedSign& denied) {
  for (std::uint8_t v = 0; v < 8; ++v) {
    const std::array<std::uint8_t, 4> corner = {v, static_cast<std::uint8_t>(v ^ 1U),
                                                static_cast<std::uint8_t>(v ^ 2U),
                                                static_cast<std::uint8_t>(v ^ 4U)};
    unsigned bits = 0;
    for (const std::uint8_t w : corner) bits |= 1U << w;
    if (bits != denied.four) continue;
    const int wanted = (std::popcount(unsigned{v}) % 2 == 0 ? 1 : -1) * parity_of(corner);
    return denied.sign == -wanted;
  }
  return false;
}

/// Whether the six signs are those of one relation, and its products have equal signs.
bool contradicts_relation(const std::vector<DeniedSign>& denied) {
  unsigned all = 0;
  unsigned common = 0xFFFF;
  for (const DeniedSign& one : denied) {
    all |= one.four;
    common &= one.four;
  }
  if (std::popcount(all) != 6 || std::popcount(common) != 2) return false;
  const auto signs = product_signs(static_cast<VertexBits>(common),
                                   static_cast<VertexBits>(all & ~common), denied);
  return signs && (*signs)[0] == (*signs)[1] && (*signs)[1] == (*signs)[2];
}

/// Of five points, some have denied signs in the circuit.
Premise contradicted_by_circuit(const std::vector<DeniedSign>& denied, VertexBits five,
                                const SignedTriangulation& triangulation, Condition condition) {
  const Circuit c =
      circuit_of(five, [&denied](VertexBits four) { return sign_among(four, denied); });
  if ((c.positive | c.negative) == five) {
    const int positive = std::popcount(c.positive);
    if (positive == 0 || positive == 5) return Premise::kAcyclic;
    if (condition == Condition::kConvex && (positive == 1 || positive == 4)) {
      return Premise::kConvex;
    }
  }
  // Two tetrahedra that have the other points in common and one side each.
  const unsigned rest = five & ~(c.positive | c.negative);
  const auto is_side_of_some = [&](unsigned side) {
    return std::any_of(
        triangulation.tetrahedra.begin(), triangulation.tetrahedra.end(),
        [&](VertexBits tetrahedron) { return (tetrahedron & five) == (rest | side); });
  };
  return is_side_of_some(c.positive) && is_side_of_some(c.negative) ? Premise::kProper
                                                                    : Premise::kNone;
}

}  // namespace

std::size_t sign_variables(int vertices) noexcept {
  return binomial(static_cast<std::uint32_t>(vertices), 4);
}

std::optional<std::vector<DeniedSign>> denied_signs(const Literals& clause, int vertices) {
  const auto variables = static_cast<std::int64_t>(sign_variables(vertices));
  std::vector<DeniedSign> denied;
  for (const std::int64_t literal : clause) {
    const std::int64_t variable = literal < 0 ? -literal : literal;
    if (variable < 1 || variable > variables) return std::nullopt;
    const VertexBits four = fours()[static_cast<std::size_t>(variable - 1)];
    if (sign_among(four, denied) != 0) return std::nullopt;
    denied.push_back({four, literal < 0 ? 1 : -1});
  }
  return denied;
}

std::array<std::array<VertexBits, 2>, 3> product_brackets(VertexBits common, VertexBits others) {
  const auto [w, x, y, z] = members_of(others);
  const auto bracket = [common](std::uint8_t p, std::uint8_t q) {
    return static_cast<VertexBits>(common | 1U << p | 1U << q);
  };
  return {{{bracket(w, x), bracket(y, z)},
           {bracket(w, y), bracket(x, z)},
           {bracket(w, z), bracket(x, y)}}};
}

std::optional<std::array<int, 3>> product_signs(VertexBits common, VertexBits others,
                                                const std::vector<DeniedSign>& signs) {
  const std::uint8_t a = members_of(common)[0];
  const std::uint8_t b = members_of(common)[1];
  const auto brackets = product_brackets(common, others);
  std::array<int, 3> result = {1, -1, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const VertexBits four : brackets[i]) {
      const auto pair = members_of(static_cast<VertexBits>(four & ~common));
      result[i] *= parity_of({a, b, pair[0], pair[1]}) * sign_among(four, signs);
    }
    if (result[i] == 0) return std::nullopt;
  }
  return result;
}

Premise premise_of(const Literals& clause, const SignedTriangulation& triangulation,
                   Condition condition) {
  const auto denied = denied_signs(clause, triangulation.vertices);
  if (!denied || denied->empty() || denied->size() > 6) return Premise::kNone;
  if (denied->size() == 6) {
    return contradicts_relation(*denied) ? Premise::kGrassmannPluecker : Premise::kNone;
  }
  if (denied->size() == 1) {
    if (contradicts_tetrahedron(denied->front(), triangulation)) return Premise::kSign;
    const bool is_corner = condition == Condition::kJacobian && contradicts_corner(denied->front());
    return is_corner ? Premise::kCorner : Premise::kNone;
  }
  if (denied->size() == 5 && condition == Condition::kJacobian && contradicts_edge(*denied)) {
    return Premise::kEdge;
  }
  unsigned all = 0;
  for (const DeniedSign& one : *denied) all |= one.four;
  if (std::popcount(all) != 5) return Premise::kNone;
  return contradicted_by_circuit(*denied, static_cast<VertexBits>(all), triangulation, condition);
}

}  // namespace hexatlas::check
