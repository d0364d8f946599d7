#pragma once
/// \file
/// Meshes of the boundaries that are alike to a given one (transplant.hpp).

#include <algorithm>
#include <cstdint>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/flips/sub_ball.hpp"
#include "enum/flips/transplant.hpp"

namespace hexatlas::flips {

/// A mesh of a boundary that is alike to the target. Its vertices outside of the disc have the
/// numbers of the target, in canonical labels; those below target.quads + 2 that it does not have
/// lie inside the disc of the target.
struct Donor {
  complex::HexComplex mesh;
  SubBall::Neighbours neighbours;
  std::vector<complex::QuadVertices> gained;  ///< the disc of the target
  std::vector<complex::BoundaryQuad> lost;    ///< the disc that it replaces, each ascending
  std::vector<std::uint32_t> torn;            ///< hexahedra with a quad, or at a vertex inside it
};

/// The same vertices in ascending order: equal for quads with the same vertices.
[[nodiscard]] inline complex::BoundaryQuad ascending(complex::BoundaryQuad quad) {
  std::sort(quad.begin(), quad.end());
  return quad;
}

/// The donors of a target, of fewer than options.wanted.below hexahedra, in a fixed order; of each
/// boundary at most four. Requires what transplants() does. Cost: about a second.
[[nodiscard]] std::vector<Donor> donors_of(const canon::Code& target, const MeshSource& meshes,
                                           const TransplantOptions& options);

}  // namespace hexatlas::flips
