#pragma once
/// \file
/// The linear construction: a hexahedral mesh of any ball whose boundary is a 3-connected
/// quadrangulation with an even number of quads.
///
/// Method. The quads are divided into pairs (pairing.hpp). The ball is cut into the cones over the
/// pairs, the *sectors*, all with the same apex; two neighbours share a wall of four quads. All
/// sectors have the same surface, and each is filled by one of a few meshes (tables/format/
/// sectors.hpp). Which one is decided by its *scars*, pairs of vertices of the surface that lie
/// together in a hexahedron and in no quad of the surface: the union obeys the strict rule if no
/// scar of a sector is a scar of another one or lies in a quad of a wall or of the boundary.
/// A sector without scars always fits. Proof: docs/theory/proofs/linear-bound.md.
///
/// The idea of a layer of cells between the boundary and a simple interior, and of pairing for
/// parity: S. Mitchell (1996), D. Eppstein (1999), J. Erickson (2014). The sectors and their
/// fillings are of this project.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quad_surface.hpp"
#include "tables/format/sectors.hpp"

namespace hexatlas::hexahedrize {

/// Vertices 0 .. sphere.vertices()-1 are those of the sphere, the next one is the apex.
struct LinearMesh {
  complex::HexComplex mesh;
  std::vector<std::size_t> used;  ///< how often each of the sectors given
};

/// Two vertices of the sphere that no hexahedron may contain both of.
using Apart = std::function<bool(complex::VertexId, complex::VertexId)>;

/// Requires that complex::reason_against_filling(sphere) finds none, and sectors as read_sectors()
/// gives them. The first of them that fits is taken for each pair, in the order of the quads.
/// At most hexahedra_bound() hexahedra. Deterministic. Cost: linear but for the pairing; some 2 KB
/// per quad. What `apart` says of two vertices in one quad is without effect.
[[nodiscard]] LinearMesh mesh_by_sectors(const complex::QuadSphere& sphere,
                                         std::span<const format::Sector> sectors,
                                         const Apart& apart = {});

/// h n / 2 for an even number n of quads, h being the hexahedra of the first sector without scars.
/// Requires that there is one.
[[nodiscard]] std::size_t hexahedra_bound(std::size_t quads,
                                          std::span<const format::Sector> sectors);

}  // namespace hexatlas::hexahedrize
