#pragma once
/// \file
/// Uniform oriented matroids of rank 4 as sign vectors: one sign for each four of n points.
///
/// Definition. The sign of points a, b, c, d in space is that of det(b - a, c - a, d - a); points
/// in general position have no sign zero. A uniform chirotope is an alternating sign function on
/// fours that obeys the three-term Grassmann-Pluecker relations; it is acyclic if it could be that
/// of points (and not merely of vectors): the Radon partition of any five has two sides.
/// Sources: A. Bjoerner, M. Las Vergnas, B. Sturmfels, N. White, G. Ziegler, "Oriented Matroids"
/// (1999), chapter 3; L. Schewe, "Nonrealizable minimal vertex triangulations of surfaces: showing
/// nonrealizability using oriented matroids and satisfiability solvers" (2010).
///
/// Numbering and clauses are those of docs/formats/catalogue.md: the variable of a < b < c < d is
/// 1 + C(a,1) + C(b,2) + C(c,3) + C(d,4), true if the sign is positive. It does not depend on n.
///
/// Requires throughout: distinct points below kMaxPoints, else PreconditionViolated.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "realize/certificate/certificate.hpp"

namespace hexatlas::chirotope {

using certificate::Clause;
using certificate::Literal;

inline constexpr int kMaxPoints = 16;

/// Sign of each four by variable - 1: +1, -1, or 0 for a sign that is not known.
using Signs = std::vector<std::int8_t>;

/// Number of fours of n points: C(n, 4).
[[nodiscard]] std::size_t variable_count(int points);

/// The literal that is true if a, b, c, d, in this order, have a positive sign.
[[nodiscard]] Literal literal_of(int a, int b, int c, int d);

/// The four points of a variable, ascending. Requires a variable of kMaxPoints points.
[[nodiscard]] std::array<std::uint8_t, 4> points_of(Literal variable);

/// The sign of a literal: +1 if true, -1 if false, 0 if not known. Requires that `signs` covers it.
[[nodiscard]] int sign_of(Literal literal, const Signs& signs);

/// The relation T1 + T2 + T3 = 0 of the determinants of {a,b} and w < x < y < z, where
/// T1 = [abwx][abyz], T2 = -[abwy][abxz], T3 = [abwz][abxy].
struct PlueckerRelation {
  std::array<std::uint8_t, 2> common{};  ///< a < b
  std::array<std::uint8_t, 4> others{};  ///< w < x < y < z
};

/// All C(n,2) C(n-2,4) relations, ascending by (common, others).
[[nodiscard]] std::vector<PlueckerRelation> pluecker_relations(int points);

/// The two factors of T1, T2, T3 as literals; T2 has its sign in the first.
using PlueckerProducts = std::array<std::array<Literal, 2>, 3>;
[[nodiscard]] PlueckerProducts products_of(const PlueckerRelation& relation);

/// The side of e_i in the Radon partition of five points e_0 < .. < e_4, as a literal: two points
/// lie on the same side if their literals agree. (Which side is called positive has no meaning.)
[[nodiscard]] std::array<Literal, 5> circuit_of(const std::array<std::uint8_t, 5>& points);

/// All fives of n points, ascending.
[[nodiscard]] std::vector<std::array<std::uint8_t, 5>> fives(int points);

/// Not all of these literals are equal: two clauses.
[[nodiscard]] std::array<Clause, 2> not_all_equal(std::span<const Literal> literals);

/// Families of clauses over the variables of n points. Cost: 96 C(n,2) C(n-2,4) literals for the
/// first, 6,720 clauses for n = 8; 2 and 10 clauses per five points for the others.
[[nodiscard]] std::vector<Clause> grassmann_pluecker_clauses(int points);
[[nodiscard]] std::vector<Clause> acyclic_clauses(int points);
/// No point of five lies alone on its side: no point in the convex hull of four others.
[[nodiscard]] std::vector<Clause> convex_clauses(int points);

}  // namespace hexatlas::chirotope
