#pragma once
/// \file
/// Meshes made smaller by exchanging a ball of their hexahedra for a smaller one.
///
/// Let G be hexahedra of a mesh M whose union is a ball, and B a ball with the same boundary. The
/// exchange (M without G) and B obeys the strict rule if and only if no pair of boundary vertices
/// of G is a scar of both B and the rest of M (docs/theory/proofs/front.md, section 5). Here G
/// grows hexahedron by hexahedron from a random one, and every ball that it passes is looked up
/// among the states of a beam.
///
/// Source. Exchange of cavities: Verhetsel, Pellerin, Remacle (IMR 2018) by search of each cavity;
/// the look-up by scars is of this project.

#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/sub_ball.hpp"

namespace hexatlas::flips {

struct ReplacementOptions {
  int growths = 100;  ///< balls grown, each from a hexahedron chosen at random
  std::uint64_t seed = 1;
  /// Only exchanges after which the mesh has a shelling as add_ball() requires; and the hexahedra
  /// of the result can be taken off in the order given.
  bool keep_shellable = true;
  /// How many hexahedra more than the least mesh so far the meshes on the way may have: to leave
  /// what no exchange makes smaller at once. Deterministic threshold accepting, with returns to the
  /// least mesh: Dueck, Scheuer (J. Comput. Phys. 90, 1990).
  unsigned uphill = 0;
};

/// A mesh with the same boundary and fewer hexahedra, or nullopt if none was found. The vertices of
/// the boundary, 0 .. quads+1, stay; the others are numbered anew. Exchanges that leave the number
/// of hexahedra as it is are made on the way. Requires that the mesh is a ball under the strict
/// rule, right-handed, and that `balls` grew from the single hexahedron. Deterministic. Safe to
/// call from several threads.
/// Cost: a few microseconds per ball passed.
[[nodiscard]] std::optional<complex::HexComplex> smaller_by_replacement(
    const complex::HexComplex& mesh, int quads, const Beam& balls,
    const ReplacementOptions& options);

/// The same mesh with its hexahedra in an order in which they can be taken off, all boundaries
/// having at most kMaxStateQuads quads; nullopt if none was found, which proves nothing. Requires
/// a ball under the strict rule. Deterministic. Cost: microseconds per try and hexahedron.
[[nodiscard]] std::optional<complex::HexComplex> in_shelling_order(const complex::HexComplex& mesh,
                                                                   int tries, std::uint64_t seed);

/// The greatest number of quads of the boundaries that the mesh has while its hexahedra are taken
/// off in the order given. Cost: linear.
[[nodiscard]] int widest_boundary(const complex::HexComplex& mesh);

/// Adds the ball to a beam that grew from the single hexahedron, with all balls on the way to it.
/// `mesh` as above: its hexahedra can be taken off in the order given, all boundaries having at
/// most kMaxStateQuads quads. Returns the state of the whole ball or one that dominates it.
FrontId add_ball(Beam& balls, const complex::HexComplex& mesh, FrontOrigin origin);

}  // namespace hexatlas::flips
