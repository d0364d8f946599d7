#pragma once
/// \file
/// What the judge says of a mesh.

#include <cstdint>
#include <string>

namespace hexatlas::check {

/// The laws of a valid mesh, in the order in which they are tested.
enum class Law {
  kNone,            ///< no law is broken
  kCorners,         ///< some hexahedra; eight distinct vertices each, all among the points
  kUnusedPoint,     ///< each point is a vertex of some hexahedron
  kTwoHexahedra,    ///< each quad lies in at most two hexahedra
  kStrictRule,      ///< two hexahedra meet in nothing, one vertex, one edge or one quad of both
  kOrientation,     ///< two hexahedra at a quad traverse it in opposite directions
  kConnected,       ///< the mesh is connected
  kLink,            ///< the link of a vertex is a sphere (interior) or a disc (boundary)
  kBoundarySphere,  ///< the boundary is one sphere
  kBall,            ///< the mesh is shown to be a ball
  kListedQuads,     ///< quads listed with the mesh are quads of hexahedra
  kSurfacePoints,   ///< the first points are those of the surface, bit for bit
  kSurfaceQuads,    ///< the boundary quads are those of the surface, as oriented cycles
};

struct Verdict {
  bool accepted = false;
  /// All laws but kBall hold, and neither a shelling nor a collapse was found: no answer.
  bool undecided = false;
  Law broken = Law::kNone;  ///< the first law that is broken, or not shown
  std::string reason;       ///< it in words; vertices and hexahedra are numbered from 0

  std::uint64_t vertices = 0;  ///< vertices of hexahedra; the counts below are complete if accepted
  std::uint64_t interior_vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t quads = 0;
  std::uint64_t hexahedra = 0;
  std::uint64_t boundary_quads = 0;
  bool is_ball = false;
  std::string ball_proof;  ///< "shelling" or "collapse"
  /// The hexahedra are oriented inwards: their boundary quads are those of the surface reversed.
  bool boundary_reversed = false;
  /// The surface is not coherently oriented, so its quads were compared as unoriented cycles.
  bool boundary_unoriented = false;
};

}  // namespace hexatlas::check
