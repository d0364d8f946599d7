#pragma once
/// \file
/// Meshes of a boundary made from a part of a mesh of another boundary and a ball.
///
/// Definition. Two boundaries Q and D are *alike* if a circle of edges cuts a disc E off Q and a
/// disc F off D such that both are the same outside of these discs. Let M be a mesh of D and G a
/// ball of hexahedra of M that has the quads of F on its boundary and all hexahedra at the vertices
/// inside F. Then M without G is a collar of Q, a *transplant*, and leaves a cavity whose boundary
/// is that of G with E in place of F. A ball with this boundary makes a mesh of Q. Its faults are
/// the scars that the ball and the transplant have in common, and the pairs that the transplant
/// relates and that lie in a quad of E, but in no other quad of the cavity
/// (docs/theory/proofs/front.md, section 8).
///
/// Why. Collars grown from Q are thin, and of many boundaries few. A transplant is a part of a
/// mesh that a long search has made small, so most of the mesh that it leads to is good already.
///
/// Transplants are of this project.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/flips/beam.hpp"
#include "enum/flips/faults.hpp"
#include "enum/flips/walk.hpp"

namespace hexatlas::flips {

/// The mesh that is known of a boundary, right-handed, vertices 0 .. quads+1 being those of the
/// boundary in canonical labels; nullopt if none with fewer than `below` hexahedra is known.
using MeshSource = std::function<std::optional<complex::HexComplex>(const canon::Code&, int below)>;

struct TransplantOptions {
  int max_circle = 8;   ///< edges of the circle around both discs, at most 10
  int max_gained = 10;  ///< quads of the disc of the target
  int max_interior =
      3;  ///< vertices inside the disc that it replaces, at most 8, and 16 with those of the circle
  std::size_t tries = 20'000;  ///< balls grown, each in a mesh drawn at random
  FaultyWanted wanted;
  std::uint64_t seed = 1;
  int threads = 1;  ///< does not change the result
};

/// Of all meshes of `target` by transplants that are met, some drawn at random as by
/// faulty_meetings(); if there are any without a fault, the least of these comes first. Meshes in
/// which two facets have the same vertices are left out. Requires that `target` is the code of a
/// 3-connected quadrangulation with at most kMaxSearchQuads quads, that `balls` grew from the
/// single hexahedron, and that at least one mesh is wanted. Deterministic. Cost: up to a second for
/// the boundaries that are alike, and some 0.1 ms per try.
[[nodiscard]] std::vector<FaultyMesh> transplants(const Beam& balls, const MeshSource& meshes,
                                                  const canon::Code& target,
                                                  const TransplantOptions& options);

}  // namespace hexatlas::flips
