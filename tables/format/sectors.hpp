#pragma once
/// \file
/// Sectors: meshes of the one cell that the linear construction repeats (docs/formats/sectors.md,
/// which defines the surface, its numbering, and the file).

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "enum/complex/hex_complex.hpp"

namespace hexatlas::format {

inline constexpr int kSectorCorners = 6;  ///< of the hexagon; also the number of walls
inline constexpr complex::VertexId kSectorApex = 15;
inline constexpr complex::VertexId kSectorSurface = 28;  ///< vertices of the surface
inline constexpr int kSectorQuads = 26;

/// p(corner), the vertex next to a corner on its way to the apex; r(corner) after it, for a white
/// corner: an odd one.
[[nodiscard]] constexpr complex::VertexId after_corner(int corner) noexcept {
  return static_cast<complex::VertexId>(6 + corner + corner / 2);
}
[[nodiscard]] constexpr complex::VertexId before_apex(int white_corner) noexcept {
  return after_corner(white_corner) + 1;
}
/// y(wall) and z(wall).
[[nodiscard]] constexpr std::array<complex::VertexId, 2> inside_wall(int wall) noexcept {
  const auto y = static_cast<complex::VertexId>(16 + 2 * wall);
  return {y, y + 1};
}

/// The two quads of the base, then four for each wall; counter-clockwise from outside.
[[nodiscard]] std::array<complex::BoundaryQuad, kSectorQuads> sector_quads();

/// Two vertices of the surface, ascending.
using SurfacePair = std::array<complex::VertexId, 2>;

struct Sector {
  complex::HexComplex mesh;  ///< its first vertices are those of the surface
  /// The pairs that some hexahedron contains and no quad of the surface, ascending.
  std::vector<SurfacePair> scars;
};

/// The sectors of a file, fewest hexahedra first. Throws InvalidInput, with the line where there is
/// one, for bytes that are no such file, a sector with another boundary or that breaks a law of
/// complex::validate(), and if all have scars.
[[nodiscard]] std::vector<Sector> read_sectors(std::string_view bytes, const std::string& name);

/// The bytes of such a file. Requires meshes that read_sectors() would take.
[[nodiscard]] std::string sectors_bytes(std::span<const complex::HexComplex> meshes);

}  // namespace hexatlas::format
