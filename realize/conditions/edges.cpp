#include "realize/conditions/edges.hpp"

#include "realize/chirotope/chirotope.hpp"

namespace hexatlas::conditions {
namespace {

using certificate::Clause;
using certificate::Literal;
using chirotope::literal_of;

Literal negated_if(bool negate, Literal literal) { return negate ? -literal : literal; }

}  // namespace

std::optional<EdgeRelation> edge_relation(std::uint8_t tail, std::uint8_t axis, std::uint8_t apex,
                                          std::uint8_t side) {
  if (tail > 7 || axis > 2 || side < 1 || side > 2 || ((tail >> axis) & 1) != 0)
    return std::nullopt;
  const int v = tail, w = tail | (1 << axis);
  const int i = 1 << ((axis + 1) % 3), j = 1 << ((axis + 2) % 3);
  if (apex != (v ^ i ^ j) && apex != (w ^ i ^ j)) return std::nullopt;
  // Side 1 turns the vectors along i, side 2 those along j.
  const int x = side == 1 ? i : j, y = side == 1 ? j : i;
  EdgeRelation relation{tail, axis, apex, side};
  relation.x0 = negated_if((v & x) != 0, literal_of(v, w, v ^ x, apex));
  relation.x1 = negated_if((v & x) != 0, literal_of(v, w, w ^ x, apex));
  relation.y0 = negated_if((v & y) != 0, literal_of(v, w, v ^ y, apex));
  relation.y1 = negated_if((v & y) != 0, literal_of(v, w, w ^ y, apex));
  relation.turn = negated_if(side == 1, literal_of(v, w, v ^ x, w ^ x));
  return relation;
}

std::vector<EdgeRelation> edge_relations() {
  std::vector<EdgeRelation> relations;
  for (std::uint8_t axis = 0; axis < 3; ++axis)
    for (std::uint8_t tail = 0; tail < 8; ++tail)
      for (std::uint8_t apex = 0; apex < 8; ++apex)
        for (std::uint8_t side = 1; side <= 2; ++side)
          if (const auto relation = edge_relation(tail, axis, apex, side))
            relations.push_back(*relation);
  return relations;
}

std::vector<Clause> edge_clauses() {
  std::vector<Clause> clauses;
  for (const EdgeRelation& r : edge_relations())
    for (const int x : {1, -1})
      for (const int turn : {1, -1}) {
        // x0 has the sign x, x1 the other, so y0 and y1 are not both of the sign -turn x.
        const int wanted = turn * x;
        clauses.push_back({-x * r.x0, x * r.x1, -turn * r.turn, wanted * r.y0, wanted * r.y1});
      }
  return clauses;
}

std::optional<std::uint8_t> larger_product(const EdgeRelation& relation,
                                           const chirotope::Signs& signs) {
  const int x0 = chirotope::sign_of(relation.x0, signs);
  if (x0 == 0 || chirotope::sign_of(relation.x1, signs) != -x0) return std::nullopt;
  const int wanted = chirotope::sign_of(relation.turn, signs) * x0;
  const int y0 = chirotope::sign_of(relation.y0, signs);
  const int y1 = chirotope::sign_of(relation.y1, signs);
  if (wanted == 0 || y0 * y1 != -1) return std::nullopt;
  return y0 == wanted ? std::uint8_t{1} : std::uint8_t{2};
}

}  // namespace hexatlas::conditions
