#pragma once
/// \file
/// Involutions of whole meshes.
///
/// An involution of the boundary of a ball glued of hexahedra extends to the hexahedra in at most
/// one way: across a facet whose image is known there is one hexahedron, and so on from the
/// boundary. Whether it does is decided by following all of them.

#include <cstdint>
#include <optional>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/flips/sub_ball.hpp"
#include "enum/flips/symmetric_front.hpp"

namespace hexatlas::flips {

/// An automorphism of order two of a mesh.
struct MeshInvolution {
  std::vector<complex::VertexId> vertex;  ///< image of each vertex
  std::vector<std::uint32_t> cell;        ///< image of each hexahedron
  bool is_mirrored = false;               ///< reverses orientation
};

/// The involution of the mesh that is `of_boundary` on the vertices 0 .. quads+1, which are those
/// of its boundary; nullopt if there is none. Requires a connected mesh without two facets of the
/// same vertices (SubBall::neighbours_if_complex()), whose vertices all are in hexahedra, and an
/// involution of its boundary. Cost: linear, some microseconds for 50 hexahedra.
[[nodiscard]] std::optional<MeshInvolution> extended(const Involution& of_boundary,
                                                     const complex::HexComplex& mesh, int quads,
                                                     const SubBall::Neighbours& neighbours);

}  // namespace hexatlas::flips
