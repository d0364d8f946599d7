#pragma once
/// \file
/// Isomorphism and automorphisms of hexahedral complexes and, as a second road beside the
/// planar code, of quadrangulations, through nauty's canonical labelling of a coloured graph.
///
/// The graph of a complex has a node per vertex, per quad and per hexahedron, coloured so, each
/// joined to the nodes of its faces of one kind lower. For the cubical complexes of this project
/// (a quad has four distinct vertices, a hexahedron eight) its isomorphisms are those of the
/// complexes. Source: B. D. McKay, A. Piperno, Practical graph isomorphism II, J. Symb. Comput.
/// 60 (2014).

#include <cstdint>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::canon {

/// Equal for two complexes if and only if they are isomorphic, mirror images identified.
struct GraphForm {
  std::vector<std::uint64_t> certificate;
  /// Order of the automorphism group, mirror symmetries included; exact.
  std::uint64_t automorphisms = 0;
};

/// Requires validate(mesh) == nullopt, or at least: distinct vertices in each hexahedron, and
/// any two hexahedra joined by a chain of shared quads; then the order is at most 48 H.
/// Throws InternalError if the order exceeds 64 bits. Thread-safe.
[[nodiscard]] GraphForm graph_form(const complex::HexComplex& mesh);

/// Requires a 3-connected quadrangulation: only then are the isomorphisms of its graph those of
/// the map (Whitney). Thread-safe.
[[nodiscard]] GraphForm graph_form(const complex::Quadrangulation& q);

}  // namespace hexatlas::canon
