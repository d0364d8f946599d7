#include "meshing/hexahedrize/hexahedrize.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "enum/canon/code.hpp"
#include "enum/cells/cube.hpp"
#include "enum/complex/facets.hpp"
#include "enum/complex/hex_complex.hpp"
#include "enum/complex/quad_surface.hpp"
#include "enum/complex/quadrangulation.hpp"
#include "enum/core/checks.hpp"
#include "meshing/hexahedrize/smoothing.hpp"

namespace hexatlas::hexahedrize {
namespace {

using complex::BoundaryQuad;
using complex::QuadSphere;
using mesh::Point;

/// Whether the surface encloses a negative volume, that is, faces inwards. Coordinates are
/// scaled first so that nothing overflows; a volume too small to have a clear sign counts as
/// positive.
bool faces_inwards(const QuadSphere& sphere, const std::vector<Point>& points) {
  double size = 0;
  for (const auto p : sphere.point_of)
    size = std::max({size, std::abs(points[p].x), std::abs(points[p].y), std::abs(points[p].z)});
  if (size == 0) return false;
  const Point origin = points[sphere.point_of.front()];
  const auto at = [&](complex::VertexId v) {
    const Point& p = points[sphere.point_of[v]];
    return Point{p.x / size - origin.x / size, p.y / size - origin.y / size,
                 p.z / size - origin.z / size};
  };
  const auto volume = [](const Point& a, const Point& b, const Point& c) {
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  };
  double total = 0;
  double magnitude = 0;
  for (const auto& quad : sphere.quads) {
    const std::array<Point, 4> p{at(quad[0]), at(quad[1]), at(quad[2]), at(quad[3])};
    // Both ways to cut the quad, since it need not be planar.
    for (const auto& [a, b, c] :
         {std::array{0, 1, 2}, std::array{0, 2, 3}, std::array{1, 2, 3}, std::array{1, 3, 0}}) {
      const double v = volume(p[a], p[b], p[c]);
      total += v;
      magnitude += std::abs(v);
    }
  }
  return total < -1e-12 * magnitude;
}

void turn_over(QuadSphere& sphere) {
  for (auto& quad : sphere.quads) std::swap(quad[1], quad[3]);
}

/// The table's mesh in the sphere's own vertices: canonical label c is vertex_of[c].
complex::HexComplex carried_over(complex::HexComplex mesh, const canon::CanonicalForm& form,
                                 std::size_t boundary_vertices) {
  std::vector<complex::VertexId> vertex(mesh.vertices);
  for (std::uint32_t v = 0; v < mesh.vertices; ++v) vertex[v] = v;
  for (std::uint32_t v = 0; v < boundary_vertices; ++v) vertex[form.label[v]] = v;
  for (auto& cell : mesh.hexahedra) {
    for (auto& v : cell) v = vertex[v];
    if (form.is_mirrored) cells::exchange_axes(cell);  // a mirror image, right-handed again
  }
  return mesh;
}

void ensure_boundary(const complex::HexComplex& mesh, const QuadSphere& sphere) {
  std::vector<BoundaryQuad> got = complex::boundary_of(mesh);
  std::vector<BoundaryQuad> wanted = sphere.quads;
  for (auto* quads : {&got, &wanted}) {
    std::transform(quads->begin(), quads->end(), quads->begin(), complex::from_least);
    std::sort(quads->begin(), quads->end());
  }
  core::ensures(got == wanted, "the mesh from the table has the boundary asked for");
}

Hexahedrized with_coordinates(const complex::HexComplex& cells, const QuadSphere& sphere,
                              const std::vector<Point>& points) {
  Hexahedrized result;
  result.interior_vertices = cells.vertices - sphere.vertices();
  result.mesh.points = points;
  result.mesh.points.resize(points.size() + result.interior_vertices);
  const auto point_of = [&](complex::VertexId v) {
    return v < sphere.vertices() ? sphere.point_of[v]
                                 : static_cast<mesh::Index>(points.size() + v - sphere.vertices());
  };
  for (auto cell : cells.hexahedra) {
    std::transform(cell.begin(), cell.end(), cell.begin(), point_of);
    result.mesh.hexahedra.push_back(cell);
  }
  smooth(result.mesh, points.size());
  return result;
}

}  // namespace

QuadSphere sphere_of(const mesh::SurfaceMesh& surface, const std::string& file) {
  auto result = complex::sphere_of(surface.quads, surface.points.size());
  if (const auto* law = std::get_if<complex::BrokenLaw>(&result)) {
    const bool has_line = law->cell && *law->cell < surface.quad_line.size();
    // A law broken at a quad names points; formats differ in the number of the first one.
    throw core::InvalidInput(file, has_line ? surface.quad_line[*law->cell] : 0,
                             law->reason + (law->cell ? " (points counted from 0)" : ""));
  }
  return std::get<QuadSphere>(std::move(result));
}

std::optional<complex::Quadrangulation> small_form(const QuadSphere& sphere) {
  if (sphere.quads.size() > complex::kMaxQuads) return std::nullopt;
  std::vector<complex::QuadVertices> quads;
  for (const auto& quad : sphere.quads) {
    complex::QuadVertices small{};
    std::transform(quad.begin(), quad.end(), small.begin(),
                   [](complex::VertexId v) { return static_cast<complex::Vertex>(v); });
    quads.push_back(small);
  }
  return complex::Quadrangulation::from_quads(quads);
}

Answer hexahedrize(const mesh::SurfaceMesh& surface, const format::Table& table,
                   const std::string& file) {
  QuadSphere sphere = sphere_of(surface, file);
  Answer answer;
  answer.notes = {sphere.unused_points, sphere.reversed, faces_inwards(sphere, surface.points)};
  if (answer.notes.turned_outwards) turn_over(sphere);
  if (auto reason = complex::reason_against_filling(sphere)) {
    answer.outcome = Impossible{*std::move(reason)};
    return answer;
  }
  const auto boundary = small_form(sphere);
  if (!boundary) {
    answer.outcome = NotInTable{sphere.quads.size(), {}};
    return answer;
  }
  const canon::CanonicalForm form = canon::canonical_form(*boundary);
  const auto ordinal = table.find(form.code);
  if (!ordinal) {
    answer.outcome = NotInTable{sphere.quads.size(), canon::to_text(form.code)};
    return answer;
  }
  const complex::HexComplex cells = carried_over(table.mesh(*ordinal), form, sphere.vertices());
  ensure_boundary(cells, sphere);
  Hexahedrized made = with_coordinates(cells, sphere, surface.points);
  made.code = canon::to_text(form.code);
  answer.outcome = std::move(made);
  return answer;
}

}  // namespace hexatlas::hexahedrize
