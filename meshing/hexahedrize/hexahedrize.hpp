#pragma once
/// \file
/// Hexahedral mesh of a ball given by a quad surface. The boundary's canonical code is looked up
/// in a table, and the mesh found there is carried over to the surface's own vertices; a boundary
/// that is not in the table is peeled by zones or flips until what is left is (peel.hpp), or
/// meshed by the linear construction (linear.hpp).
///
/// All of it is exact, the same on every machine, except where the interior vertices are placed:
/// that is done by realize/untangle. Nothing is promised about the shape of the hexahedra;
/// meshing/quality says what it is. That the mesh obeys the strict rule and is a ball is the word
/// of the table, or the theorem of the construction; tables/check is the judge of that.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "enum/complex/quad_surface.hpp"
#include "meshing/hexahedrize/peel.hpp"
#include "meshing/mesh/mesh.hpp"
#include "realize/untangle/untangle.hpp"
#include "tables/format/sectors.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::hexahedrize {

enum class Method : std::uint8_t {
  table,        ///< the table has this boundary
  zones,        ///< zones removed until the rest is in the table, or one layer
  flips,        ///< peeled until the rest is in the table, or small enough for sectors
  construction  ///< by sectors
};

/// What may be used. At least one of table and sectors.
struct Means {
  const format::Table* table = nullptr;
  std::span<const format::Sector> sectors{};
  /// Else the first that can: the table, zones, flips; and where it leaves hexahedra that are not
  /// valid, the next if that leaves fewer: zones after the table, flips after zones. With layers
  /// zones, then flips; zones put one layer below a smooth boundary themselves where that makes
  /// poor hexahedra much better.
  std::optional<Method> only{};
  PeelOptions peeling{};
};

/// Meshes of more hexahedra are large.
inline constexpr std::size_t kSmallMesh = 10'000;

/// How the interior vertices are placed.
struct Placing {
  /// As of untangle::Options. By default what is usual there, and 0 for a large mesh, which so
  /// little work does not change.
  std::optional<int> effort{};
  int threads = 1;
};

/// What the linear construction did.
struct ConstructionAccount {
  struct Use {
    std::size_t hexahedra = 0;  ///< of the sector
    std::size_t times = 0;
  };
  std::vector<Use> sectors;         ///< in the order of the sectors given
  std::size_t hexahedra_bound = 0;  ///< for this number of quads, by the theorem (linear.hpp)
};

/// A mesh whose first points are those of the surface, bit for bit and in order; the quads in
/// one hexahedron only are those of the surface, up to rotation and the notes on orientation.
struct Hexahedrized {
  mesh::HexMesh mesh;
  Method method = Method::table;
  std::string code;  ///< of the boundary, the key of the table's entry; else empty
  std::size_t interior_vertices = 0;
  std::optional<PeelAccount> peeling;  ///< by zones or flips
  ConstructionAccount construction;    ///< by construction, of the whole or of what flips left
};

/// No mesh under the strict rule can have this boundary.
struct Impossible {
  std::string reason;  ///< one sentence without a full stop
};

/// The table has nothing for this boundary, or for what is left of it without zones, and nothing
/// else was allowed. This proves nothing.
struct NotInTable {
  std::size_t quads = 0;
  std::string code;  ///< empty above 64 quads
};

/// What was done to the surface before it was meshed.
struct SurfaceNotes {
  std::size_t unused_points = 0;   ///< kept as points of the mesh
  std::size_t reversed_quads = 0;  ///< turned over to agree with the majority
  bool turned_outwards = false;    ///< all quads turned over: the volume was negative
};

struct Answer {
  std::variant<Hexahedrized, Impossible, NotInTable> outcome;
  SurfaceNotes notes;
};

/// The sphere that the quads form; `file` stands for the surface in messages.
/// Throws InvalidInput if they form none, with the line of the quad at fault where it is known.
[[nodiscard]] complex::QuadSphere sphere_of(const mesh::SurfaceMesh& surface,
                                            const std::string& file);

/// `file` stands for the surface in messages.
/// Throws InvalidInput if the surface is not a quadrangulated sphere, with the line of the quad
/// at fault where it is known. Cost: O(n log n) for n quads, plus a look-up or the construction,
/// and the placing.
[[nodiscard]] Answer hexahedrize(const mesh::SurfaceMesh& surface, const Means& means,
                                 const std::string& file, const Placing& placing = {});

}  // namespace hexatlas::hexahedrize
