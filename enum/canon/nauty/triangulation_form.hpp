#pragma once
/// \file
/// Isomorphism and automorphisms of three-dimensional simplicial complexes, through nauty's
/// canonical labelling of their incidence graph.
///
/// The graph has a node per vertex and a node per tetrahedron, coloured so, and joins a tetrahedron
/// to its vertices. Its isomorphisms are those of the complexes, mirror images included. Source:
/// B. D. McKay, A. Piperno, Practical graph isomorphism II, J. Symb. Comput. 60 (2014).

#include <cstdint>

#include "enum/complex/triangulation.hpp"

namespace hexatlas::canon {

struct TriangulationForm {
  /// The same for two complexes if and only if they are isomorphic; isomorphic to them. Its labels
  /// are nauty's: no least list of any kind is promised.
  complex::Triangulation canonical;
  /// Maps the complex of the question to `canonical`.
  complex::VertexMap labels{};
  /// Order of the automorphism group, mirror symmetries included; exact.
  std::uint64_t automorphisms = 0;
  /// The least vertex that an automorphism maps to this vertex; vertices of the question.
  complex::VertexMap orbit{};
};

/// Requires distinct tetrahedra, joined by chains of common triangles, that use all vertices; then
/// the order of the group is at most 24 times their number. Cost: about ten microseconds for a
/// sphere on nine vertices. Thread-safe.
[[nodiscard]] TriangulationForm triangulation_form(const complex::Triangulation& triangulation);

}  // namespace hexatlas::canon
