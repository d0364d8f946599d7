#include "meshing/hexahedrize/sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>

#include "enum/complex/facets.hpp"
#include "enum/complex/union_find.hpp"
#include "meshing/quality/edge.hpp"
#include "realize/exact/volume.hpp"

namespace hexatlas::hexahedrize {
namespace {

using Cycle = complex::BoundaryQuad;
using complex::Facet;

std::vector<Facet> facets_of(const mesh::HexMesh& mesh) {
  return complex::sorted_facets({static_cast<std::uint32_t>(mesh.points.size()), mesh.hexahedra});
}

/// `visit` gets the facets of each quad, until it returns false.
template <class Visit>
void for_each_quad(const std::vector<Facet>& facets, const Visit& visit) {
  for (std::size_t first = 0, end = 0; first < facets.size(); first = end) {
    while (end < facets.size() && facets[end].key == facets[first].key) ++end;
    if (!visit(std::span(facets).subspan(first, end - first))) return;
  }
}

using Corners = std::array<mesh::Point, 4>;

/// In double precision; zero if the volume may be smaller than the rounding.
exact::Sign rough_sign_of_volume(std::span<const Corners> quads) {
  constexpr double kQuarter = 0.25;  // so that no difference overflows
  if (quads.empty()) return exact::Sign::zero;
  const mesh::Point& origin = quads[0][0];
  double extent = 0;
  for (const Corners& quad : quads)
    for (const mesh::Point& corner : quad)
      extent = std::max(extent, quality::greatest_component(
                                    quality::scaled_difference(origin, corner, kQuarter)));
  if (extent == 0) return exact::Sign::zero;
  double sum = 0;
  for (const Corners& quad : quads) {
    Corners p;
    for (std::size_t i = 0; i < 4; ++i) {
      const mesh::Point d = quality::scaled_difference(origin, quad[i], kQuarter);
      p[i] = {d.x / extent, d.y / extent, d.z / extent};
    }
    for (std::size_t i = 0; i < 4; ++i)
      sum += quality::determinant(p[i], p[(i + 1) % 4], p[(i + 2) % 4]);
  }
  // Four determinants of numbers up to 1, each at most 6 and wrong by at most 40 units in the last
  // place of 6, and as many additions to a sum of at most 24 for each quad.
  constexpr double kUnit = 0x1p-53;
  const auto count = static_cast<double>(quads.size());
  const double rounding = 4 * count * (240 + 24 * count) * kUnit;
  return sum > rounding    ? exact::Sign::positive
         : sum < -rounding ? exact::Sign::negative
                           : exact::Sign::zero;
}

exact::Sign sign_of_volume_within(const std::vector<mesh::Point>& points,
                                  const std::vector<Cycle>& cycles) {
  std::vector<Corners> quads(cycles.size());
  for (std::size_t q = 0; q < cycles.size(); ++q)
    for (std::size_t i = 0; i < 4; ++i) quads[q][i] = points[cycles[q][i]];
  return sign_of_volume(quads);
}

std::string name_of(const Facet& side) {
  std::string text;
  for (const mesh::Index v : complex::from_least(side.cycle)) text += " " + std::to_string(v);
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
  for_each_quad(facets_of(mesh), [&](std::span<const Facet> sides) {
    if (sides.size() != 2)
      for (const mesh::Index v : sides[0].key) is_interior[v] = 0;
    return true;
  });
  return is_interior;
}

std::vector<std::uint8_t> points_of_interfaces(const mesh::HexModel& model) {
  std::vector<std::array<mesh::Index, 4>> listed = model.quads;
  for (auto& quad : listed) std::sort(quad.begin(), quad.end());
  std::sort(listed.begin(), listed.end());
  std::vector<std::uint8_t> is_on(model.mesh.points.size(), 0);
  for_each_quad(facets_of(model.mesh), [&](std::span<const Facet> sides) {
    if (sides.size() != 2) return true;
    const bool is_between =
        !model.regions.empty() && model.regions[sides[0].cell] != model.regions[sides[1].cell];
    if (is_between || std::binary_search(listed.begin(), listed.end(), sides[0].key))
      for (const mesh::Index v : sides[0].key) is_on[v] = 1;
    return true;
  });
  return is_on;
}

std::optional<std::string> fault_of_sides(const mesh::HexMesh& mesh) {
  std::optional<std::string> fault;
  for_each_quad(facets_of(mesh), [&](std::span<const Facet> sides) {
    if (sides.size() == 1) return true;
    const std::string both =
        "hexahedra " + std::to_string(sides[0].cell) + " and " + std::to_string(sides[1].cell);
    if (sides.size() > 2)
      fault = name_of(sides[0]) + " is in " + std::to_string(sides.size()) + " hexahedra";
    else if (complex::from_least(sides[0].cycle) == complex::from_least(sides[1].cycle))
      fault = both + " lie on the same side of " + name_of(sides[0]);
    else if (!complex::are_opposite(sides[0].cycle, sides[1].cycle))
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

exact::Sign sign_of_volume(std::span<const std::array<mesh::Point, 4>> quads) {
  const exact::Sign rough = rough_sign_of_volume(quads);
  if (rough != exact::Sign::zero) return rough;
  std::vector<std::array<exact::Point3, 3>> triangles;
  triangles.reserve(4 * quads.size());
  for (const auto& quad : quads)
    for (std::size_t i = 0; i < 4; ++i) {
      auto& triangle = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const mesh::Point& p = quad[(i + k) % 4];
        triangle[k] = {p.x, p.y, p.z};
      }
    }
  return exact::sign_of_volume(triangles);
}

std::vector<Part> parts_of(const mesh::HexMesh& mesh) {
  const std::vector<Facet> facets = facets_of(mesh);
  const std::size_t count = mesh.hexahedra.size();
  complex::UnionFind joined(count);
  for_each_quad(facets, [&](std::span<const Facet> sides) {
    for (const Facet& side : sides) joined.unite(sides[0].cell, side.cell);
    return true;
  });
  std::vector<Part> parts;
  std::map<std::size_t, std::size_t> part_of;  // by representatives
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t part = part_of.try_emplace(joined.find(c), parts.size()).first->second;
    if (part == parts.size()) parts.emplace_back();
    parts[part].cells.push_back(c);
  }
  std::vector<std::vector<Cycle>> boundaries(parts.size());
  for_each_quad(facets, [&](std::span<const Facet> sides) {
    if (sides.size() == 1)
      boundaries[part_of.at(joined.find(sides[0].cell))].push_back(sides[0].cycle);
    return true;
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].boundary_quads = boundaries[i].size();
    parts[i].side = sign_of_volume_within(mesh.points, boundaries[i]);
  }
  return parts;
}

}  // namespace hexatlas::hexahedrize
