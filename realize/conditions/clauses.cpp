#include "realize/conditions/clauses.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "enum/core/checks.hpp"
#include "realize/chirotope/chirotope.hpp"
#include "realize/conditions/edges.hpp"

namespace hexatlas::conditions {
namespace {

using certificate::Clause;
using certificate::Condition;
using chirotope::Literal;
using complex::Triangulation;
using complex::VertexSet;

void expect_tetrahedra(const Triangulation& triangulation) {
  core::expects(
      triangulation.vertices >= 4 && triangulation.vertices <= complex::kMaxTriangulationVertices,
      "conditions: 4 to 16 vertices");
  for (const VertexSet tetrahedron : triangulation.tetrahedra)
    core::expects(
        std::popcount(tetrahedron) == 4 && std::bit_width(tetrahedron) <= triangulation.vertices,
        "conditions: tetrahedra are sets of four vertices");
}

bool contains(VertexSet set, std::uint8_t vertex) { return (set & complex::bit_of(vertex)) != 0; }

void append_proper(VertexSet s, VertexSet t, const std::array<std::uint8_t, 5>& five,
                   std::vector<Clause>& clauses) {
  const std::array<Literal, 5> circuit = chirotope::circuit_of(five);
  std::vector<Literal> separated;  // all equal if the points of s only and of t only are apart
  for (std::size_t i = 0; i < 5; ++i) {
    if (!contains(t, five[i])) separated.push_back(circuit[i]);
    if (!contains(s, five[i])) separated.push_back(-circuit[i]);
  }
  for (Clause& clause : chirotope::not_all_equal(separated)) clauses.push_back(std::move(clause));
}

void append(std::vector<Clause> from, std::vector<Clause>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

std::vector<Clause> sign_clauses(const Triangulation& triangulation, std::span<const int> signs) {
  expect_tetrahedra(triangulation);
  core::expects(signs.size() == triangulation.tetrahedra.size(),
                "conditions: one sign per tetrahedron");
  std::vector<Clause> clauses;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    core::expects(signs[i] == 1 || signs[i] == -1, "conditions: signs are +1 or -1");
    const auto [a, b, c, d] = complex::vertices_of(triangulation.tetrahedra[i]);
    clauses.push_back({signs[i] * chirotope::literal_of(a, b, c, d)});
  }
  return clauses;
}

std::vector<Clause> proper_clauses(const Triangulation& triangulation) {
  expect_tetrahedra(triangulation);
  std::vector<Clause> clauses;
  const auto fives = chirotope::fives(triangulation.vertices);
  const std::vector<VertexSet>& tetrahedra = triangulation.tetrahedra;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    for (std::size_t j = i + 1; j < tetrahedra.size(); ++j)
      for (const auto& five : fives) {
        VertexSet set = 0;
        for (const std::uint8_t vertex : five) set |= complex::bit_of(vertex);
        if ((set & ~(tetrahedra[i] | tetrahedra[j])) == 0)
          append_proper(tetrahedra[i], tetrahedra[j], five, clauses);
      }
  return clauses;
}

std::vector<Clause> corner_clauses() {
  std::vector<Clause> clauses;
  for (int v = 0; v < 8; ++v) {
    const Literal literal = chirotope::literal_of(v, v ^ 1, v ^ 2, v ^ 4);
    clauses.push_back({std::popcount(static_cast<unsigned>(v)) % 2 == 0 ? literal : -literal});
  }
  return clauses;
}

std::vector<Clause> premises(const Triangulation& triangulation, std::span<const int> signs,
                             Condition condition) {
  std::vector<Clause> clauses = sign_clauses(triangulation, signs);
  append(chirotope::grassmann_pluecker_clauses(triangulation.vertices), clauses);
  append(chirotope::acyclic_clauses(triangulation.vertices), clauses);
  append(proper_clauses(triangulation), clauses);
  if (condition == Condition::convex)
    append(chirotope::convex_clauses(triangulation.vertices), clauses);
  if (condition == Condition::jacobian) {
    core::expects(triangulation.vertices == 8, "conditions: jacobian is asked of eight points");
    append(corner_clauses(), clauses);
    append(edge_clauses(), clauses);
  }
  return clauses;
}

}  // namespace hexatlas::conditions
