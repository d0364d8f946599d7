#pragma once
/// \file
/// The quads of the hexahedra of a mesh: which points are inside, whether hexahedra that share a
/// quad lie on its two sides, and how much the others enclose.
///
/// Requires indices below points.size() and eight distinct ones for each hexahedron.
/// Cost: that of sorting six quads for each hexahedron, and where a part has next to no volume some
/// microseconds for each of its boundary quads.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshing/mesh/mesh.hpp"
#include "realize/exact/sign.hpp"

namespace hexatlas::hexahedrize {

/// 1 for each point that is a vertex of a hexahedron.
[[nodiscard]] std::vector<std::uint8_t> points_of_cells(const mesh::HexMesh& mesh);

/// 1 for each point that has quads, all of them in two hexahedra.
[[nodiscard]] std::vector<std::uint8_t> interior_points(const mesh::HexMesh& mesh);

/// 1 for each point of an interface: a quad between hexahedra of two regions, or one between two
/// hexahedra that the file lists.
[[nodiscard]] std::vector<std::uint8_t> points_of_interfaces(const mesh::HexModel& model);

/// Why the hexahedra are none of a mesh: three have the same four vertices as a quad, or two have
/// it as different cycles, or both on the same side, so that they overlap however they are placed;
/// or a part has no boundary.
[[nodiscard]] std::optional<std::string> fault_of_sides(const mesh::HexMesh& mesh);

/// The sign of the volume that a closed surface of quads encloses. A quad need not be planar: it is
/// cut along either diagonal, which gives twice the volume under the bilinear patch. Exact.
/// Requires finite coordinates.
[[nodiscard]] exact::Sign sign_of_volume(std::span<const std::array<mesh::Point, 4>> quads);

/// Hexahedra that are joined by quads.
struct Part {
  std::vector<std::size_t> cells;  ///< ascending
  std::size_t boundary_quads = 0;  ///< quads that only one hexahedron has
  /// Of the volume within these, bilinear patches: negative where the hexahedra are inside out.
  exact::Sign side = exact::Sign::zero;
};

/// By their first cells.
[[nodiscard]] std::vector<Part> parts_of(const mesh::HexMesh& mesh);

}  // namespace hexatlas::hexahedrize
