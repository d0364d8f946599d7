#include "meshing/hexahedrize/placing.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "enum/core/checks.hpp"
#include "meshing/hexahedrize/round_frame.hpp"
#include "meshing/hexahedrize/sides.hpp"
#include "meshing/quality/report.hpp"
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

void place_in_a_frame(mesh::HexMesh& mesh, std::size_t first_free,
                      const untangle::Options& options) {
  constexpr double kSkew = 2;  // of a body nearly four times as long as it is wide
  place(mesh, first_free, options);
  const std::vector<std::uint8_t> is_used = points_of_cells(mesh);
  std::vector<mesh::Point> fixed;
  for (std::size_t v = 0; v < first_free; ++v)
    if (is_used[v] != 0) fixed.push_back(mesh.points[v]);
  const auto frame = RoundFrame::of(fixed);
  if (!frame || frame->skewness() < kSkew) return;
  const quality::Report here = quality::report(mesh);
  if (here.valid == here.cells) return;
  mesh::HexMesh other = mesh;
  for (mesh::Point& p : other.points) p = frame->into(p);
  place(other, first_free, options);
  for (mesh::Point& p : other.points) p = frame->back(p);
  std::copy_n(mesh.points.begin(), first_free, other.points.begin());
  if (!std::all_of(other.points.begin(), other.points.end(), mesh::is_finite)) return;
  const quality::Report there = quality::report(other);
  if (std::tuple(there.valid, here.inverted) > std::tuple(here.valid, there.inverted))
    mesh = std::move(other);
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
