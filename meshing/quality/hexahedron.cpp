#include "meshing/quality/hexahedron.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>

#include "meshing/quality/edge.hpp"
#include "meshing/quality/verdict.hpp"

namespace hexatlas::quality {

Verdict verdict_of_hexahedron(const Corners& corners) {
  const exact::Hexahedron hexahedron = exact_points(corners);
  std::optional<exact::JacobianVerdict> filtered = exact::filtered_jacobian_verdict(hexahedron);
  if (!filtered) filtered = exact::subdivided_jacobian_verdict(hexahedron, kSubdivisionDepth);
  return verdict_from(
      filtered ? *filtered : exact::exact_jacobian_verdict(hexahedron, kSubdivisionDepth),
      !filtered.has_value());
}

double scaled_jacobian(const Corners& corners) {
  std::array<std::array<mesh::Point, 8>, 3> edge{};  // by axis and corner, along the axis
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t v = 0; v < corners.size(); ++v) {
      const std::size_t bit = std::size_t{1} << k;
      if ((v & bit) != 0) continue;
      edge[k][v] = direction(corners[v], corners[v | bit]);
      edge[k][v | bit] = edge[k][v];
    }
  double least = 1;
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const double value = determinant(edge[0][v], edge[1][v], edge[2][v]);
    // At every other corner the edges away from it are read backwards.
    const std::size_t turn = static_cast<std::size_t>(std::popcount(v)) % 2;
    least = std::min(least, signed_measure(value, value, corners[v], corners[v ^ (1 + turn)],
                                           corners[v ^ (2 - turn)], corners[v ^ 4U]));
  }
  return least;
}

bool exceeds(const Corners& corners, double scaled_jacobian, double threshold) {
  constexpr double kError = 0x1p-44;  // four times that of a determinant of directions
  if (std::abs(scaled_jacobian - threshold) > kError) return scaled_jacobian > threshold;
  return exact::corners_exceed(exact_points(corners), threshold);
}

}  // namespace hexatlas::quality
