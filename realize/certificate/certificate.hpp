#pragma once
/// \file
/// What is known of one triangulation and one condition: coordinates, a refutation, or nothing.
/// Plain data; the format and the meaning of every part are those of docs/formats/catalogue.md. The
/// laws are tested by tables/check, which shares no code with this.

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace hexatlas::certificate {

/// What is asked of the points; definitions in docs/theory/triangulation-definition.txt.
enum class Condition : std::uint8_t { embedded, convex, jacobian };
inline constexpr std::array<Condition, 3> kConditions{Condition::embedded, Condition::convex,
                                                      Condition::jacobian};
[[nodiscard]] std::string_view name_of(Condition condition);

/// Coordinates are below this in absolute value.
inline constexpr std::int64_t kCoordinateBound = std::int64_t{1} << 20U;

using IntegerPoint = std::array<std::int64_t, 3>;
using Realization = std::vector<IntegerPoint>;  ///< point of vertex 0, 1, ...

using Literal = std::int32_t;  ///< +-variable, variables from 1
using Clause = std::vector<Literal>;

/// weight (log |T_larger| - log |T_smaller|) for the relation of {a,b} and w < x < y < z.
struct FinalPolynomialTerm {
  std::int64_t weight = 1;
  std::array<std::uint8_t, 2> common{};  ///< a < b
  std::array<std::uint8_t, 4> others{};  ///< w < x < y < z
  std::uint8_t larger = 1, smaller = 2;  ///< 1, 2 or 3
  friend bool operator==(const FinalPolynomialTerm&, const FinalPolynomialTerm&) = default;
};

/// weight times an inequality of an edge of the cube, for Condition::jacobian
/// (docs/theory/proofs/edge-lemma.md).
struct EdgeTerm {
  std::int64_t weight = 1;
  std::uint8_t tail = 0;    ///< end of the edge with coordinate 0 in its direction
  std::uint8_t axis = 0;    ///< direction of the edge: 0, 1, 2
  std::uint8_t apex = 0;    ///< the vertex u of the diagonally opposite edge
  std::uint8_t side = 1;    ///< 1: the edge vectors along the next axis turn over; 2: the one after
  std::uint8_t larger = 1;  ///< 1: |y0| |x1| is the larger product; 2: |y1| |x0|
  friend bool operator==(const EdgeTerm&, const EdgeTerm&) = default;
};

struct FinalPolynomial {
  Clause clause;
  std::vector<FinalPolynomialTerm> terms;
  std::vector<EdgeTerm> edge_terms;
  friend bool operator==(const FinalPolynomial&, const FinalPolynomial&) = default;
};

struct Lemma {
  Clause clause;
  std::vector<std::uint32_t> hints;  ///< numbers of clauses, from 1
  friend bool operator==(const Lemma&, const Lemma&) = default;
};

/// Clauses are numbered from 1: premises, then polynomials, then lemmas; the last lemma is empty.
struct Refutation {
  std::vector<Clause> premises;
  std::vector<FinalPolynomial> polynomials;
  std::vector<Lemma> lemmas;
  friend bool operator==(const Refutation&, const Refutation&) = default;
};

struct Open {
  friend bool operator==(const Open&, const Open&) = default;
};

using Answer = std::variant<Open, Realization, Refutation>;

}  // namespace hexatlas::certificate
