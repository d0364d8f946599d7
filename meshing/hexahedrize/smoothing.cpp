#include "meshing/hexahedrize/smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace hexatlas::hexahedrize {
namespace {

using mesh::Index;
using mesh::Point;

constexpr int kMaxSweeps = 1000;
constexpr double kTolerance = 1e-6;

/// Neighbours along edges, ascending, of each free point.
std::vector<std::vector<Index>> neighbours_of(const mesh::HexMesh& mesh, std::size_t first_free) {
  std::vector<std::vector<Index>> result(mesh.points.size() - first_free);
  for (const auto& cell : mesh.hexahedra)
    for (unsigned v = 0; v < 8; ++v)
      for (const unsigned axis : {1U, 2U, 4U})
        if (cell[v] >= first_free) result[cell[v] - first_free].push_back(cell[v ^ axis]);
  for (auto& row : result) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
  return result;
}

/// The mean; weighted before it is added up, so that it never overflows.
Point mean_of(const mesh::HexMesh& mesh, const std::vector<Index>& indices) {
  const double weight = 1.0 / static_cast<double>(indices.size());
  Point mean;
  for (const Index i : indices) {
    const Point& p = mesh.points[i];
    mean = {mean.x + weight * p.x, mean.y + weight * p.y, mean.z + weight * p.z};
  }
  return mean;
}

double distance(const Point& a, const Point& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

void smooth(mesh::HexMesh& mesh, std::size_t first_free) {
  if (mesh.points.size() == first_free) return;
  std::vector<Index> fixed;
  for (const auto& cell : mesh.hexahedra)
    for (const Index v : cell)
      if (v < first_free) fixed.push_back(v);
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  const Point centre = mean_of(mesh, fixed);
  double size = 0;
  for (const Index v : fixed) size = std::max(size, distance(mesh.points[v], centre));
  std::fill(mesh.points.begin() + static_cast<std::ptrdiff_t>(first_free), mesh.points.end(),
            centre);

  const auto neighbours = neighbours_of(mesh, first_free);
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    double moved = 0;
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
      const Point target = mean_of(mesh, neighbours[i]);
      moved = std::max(moved, distance(target, mesh.points[first_free + i]));
      mesh.points[first_free + i] = target;
    }
    if (!(moved > kTolerance * size)) break;
  }
}

}  // namespace hexatlas::hexahedrize
