#pragma once
/// \file
/// Hexahedral complexes of any size and the laws of a valid one.
///
/// Strict rule. Two hexahedra meet in nothing, one vertex, one edge of both, or one quad that is
/// a facet of both; each quad is in at most two hexahedra. It is decided by pairs of vertices:
/// a pair of one hexahedron is an edge, a facet diagonal or a body diagonal of it, and the rule
/// holds if and only if each pair is of the same kind in all hexahedra that contain it, a body
/// diagonal is in one hexahedron only, and all hexahedra that contain a facet diagonal share its
/// facet (docs/theory/proofs/strict-rule.md).

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "enum/complex/broken_law.hpp"

namespace hexatlas::complex {

using VertexId = std::uint32_t;
using Hexahedron = std::array<VertexId, 8>;  ///< vertex x + 2y + 4z, see enum/cells/cube.hpp
using BoundaryQuad = std::array<VertexId, 4>;

struct HexComplex {
  std::uint32_t vertices = 0;  ///< numbered 0 .. vertices-1
  std::vector<Hexahedron> hexahedra;
};

/// The first broken law of: every vertex is below `vertices` and in some hexahedron; the 8
/// vertices of a hexahedron are distinct; the strict rule; neighbours are oriented alike; the link
/// of each vertex is a sphere or a disc; the complex is connected; the boundary is one sphere. Not
/// promised: that the complex is a ball, see shelling_of(). Cost: O(H log H).
[[nodiscard]] std::optional<BrokenLaw> validate(const HexComplex& mesh);

/// The quads in exactly one hexahedron, counter-clockwise from outside if the hexahedra are
/// right-handed; in the order of their hexahedra. Requires that quads are in at most two.
[[nodiscard]] std::vector<BoundaryQuad> boundary_of(const HexComplex& mesh);

/// The same mesh with the vertices of `first` numbered 0, 1, ..., the others after them in the
/// order of the hexahedra. Vertices of no hexahedron are left out unless they are in `first`.
[[nodiscard]] HexComplex renumbered(HexComplex mesh, std::span<const VertexId> first);

/// As renumbered(), with the vertices 0 .. kept-1 first, which so stay as they are.
[[nodiscard]] HexComplex compacted(HexComplex mesh, int kept);

/// The mirror image on the same vertices: each hexahedron with its first two axes exchanged.
[[nodiscard]] HexComplex mirrored(HexComplex mesh);

/// Whether boundary_of(mesh) consists of these quads, as oriented cycles in any order.
[[nodiscard]] bool has_boundary(const HexComplex& mesh, std::vector<BoundaryQuad> quads);

/// An order of the hexahedra in which they can be taken off one by one, the rest being a ball
/// each time; nullopt if none was found in `tries` attempts. Its existence proves that a
/// complex with validate() == nullopt is a ball; its absence proves nothing.
/// Method: greedy, fewest shared facets first, ties broken by a seeded hash that differs from
/// one attempt to the next; deterministic. Cost: O(tries * H log H) if vertices
/// have bounded degree.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> shelling_of(const HexComplex& mesh,
                                                                    int tries = 100);

}  // namespace hexatlas::complex
