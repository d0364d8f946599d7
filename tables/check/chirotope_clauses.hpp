#pragma once
/// \file
/// Internal to the judge: which clauses about the signs of four points hold in every realization of
/// a triangulation in general position (docs/formats/catalogue.md, "Premises").
///
/// The clauses are not listed; a given one is recognized. A clause denies one assignment of signs
/// to its variables, so the question is whether this assignment contradicts one of the laws.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tables/check/catalogue_read.hpp"
#include "tables/check/lrat.hpp"

namespace hexatlas::check {

/// A triangulation with the signs that its tetrahedra have in all realizations that are asked
/// about.
struct SignedTriangulation {
  int vertices = 0;
  const Tetrahedra& tetrahedra;
  const std::vector<int>& signs;  ///< of each tetrahedron, as in coherent_signs
};

/// The number of sign variables of so many points: C(n, 4).
[[nodiscard]] std::size_t sign_variables(int vertices) noexcept;

/// The sign of four points in ascending order where a literal is false.
struct DeniedSign {
  VertexBits four = 0;
  int sign = 0;
};
/// nullopt if a literal is of no variable, or two are of the same.
[[nodiscard]] std::optional<std::vector<DeniedSign>> denied_signs(const Literals& clause,
                                                                  int vertices);

/// The signs of the products T1 = [abwx][abyz], T2 = -[abwy][abxz], T3 = [abwz][abxy] of the
/// Grassmann-Pluecker relation T1 + T2 + T3 = 0 for `common` = {a, b}, a < b, and `others` = {w, x,
/// y, z}, w < x < y < z; nullopt if a sign is missing.
[[nodiscard]] std::optional<std::array<int, 3>> product_signs(VertexBits common, VertexBits others,
                                                              const std::vector<DeniedSign>& signs);

/// The three pairs of brackets of the products T1, T2, T3, as sets of four.
[[nodiscard]] std::array<std::array<VertexBits, 2>, 3> product_brackets(VertexBits common,
                                                                        VertexBits others);

enum class Premise : std::uint8_t {
  kNone,
  kSign,
  kGrassmannPluecker,
  kAcyclic,
  kProper,
  kConvex,
  kCorner,
  kEdge,
};

/// Why the clause holds in every realization under the condition; kNone if for no known reason.
/// Cost: O(t). Requires eight vertices if the condition is jacobian.
[[nodiscard]] Premise premise_of(const Literals& clause, const SignedTriangulation& triangulation,
                                 Condition condition);

}  // namespace hexatlas::check
