#include "meshing/quality/sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "enum/cells/cube.hpp"
#include "meshing/quality/edge.hpp"

namespace hexatlas::quality {
namespace {

/// A quad as one of its hexahedra has it.
struct Side {
  std::array<mesh::Index, 4> vertices{};  ///< ascending
  std::array<mesh::Index, 4> cycle{};     ///< counter-clockwise from outside, the least first
  std::size_t cell = 0;
};

std::vector<Side> sides_of(const mesh::HexMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(cells::kCubeFacets * mesh.hexahedra.size());
  for (std::size_t c = 0; c < mesh.hexahedra.size(); ++c)
    for (const auto& facet : cells::kFacetVertices) {
      Side side{{}, {}, c};
      for (std::size_t i = 0; i < 4; ++i) side.cycle[i] = mesh.hexahedra[c][facet[i]];
      std::rotate(side.cycle.begin(), std::min_element(side.cycle.begin(), side.cycle.end()),
                  side.cycle.end());
      side.vertices = side.cycle;
      std::sort(side.vertices.begin(), side.vertices.end());
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.cell < b.cell;
  });
  return sides;
}

/// `visit` gets the sides of each quad, until it returns false.
template <class Visit>
void for_each_quad(const mesh::HexMesh& mesh, const Visit& visit) {
  const std::vector<Side> sides = sides_of(mesh);
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].vertices == sides[first].vertices) ++end;
    if (!visit(std::span(sides).subspan(first, end - first))) return;
  }
}

std::string name_of(const Side& side) {
  std::string text;
  for (const mesh::Index v : side.cycle) text += " " + std::to_string(v);
  return "the quad" + text;
}

}  // namespace

std::vector<std::uint8_t> points_of_cells(const mesh::HexMesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.points.size(), 0);
  for (const auto& cell : mesh.hexahedra)
    for (const mesh::Index v : cell) is_used[v] = 1;
  return is_used;
}

std::vector<std::uint8_t> interior_points(const mesh::HexMesh& mesh) {
  std::vector<std::uint8_t> is_interior = points_of_cells(mesh);
  for_each_quad(mesh, [&](std::span<const Side> sides) {
    if (sides.size() != 2)
      for (const mesh::Index v : sides[0].vertices) is_interior[v] = 0;
    return true;
  });
  return is_interior;
}

std::optional<std::string> fault_of_sides(const mesh::HexMesh& mesh) {
  std::optional<std::string> fault;
  for_each_quad(mesh, [&](std::span<const Side> sides) {
    if (sides.size() == 1) return true;
    const std::string both =
        "hexahedra " + std::to_string(sides[0].cell) + " and " + std::to_string(sides[1].cell);
    const std::array reversed{sides[0].cycle[0], sides[0].cycle[3], sides[0].cycle[2],
                              sides[0].cycle[1]};
    if (sides.size() > 2)
      fault = name_of(sides[0]) + " is in " + std::to_string(sides.size()) + " hexahedra";
    else if (sides[0].cycle == sides[1].cycle)
      fault = both + " lie on the same side of " + name_of(sides[0]);
    else if (sides[1].cycle != reversed)
      fault = both + " have the vertices of " + name_of(sides[0]) + " in different cycles";
    return !fault;
  });
  return fault;
}

double enclosed_volume(const mesh::HexMesh& mesh) {
  double six_volumes = 0;
  for_each_quad(mesh, [&](std::span<const Side> sides) {
    if (sides.size() != 1) return true;
    std::array<mesh::Point, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
      const mesh::Point& at = mesh.points[sides[0].cycle[i]];
      const mesh::Point& origin = mesh.points[mesh.hexahedra[0][0]];
      p[i] = {at.x - origin.x, at.y - origin.y, at.z - origin.z};
    }
    six_volumes += determinant(p[0], p[1], p[2]) + determinant(p[0], p[2], p[3]);
    return true;
  });
  return six_volumes / 6;
}

}  // namespace hexatlas::quality
