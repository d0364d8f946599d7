#include "meshing/quality/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "enum/core/checks.hpp"

namespace hexatlas::quality {
namespace {

void count(const Verdict& verdict, Report& report) {
  report.valid += verdict.validity == Validity::valid ? 1 : 0;
  report.invalid += verdict.validity == Validity::invalid ? 1 : 0;
  report.undecided += verdict.validity == Validity::undecided ? 1 : 0;
  report.inverted += verdict.inverted ? 1 : 0;
  report.exact_decisions += verdict.exact ? 1 : 0;
}

std::size_t bin_of(double shape) {
  constexpr double kBins = static_cast<double>(kHistogramBins);
  return static_cast<std::size_t>(std::clamp(std::floor(kBins * shape), 0.0, kBins - 1));
}

}  // namespace

Corners corners_of(const mesh::HexMesh& mesh, const std::array<mesh::Index, 8>& hexahedron) {
  Corners corners{};
  std::transform(hexahedron.begin(), hexahedron.end(), corners.begin(), [&mesh](mesh::Index i) {
    core::expects(i < mesh.points.size(), "quality: index of a point out of range");
    return mesh.points[i];
  });
  return corners;
}

Report report(const mesh::HexMesh& mesh) {
  Report result;
  result.hexahedra = mesh.hexahedra.size();
  if (mesh.hexahedra.empty()) return result;
  result.min_scaled_jacobian = 1;
  double sum = 0;
  for (const auto& hexahedron : mesh.hexahedra) {
    const Corners corners = corners_of(mesh, hexahedron);
    count(verdict_of_hexahedron(corners), result);
    const double shape = scaled_jacobian(corners);
    result.min_scaled_jacobian = std::min(result.min_scaled_jacobian, shape);
    sum += shape;
    ++result.histogram[bin_of(shape)];
  }
  result.mean_scaled_jacobian = sum / static_cast<double>(result.hexahedra);
  return result;
}

}  // namespace hexatlas::quality
