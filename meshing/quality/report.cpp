#include "meshing/quality/report.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshing/quality/volume.hpp"

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

/// `judge(corners, verdicts)` fills a verdict for each of the corners.
template <std::size_t kCount, class Judge>
Report report_of(std::span<const mesh::Point> points,
                 const std::vector<std::array<mesh::Index, kCount>>& cells, const Judge& judge) {
  constexpr std::size_t kBatch = 256;
  Report result;
  result.cells = cells.size();
  if (cells.empty()) return result;
  result.min_scaled_jacobian = 1;
  double sum = 0;
  std::vector<std::array<mesh::Point, kCount>> corners;
  std::vector<Verdict> verdicts;
  for (std::size_t first = 0; first < cells.size(); first += kBatch) {
    corners.clear();
    for (std::size_t i = first; i < std::min(first + kBatch, cells.size()); ++i)
      corners.push_back(corners_of(points, cells[i]));
    verdicts.resize(corners.size());
    judge(std::span<const std::array<mesh::Point, kCount>>(corners), std::span<Verdict>(verdicts));
    for (const Verdict& verdict : verdicts) count(verdict, result);
    for (const auto& cell : corners) {
      const double shape = scaled_jacobian(cell);
      result.min_scaled_jacobian = std::min(result.min_scaled_jacobian, shape);
      sum += shape;
      ++result.histogram[bin_of(shape)];
      result.volume += volume(cell);
    }
  }
  result.mean_scaled_jacobian = sum / static_cast<double>(result.cells);
  return result;
}

/// A judge of many from a judge of one.
template <class Judge>
auto one_by_one(const Judge& judge) {
  return [judge](const auto& corners, std::span<Verdict> verdicts) {
    std::transform(corners.begin(), corners.end(), verdicts.begin(), judge);
  };
}

}  // namespace

Report report(const mesh::HexMesh& mesh) {
  return report_of(mesh.points, mesh.hexahedra, verdicts_of_hexahedra);
}

HybridReport report(const mesh::HybridMesh& mesh) {
  return {report_of(mesh.points, mesh.tetrahedra, one_by_one(verdict_of_tetrahedron)),
          report_of(mesh.points, mesh.hexahedra, verdicts_of_hexahedra),
          report_of(mesh.points, mesh.prisms, one_by_one(verdict_of_prism)),
          report_of(mesh.points, mesh.pyramids, one_by_one(verdict_of_pyramid))};
}

}  // namespace hexatlas::quality
