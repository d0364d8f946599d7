#pragma once
/// \file
/// Meshing by peeling: hexahedra are taken off inwards from the boundary until what is left is
/// small, and the rest comes from a table, or from the linear construction.
///
/// Method. Short sequences of flips and the removal of zones (enum/flips/reducing.hpp) make the
/// cavity smaller until none of either is left. Then a layer below all of the cavity clears what
/// the hexahedra taken off forbid, and it begins anew. Flips that lead from a quadrangulation to
/// one whose mesh is known: K. Verhetsel, J. Pellerin, J.-F. Remacle, ACM TOG 38(4) (2019), for up
/// to 20 quads and by search.
///
/// Not promised: a bound. About one hexahedron per quad has been seen, fewer for large surfaces
/// (experiments/2026-11-few-hexahedra). The linear construction ends what cannot be peeled.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/flips/reducing.hpp"
#include "meshing/mesh/mesh.hpp"
#include "tables/format/sectors.hpp"
#include "tables/format/table.hpp"

namespace hexatlas::hexahedrize {

struct PeelOptions {
  flips::ReducingOptions reducing{};
  /// How many orders in which the quads are tried; the mesh with the fewest hexahedra counts.
  /// 0: from 50 for small surfaces to 1 for 20,000 quads and more.
  std::size_t tries = 0;
  /// Layers below the whole boundary before anything else: hexahedra of good shape there.
  std::size_t layers = 0;
  int threads = 1;  ///< does not change the result
};

/// Where the hexahedra of what was left come from.
enum class Rest : std::uint8_t {
  table,   ///< an entry of the table
  layer,   ///< it is a layer between two discs that are alike
  sectors  ///< the linear construction
};

struct PeelAccount {
  std::size_t peeled = 0;  ///< hexahedra taken off, layers included
  std::size_t layers = 0;
  std::size_t cavity = 0;  ///< quads of what was left
  Rest rest = Rest::sectors;
};

/// Vertices 0 .. sphere.vertices()-1 are those of the sphere. The hexahedra taken off come first,
/// in this order, so that a proof that the others are a ball is one for all.
struct PeeledMesh {
  complex::HexComplex mesh;
  PeelAccount account;
  std::vector<std::size_t> used;  ///< how often each of the sectors given, for the rest
};

/// Requires that complex::reason_against_filling(sphere) finds none, and sectors as read_sectors()
/// gives them. `table` may be null. Deterministic.
[[nodiscard]] PeeledMesh mesh_by_peeling(const complex::QuadSphere& sphere,
                                         const format::Table* table,
                                         std::span<const format::Sector> sectors,
                                         const PeelOptions& options = {});

/// The mesh that is made by removing zones alone, below the layers asked for, however many
/// hexahedra that takes, and by an entry of the table for what is left; nullopt if too much is
/// left. The boundary of a block of k x l x m hexahedra gives these again.
[[nodiscard]] std::optional<PeeledMesh> mesh_by_zones(const complex::QuadSphere& sphere,
                                                      const format::Table& table,
                                                      const PeelOptions& options = {});

/// The same with sharp zones and overhangs first (enum/flips/sharp_zones.hpp, facing.hpp), and what
/// is left as one layer if it is one: so a body that is swept, or a stack of such bodies, gets
/// hexahedra in layers, whatever quads there are at its ends. The order of the layers makes a
/// difference: meshes that end in one layer or hexahedron are given to `is_enough` one after the
/// other until it says so; if there are none, one that goes on with other zones, if there was any
/// sharp zone or overhang. `within` as for remove_sharp_zones(), at last. Requires a point for each
/// vertex of the sphere.
void meshes_by_sharp_zones(const complex::QuadSphere& sphere, std::span<const mesh::Point> points,
                           const format::Table& table, const PeelOptions& options, int within,
                           const std::function<bool(const PeeledMesh&)>& is_enough);

}  // namespace hexatlas::hexahedrize
