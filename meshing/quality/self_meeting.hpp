#pragma once
/// \file
/// Whether a quad surface in space meets itself, so that no mesh without overlaps has it for its
/// boundary.
///
/// Definition. A quad carries the bilinear patch of its four points, as facets of trilinear
/// hexahedra do. A quad is *folded* if it is flat and not strictly convex. Two quads *meet wrongly*
/// if their patches have a common point that is neither a common vertex nor on a common edge of
/// theirs; vertices and edges are those of the list of quads, so that equal points of different
/// vertices are such a point.
///
/// What it means. A hexahedron with a folded quad is not valid. In a mesh with quads that meet
/// wrongly two hexahedra have a common point outside their common face, or one is mapped into space
/// with two of its points at one place, even if each one is valid. docs/theory/self-meeting.md has
/// the proofs.
///
/// Decided exactly: folded quads; and whether an edge of one of two quads meets the patch of the
/// other one outside what they share. Method and source: realize/exact/patch.hpp, and
/// realize/exact/patch_separation.hpp as a filter.
/// Not decided, and not found: two patches, neither of them flat, that meet in curves or points
/// inside both only, or in a curve from a shared vertex or edge to itself, while no edge meets
/// the other patch. (If one of them is flat, and two shared vertices are always the ends of a
/// shared edge, as in a 3-connected surface, then nothing is left open.) So "none found" does not
/// prove that the surface is embedded.
///
/// Requires. Finite coordinates, indices below points.size(), at most 2^32 - 1 quads; else
/// PreconditionViolated. Nothing is required of the topology.
/// Cost. O(n log n), plus about a microsecond per pair of quads with boxes that meet, and up to 0.1
/// milliseconds per pair that no plane separates. Many long or large quads near each other make
/// n^2 / 2 pairs.

#include <cstdint>
#include <optional>

#include "meshing/mesh/mesh.hpp"

namespace hexatlas::quality {

/// The quads in the order of the list, from 0; first < second, or equal for a folded quad.
struct SelfMeeting {
  std::uint32_t first = 0, second = 0;
  [[nodiscard]] bool is_folded_quad() const noexcept { return first == second; }
  friend bool operator==(const SelfMeeting&, const SelfMeeting&) = default;
};

/// The first folded quad; if there is none, the pair that meets wrongly with the least first,
/// then the least second quad; nullopt if none is found. The same on every machine.
[[nodiscard]] std::optional<SelfMeeting> first_self_meeting(const mesh::SurfaceMesh& surface);

}  // namespace hexatlas::quality
