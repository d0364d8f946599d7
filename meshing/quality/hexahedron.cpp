#include "meshing/quality/hexahedron.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>

#include "enum/core/checks.hpp"
#include "meshing/quality/edge.hpp"
#include "meshing/quality/verdict.hpp"

namespace hexatlas::quality {
namespace {

/// The first verdict, or that by subdivision, in double precision if this suffices.
Verdict verdict_after(std::optional<exact::JacobianVerdict> verdict,
                      const exact::Hexahedron& hexahedron) {
  if (!verdict) verdict = exact::subdivided_jacobian_verdict(hexahedron, kSubdivisionDepth);
  if (verdict) return verdict_from(*verdict, false);
  return verdict_from(exact::exact_jacobian_verdict(hexahedron, kSubdivisionDepth), true);
}

}  // namespace

Verdict verdict_of_hexahedron(const Corners& corners) {
  Verdict verdict;
  verdicts_of_hexahedra({&corners, 1}, {&verdict, 1});
  return verdict;
}

void verdicts_of_hexahedra(std::span<const Corners> hexahedra, std::span<Verdict> verdicts) {
  core::expects(hexahedra.size() == verdicts.size(), "quality: a verdict for each hexahedron");
  constexpr std::size_t kBatch = 32;
  std::array<exact::Hexahedron, kBatch> batch{};
  std::array<std::optional<exact::JacobianVerdict>, kBatch> filtered;
  for (std::size_t first = 0; first < hexahedra.size(); first += kBatch) {
    const std::size_t count = std::min(kBatch, hexahedra.size() - first);
    for (std::size_t i = 0; i < count; ++i) batch[i] = exact_points(hexahedra[first + i]);
    exact::filtered_jacobian_verdicts({batch.data(), count}, {filtered.data(), count});
    for (std::size_t i = 0; i < count; ++i)
      verdicts[first + i] = verdict_after(filtered[i], batch[i]);
  }
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
