#pragma once
/// \file
/// The quality of a mesh in a few numbers.
///
/// Requires. Indices below the number of points and finite coordinates, else
/// PreconditionViolated. Cost: linear; about a microsecond for each hexahedron that double
/// precision decides, fifty and more for each of the others, which are counted.

#include <array>
#include <cstddef>

#include "meshing/mesh/mesh.hpp"
#include "meshing/quality/hexahedron.hpp"

namespace hexatlas::quality {

inline constexpr std::size_t kHistogramBins = 10;

/// valid + invalid + undecided == hexahedra; the words are those of hexahedron.hpp.
struct Report {
  std::size_t hexahedra = 0;
  std::size_t valid = 0;
  std::size_t invalid = 0;
  std::size_t undecided = 0;
  std::size_t inverted = 0;         ///< some corner determinant <= 0, decided exactly
  double min_scaled_jacobian = 0;   ///< 0 for a mesh without hexahedra
  double mean_scaled_jacobian = 0;  ///< 0 for a mesh without hexahedra
  /// Hexahedra by scaled Jacobian s: bin i has those with i <= 10 s < i + 1, the first also those
  /// with s < 0, the last also those with s = 1.
  std::array<std::size_t, kHistogramBins> histogram{};
  std::size_t exact_decisions = 0;  ///< hexahedra that double precision could not decide
};

/// The points of one hexahedron of the mesh.
[[nodiscard]] Corners corners_of(const mesh::HexMesh& mesh,
                                 const std::array<mesh::Index, 8>& hexahedron);

[[nodiscard]] Report report(const mesh::HexMesh& mesh);

}  // namespace hexatlas::quality
