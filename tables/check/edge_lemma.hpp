#pragma once
/// \file
/// Internal to the judge: the edge lemma for hexahedra with positive Jacobian determinant
/// (docs/formats/catalogue.md, "Edge lemma"; docs/theory/proofs/edge-lemma.md).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tables/check/chirotope_clauses.hpp"

namespace hexatlas::check {

/// A determinant [a b c d] of corners, times `factor`.
struct SignedBracket {
  std::array<std::uint8_t, 4> corners{};
  int factor = 1;

  [[nodiscard]] VertexBits four() const noexcept;
};

/// x0 x1 < 0 implies that y0 |x1| + y1 |x0| has the sign of turn x0.
struct EdgeCase {
  SignedBracket x0, x1, y0, y1, turn;
};

/// nullopt if the numbers name none.
[[nodiscard]] std::optional<EdgeCase> edge_case(std::uint64_t tail, std::uint64_t axis,
                                                std::uint64_t apex, std::uint64_t side);

/// Whether the signs break some case: y0 and y1 both have the wrong sign.
[[nodiscard]] bool contradicts_edge(const std::vector<DeniedSign>& denied);

/// Whether the signs imply |y0| |x1| > |y1| |x0| (`larger` 1) or the reverse (2).
[[nodiscard]] bool implies_larger(const EdgeCase& edge, const std::vector<DeniedSign>& denied,
                                  std::uint64_t larger);

}  // namespace hexatlas::check
