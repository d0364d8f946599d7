#include "meshing/hexahedrize/placing.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "enum/cells/cube.hpp"
#include "enum/core/checks.hpp"
#include "realize/untangle/koebe.hpp"

namespace hexatlas::hexahedrize {

void place(mesh::HexMesh& mesh, std::vector<std::uint8_t> is_free,
           const untangle::Options& options) {
  untangle::Mesh given{{}, mesh.hexahedra, std::move(is_free)};
  for (const mesh::Point& p : mesh.points) given.points.push_back({p.x, p.y, p.z});
  const std::vector<exact::Point3> placed = untangle::untangled(given, options);
  for (std::size_t v = 0; v < placed.size(); ++v)
    mesh.points[v] = {placed[v].x, placed[v].y, placed[v].z};
}

void place(mesh::HexMesh& mesh, std::size_t first_free, const untangle::Options& options) {
  core::expects(first_free <= mesh.points.size(), "place: more fixed points than points");
  std::vector<std::uint8_t> is_free(mesh.points.size(), 1);
  std::fill_n(is_free.begin(), first_free, std::uint8_t{0});
  place(mesh, std::move(is_free), options);
}

std::vector<std::uint8_t> points_of_cells(const mesh::HexMesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.points.size(), 0);
  for (const auto& cell : mesh.hexahedra)
    for (const mesh::Index v : cell) is_used[v] = 1;
  return is_used;
}

std::vector<std::uint8_t> interior_points(const mesh::HexMesh& mesh) {
  std::vector<std::array<mesh::Index, 4>> quads;
  quads.reserve(6 * mesh.hexahedra.size());
  for (const auto& cell : mesh.hexahedra)
    for (const auto& facet : cells::kFacetVertices) {
      std::array quad{cell[facet[0]], cell[facet[1]], cell[facet[2]], cell[facet[3]]};
      std::sort(quad.begin(), quad.end());
      quads.push_back(quad);
    }
  std::sort(quads.begin(), quads.end());
  std::vector<std::uint8_t> is_interior = points_of_cells(mesh);
  for (auto first = quads.begin(); first != quads.end();) {
    const auto last = std::upper_bound(first, quads.end(), *first);
    if (last - first != 2)
      for (const mesh::Index v : *first) is_interior[v] = 0;
    first = last;
  }
  return is_interior;
}

mesh::HexMesh placed(const complex::HexComplex& cells, const complex::Quadrangulation& boundary,
                     Boundary kind, const untangle::Options& options) {
  std::vector<complex::BoundaryQuad> quads;
  for (const complex::QuadVertices& quad : boundary.list_of_quads())
    quads.push_back({quad[0], quad[1], quad[2], quad[3]});
  core::expects(complex::has_boundary(cells, quads), "placed: a mesh of another boundary");
  mesh::HexMesh mesh{{}, cells.hexahedra};
  for (const exact::Point3& p : untangle::koebe_polyhedron(boundary))
    mesh.points.push_back({p.x, p.y, p.z});
  const std::size_t first_free = mesh.points.size();
  mesh.points.resize(cells.vertices);
  place(mesh, first_free, options);
  if (kind == Boundary::convex) return mesh;
  untangle::Options further = options;
  further.starts_as_given = true;
  place(mesh, 0, further);
  return mesh;
}

}  // namespace hexatlas::hexahedrize
