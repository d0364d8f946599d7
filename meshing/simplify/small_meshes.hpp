#pragma once
/// \file
/// All small meshes of a boundary, by exhaustive search (enum/hexes).

#include <cstdint>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"

namespace hexatlas::simplify {

inline constexpr int kMaxSmallMesh = 8;  ///< hexahedra

struct SmallMeshes {
  /// Balls under the strict rule; vertices 0 .. quads+1 are those of the boundary, right-handed if
  /// its quads are counter-clockwise from outside.
  std::vector<complex::HexComplex> meshes;
  /// The search ended: there is no other shellable one.
  bool is_all = false;
};

/// The meshes of the boundary with at most `max_hexahedra` hexahedra that `max_nodes` nodes of the
/// search find. Requires a 3-connected boundary of at most flips::kMaxSearchQuads quads and
/// max_hexahedra <= kMaxSmallMesh. Cost: about a microsecond per node.
[[nodiscard]] SmallMeshes small_meshes(const complex::Quadrangulation& boundary, int max_hexahedra,
                                       std::uint64_t max_nodes);

}  // namespace hexatlas::simplify
