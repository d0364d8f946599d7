#pragma once
/// \file
/// The quality of a mesh in a few numbers.
///
/// Requires. Indices below the number of points and finite coordinates, else
/// PreconditionViolated. Cost: linear; below a microsecond for each cell that double precision
/// decides, some microseconds for each of the others, fifty and more for hexahedra. Those are
/// counted.

#include <array>
#include <cstddef>
#include <span>

#include "enum/core/checks.hpp"
#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/cells.hpp"
#include "meshing/quality/hexahedron.hpp"

namespace hexatlas::quality {

inline constexpr std::size_t kHistogramBins = 10;

/// The cells of one shape: valid + invalid + undecided == cells; the words are those of
/// hexahedron.hpp and cells.hpp, the volume is that of volume.hpp.
struct Report {
  std::size_t cells = 0;
  std::size_t valid = 0;
  std::size_t invalid = 0;
  std::size_t undecided = 0;        ///< hexahedra only
  std::size_t inverted = 0;         ///< some corner determinant <= 0, decided exactly
  double min_scaled_jacobian = 0;   ///< 0 without cells
  double mean_scaled_jacobian = 0;  ///< 0 without cells
  /// Cells by scaled Jacobian s: bin i has those with i <= 10 s < i + 1, the first also those
  /// with s < 0, the last also those with s = 1.
  std::array<std::size_t, kHistogramBins> histogram{};
  std::size_t exact_decisions = 0;  ///< cells that double precision could not decide
  double volume = 0;                ///< the sum of the signed volumes
};

/// One report for each shape.
struct HybridReport {
  Report tetrahedra, hexahedra, prisms, pyramids;
};

/// The points of one cell.
template <std::size_t kCount>
[[nodiscard]] std::array<mesh::Point, kCount> corners_of(
    std::span<const mesh::Point> points, const std::array<mesh::Index, kCount>& cell) {
  std::array<mesh::Point, kCount> corners{};
  for (std::size_t v = 0; v < kCount; ++v) {
    core::expects(cell[v] < points.size(), "quality: index of a point out of range");
    corners[v] = points[cell[v]];
  }
  return corners;
}

[[nodiscard]] Report report(const mesh::HexMesh& mesh);
[[nodiscard]] HybridReport report(const mesh::HybridMesh& mesh);

}  // namespace hexatlas::quality
