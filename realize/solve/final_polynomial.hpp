#pragma once
/// \file
/// Biquadratic final polynomials: proofs that no points have given signs.
///
/// Definition. If the signs of the six determinants of a Grassmann-Pluecker relation T1 + T2 + T3 =
/// 0 are known, the product whose sign differs from the other two is the greater in absolute value
/// than each of them. Such inequalities log |Tp| > log |Tq|, added with non-negative weights, are a
/// contradiction if each determinant cancels. The format and the meaning of a term are those of
/// docs/formats/catalogue.md. Source: J. Bokowski, J. Richter, "On the finding of final
/// polynomials", European J. Combin. 11 (1990).
///
/// Not promised: that signs of no points have one; there are examples without (Richter-Gebert, "Two
/// interesting oriented matroids", 1996).

#include <optional>

#include "realize/certificate/certificate.hpp"
#include "realize/chirotope/chirotope.hpp"

namespace hexatlas::solve {

/// Whether it is a proof, by integer addition: each term is an inequality under the negation of
/// the clause, and all determinants cancel. Never throws on nonsense, which is no proof.
[[nodiscard]] bool is_proof(const certificate::FinalPolynomial& polynomial);

/// A final polynomial that uses known signs only: the negated literals of its clause are some of
/// these, and few. Signs may be 0 (unknown); relations with unknown signs, and those that are
/// broken, are not used. nullopt: none was found, or none with weights of at most 2^31; the search
/// is in double precision, the weights and the test of the answer are exact. Requires one sign per
/// four points, else PreconditionViolated; throws ResourceFailure if linear programming gives up.
/// Cost: milliseconds for 8 points, seconds for 10. Terms of edges are used for
/// Condition::jacobian, which requires eight points.
[[nodiscard]] std::optional<certificate::FinalPolynomial> find_final_polynomial(
    int points, const chirotope::Signs& signs,
    certificate::Condition condition = certificate::Condition::embedded);

}  // namespace hexatlas::solve
