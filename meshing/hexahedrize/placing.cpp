#include "meshing/hexahedrize/placing.hpp"

#include <algorithm>
#include <vector>

#include "enum/core/checks.hpp"
#include "realize/untangle/koebe.hpp"

namespace hexatlas::hexahedrize {

void place(mesh::HexMesh& mesh, std::size_t first_free, const untangle::Options& options) {
  core::expects(first_free <= mesh.points.size(), "place: more fixed points than points");
  untangle::Mesh given{{}, mesh.hexahedra, std::vector<std::uint8_t>(mesh.points.size(), 1)};
  for (const mesh::Point& p : mesh.points) given.points.push_back({p.x, p.y, p.z});
  std::fill_n(given.is_free.begin(), first_free, std::uint8_t{0});
  const std::vector<exact::Point3> placed = untangle::untangled(given, options);
  for (std::size_t v = first_free; v < placed.size(); ++v)
    mesh.points[v] = {placed[v].x, placed[v].y, placed[v].z};
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
