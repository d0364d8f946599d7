#pragma once
/// \file
/// What a positive Jacobian determinant on the edges of the cube demands of the signs and sizes of
/// determinants of four corners: the edge lemma, docs/theory/proofs/edge-lemma.md. The numbering of
/// edges and sides is that of docs/formats/catalogue.md.

#include <cstdint>
#include <optional>
#include <vector>

#include "realize/certificate/certificate.hpp"
#include "realize/chirotope/chirotope.hpp"

namespace hexatlas::conditions {

/// If x0 and x1 differ in sign, y0 |x1| + y1 |x0| has the sign of `turn` times x0.
struct EdgeRelation {
  std::uint8_t tail = 0, axis = 0, apex = 0, side = 1;
  certificate::Literal x0 = 0, x1 = 0, y0 = 0, y1 = 0, turn = 0;
};

/// The relation of these numbers. Requires tail and apex below 8, axis below 3, side 1 or 2, bit
/// `axis` of tail 0, and an apex on the diagonally opposite edge; else nullopt.
[[nodiscard]] std::optional<EdgeRelation> edge_relation(std::uint8_t tail, std::uint8_t axis,
                                                        std::uint8_t apex, std::uint8_t side);

/// All 48: 12 edges, 2 vertices of the opposite edge, 2 sides.
[[nodiscard]] std::vector<EdgeRelation> edge_relations();

/// Not both y0 and y1 have the wrong sign: four clauses per relation.
[[nodiscard]] std::vector<certificate::Clause> edge_clauses();

/// 1 if the signs imply |y0| |x1| > |y1| |x0|, 2 if the reverse, nullopt if neither.
[[nodiscard]] std::optional<std::uint8_t> larger_product(const EdgeRelation& relation,
                                                         const chirotope::Signs& signs);

}  // namespace hexatlas::conditions
