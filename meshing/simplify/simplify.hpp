#pragma once
/// \file
/// Hexahedral meshes made smaller by exchanging cavities, with the boundary kept.
///
/// Definition. A cavity here is a ball of hexahedra of the mesh. It grows hexahedron by hexahedron
/// from a random one; each ball that it passes is looked up among the balls known with the same
/// boundary (known_balls.hpp), in each position that the symmetries of the boundary allow, and
/// exchanged for one that fits. An exchange that leaves the number of hexahedra as it is, or raises
/// it a little, is made at times, to leave what no exchange makes smaller at once: deterministic
/// threshold accepting, with returns to the least mesh (Dueck, Scheuer, J. Comput. Phys. 90, 1990).
///
/// Source. Exchange of cavities: Verhetsel, Pellerin, Remacle, "A 44-element mesh of Schneiders'
/// pyramid" (IMR 2018), by search of each cavity. The test by scars is of this project
/// (docs/theory/proofs/front.md, section 5).

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/scars.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::simplify {

using VertexPair = std::array<complex::VertexId, 2>;

struct Options {
  std::size_t tries = 20'000;  ///< cavities grown
  unsigned uphill = 2;         ///< hexahedra that meshes on the way may have above the least one
  std::uint64_t seed = 1;
  int max_cavity = 24;  ///< quads of the boundary of a cavity, at most flips::kMaxSearchQuads
  bool whole = true;    ///< the whole mesh may be exchanged, if its boundary is small enough
  /// Pairs of boundary vertices that no hexahedron of an exchange may contain both of, if none of
  /// the mesh given does: what is to be glued on outside may not allow it (enum/flips/front.hpp).
  std::vector<VertexPair> apart{};
  const std::atomic<bool>* stop = nullptr;  ///< set from elsewhere to end early
  /// Called at times with the tries made and the least number of hexahedra so far.
  std::function<void(std::size_t tries, std::size_t hexahedra)> progress{};
};

struct Simplified {
  complex::HexComplex mesh;   ///< the least one; the mesh given, as it was, if none was smaller
  std::size_t exchanges = 0;  ///< made on the way
  std::size_t tries = 0;      ///< fewer than asked for if it is stopped or one hexahedron is left
  bool is_stopped = false;
};

/// A mesh with the same boundary and at most as many hexahedra. The vertices of the boundary,
/// 0 .. quads+1, stay; the others are numbered anew. It obeys the strict rule, and is homeomorphic
/// to the mesh given. Requires that validate(mesh) finds no fault, and that the vertices of its
/// boundary come first. `table` may be null. Deterministic for given options if it is not stopped.
/// Not promised: minimality.
/// Cost: some microseconds per ball that a cavity passes, whatever the size of the mesh; linear in
/// the mesh at each departure uphill from the least mesh.
[[nodiscard]] Simplified simplified(const complex::HexComplex& mesh, const format::Table* table,
                                    const Options& options);

}  // namespace hexatlas::simplify
