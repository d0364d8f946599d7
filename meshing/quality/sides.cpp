#include "meshing/quality/sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "enum/cells/cube.hpp"
#include "meshing/quality/edge.hpp"

namespace hexatlas::quality {
namespace {

using Cycle = std::array<mesh::Index, 4>;

/// A quad as one of its hexahedra has it.
struct Side {
  std::array<mesh::Index, 4> vertices{};  ///< ascending
  Cycle cycle{};                          ///< counter-clockwise from outside, the least first
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

/// Divided by the cube of the greatest extent; 0 if that is 0.
double volume_within(const std::vector<mesh::Point>& points, const std::vector<Cycle>& quads) {
  if (quads.empty()) return 0;
  constexpr double kQuarter = 0.25;  // so that no difference overflows
  const mesh::Point& origin = points[quads[0][0]];
  double extent = 0;
  for (const Cycle& quad : quads)
    for (const mesh::Index v : quad)
      extent = std::max(extent, greatest_component(scaled_difference(origin, points[v], kQuarter)));
  if (extent == 0) return 0;
  double six_volumes = 0;
  for (const Cycle& quad : quads) {
    std::array<mesh::Point, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
      const mesh::Point d = scaled_difference(origin, points[quad[i]], kQuarter);
      p[i] = {d.x / extent, d.y / extent, d.z / extent};
    }
    six_volumes += determinant(p[0], p[1], p[2]) + determinant(p[0], p[2], p[3]);
  }
  return six_volumes / 6;
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
  if (fault) return fault;
  for (const Part& part : parts_of(mesh))
    if (part.boundary_quads == 0)
      return "hexahedron " + std::to_string(part.cells.front()) +
             " is in a part of the mesh that has no boundary";
  return std::nullopt;
}

std::vector<Part> parts_of(const mesh::HexMesh& mesh) {
  std::vector<std::size_t> next(mesh.hexahedra.size());
  std::iota(next.begin(), next.end(), std::size_t{0});
  const auto root = [&next](std::size_t c) {
    while (next[c] != c) c = next[c] = next[next[c]];
    return c;
  };
  for_each_quad(mesh, [&](std::span<const Side> sides) {
    for (const Side& side : sides) {
      const std::size_t a = root(sides[0].cell);
      const std::size_t b = root(side.cell);
      next[std::max(a, b)] = std::min(a, b);
    }
    return true;
  });
  std::vector<Part> parts;
  std::vector<std::size_t> part_of(next.size());
  for (std::size_t c = 0; c < next.size(); ++c) {
    if (root(c) == c) {
      part_of[c] = parts.size();
      parts.emplace_back();
    }
    parts[part_of[root(c)]].cells.push_back(c);
  }
  std::vector<std::vector<Cycle>> boundaries(parts.size());
  for_each_quad(mesh, [&](std::span<const Side> sides) {
    if (sides.size() == 1) boundaries[part_of[root(sides[0].cell)]].push_back(sides[0].cycle);
    return true;
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].boundary_quads = boundaries[i].size();
    parts[i].volume = volume_within(mesh.points, boundaries[i]);
  }
  return parts;
}

}  // namespace hexatlas::quality
