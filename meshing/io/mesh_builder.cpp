#include "meshing/io/mesh_builder.hpp"

#include <algorithm>
#include <utility>

#include "enum/core/errors.hpp"

namespace hexatlas::io {

using mesh::Index;

namespace {

bool is_a_quad(const CellType& type) {
  return type.shape == CellShape::quad || type.shape == CellShape::pixel;
}
bool is_a_triangle(const CellType& type) {
  return type.shape == CellShape::surface && type.vertices == 3;
}
bool is_a_facet(const CellType& type) {
  return is_a_quad(type) || type.shape == CellShape::surface;
}

}  // namespace

MeshBuilder::MeshBuilder(Wanted wanted, std::string file, int index_base)
    : wanted_(wanted), file_(std::move(file)), index_base_(index_base) {}

void MeshBuilder::fail(std::size_t line, const std::string& reason) const {
  throw core::InvalidInput(file_, line, reason);
}

void MeshBuilder::reserve_points(std::size_t count) { points_.reserve(points_.size() + count); }

void MeshBuilder::reserve_cells(const CellType& type, std::size_t count) {
  if (wanted_ == Wanted::surface && type.shape == CellShape::quad) {
    quads_.reserve(quads_.size() + count);
    quad_line_.reserve(quad_line_.size() + count);
  } else if (wanted_ == Wanted::tetrahedra && type.shape == CellShape::tetrahedron) {
    tetrahedra_.reserve(tetrahedra_.size() + count);
  } else if (wanted_ == Wanted::hexahedra && type.shape == CellShape::hexahedron) {
    hexahedra_.reserve(hexahedra_.size() + count);
  }
}

void MeshBuilder::add_point(const mesh::Point& point, std::size_t line) {
  if (points_.size() >= mesh::kMostPoints) fail(line, "too many points");
  points_.push_back(point);
}

void MeshBuilder::check_vertices(const CellType& type, std::span<const Index> vertices,
                                 std::size_t line) {
  if (type.vertices != 0 && vertices.size() != static_cast<std::size_t>(type.vertices))
    fail(line, std::string(type.name) + " with " + std::to_string(vertices.size()) + " vertices");
  for (const Index vertex : vertices) {
    if (vertex < index_bound_) continue;
    index_bound_ = std::uint64_t{vertex} + 1;
    index_bound_line_ = line;
  }
}

void MeshBuilder::check_distinct(const CellType& type, std::span<const Index> vertices,
                                 std::size_t line) const {
  for (auto vertex = vertices.begin(); vertex != vertices.end(); ++vertex)
    if (std::find(vertices.begin(), vertex, *vertex) != vertex)
      fail(line, std::string(type.name) + " with a repeated vertex");
}

void MeshBuilder::check_kind(const CellType& type, std::size_t line) const {
  const std::string name(type.name);
  if (wanted_ == Wanted::hexahedra) {
    if (type.shape != CellShape::hexahedron && type.shape != CellShape::voxel)
      fail(line, name + "; every cell must be a hexahedron");
    return;
  }
  if (wanted_ == Wanted::tetrahedra) {
    if (type.shape != CellShape::tetrahedron)
      fail(line, name + "; every cell must be a tetrahedron");
    return;
  }
  const bool quads_only = wanted_ == Wanted::surface;
  if (!is_a_facet(type))
    fail(line, name + "; this is a volume mesh, where a surface mesh of " +
                   (quads_only ? "quads" : "triangles and quads") + " is expected");
  if (quads_only && !is_a_quad(type)) fail(line, name + "; every facet must be a quad");
  if (!is_a_quad(type) && !is_a_triangle(type))
    fail(line, name + "; every facet must be a triangle or a quad");
}

void MeshBuilder::add_cell(const CellType& declared, std::span<const Index> vertices,
                           std::size_t line) {
  // A polygon is named by its number of corners; four make it a quad.
  const CellType type = declared.name == "polygon" ? polygon_type(vertices.size()) : declared;
  check_vertices(type, vertices, line);
  const bool is_quad = is_a_quad(type);
  const bool wants_volumes = wanted_ == Wanted::tetrahedra || wanted_ == Wanted::hexahedra;
  if (wanted_ == Wanted::points || type.shape == CellShape::low ||
      (is_a_facet(type) && wants_volumes))
    return;
  check_kind(type, line);
  check_distinct(type, vertices, line);

  if (is_quad) {
    const bool cyclic = type.shape == CellShape::quad;
    const std::array<Index, 4> quad{vertices[0], vertices[1], vertices[cyclic ? 2 : 3],
                                    vertices[cyclic ? 3 : 2]};
    if (wanted_ == Wanted::facets) {
      facets_.push_back({quad, 4, static_cast<std::uint32_t>(line)});
      return;
    }
    quads_.push_back(quad);
    quad_line_.push_back(static_cast<std::uint32_t>(line));
    return;
  }
  if (is_a_triangle(type)) {
    facets_.push_back(
        {{vertices[0], vertices[1], vertices[2], 0}, 3, static_cast<std::uint32_t>(line)});
    return;
  }
  if (type.shape == CellShape::tetrahedron) {
    tetrahedra_.push_back({vertices[0], vertices[1], vertices[2], vertices[3]});
    return;
  }
  std::array<Index, 8>& hexahedron = hexahedra_.emplace_back();
  for (std::size_t i = 0; i < hexahedron.size(); ++i)
    hexahedron[type.shape == CellShape::voxel ? i : kFileCorner[i]] = vertices[i];
}

void MeshBuilder::check_indices() const {
  if (index_bound_ > points_.size())
    fail(index_bound_line_,
         "index " + std::to_string(index_bound_ - 1 + static_cast<std::uint64_t>(index_base_)) +
             " is too large: there are " + std::to_string(points_.size()) + " points");
}

void MeshBuilder::check_complete(bool has_cells, const char* cell) const {
  check_indices();
  if (!has_cells) fail(0, std::string("contains no ") + cell);
}

mesh::SurfaceMesh MeshBuilder::take_surface() {
  check_complete(!quads_.empty(), "quad");
  return {std::move(points_), std::move(quads_), std::move(quad_line_)};
}

mesh::FacetMesh MeshBuilder::take_facets() {
  check_complete(!facets_.empty(), "facet");
  return {std::move(points_), std::move(facets_)};
}

mesh::TetMesh MeshBuilder::take_tetrahedra() {
  check_complete(!tetrahedra_.empty(), "tetrahedron");
  return {std::move(points_), std::move(tetrahedra_)};
}

std::vector<mesh::Point> MeshBuilder::take_points() {
  check_indices();
  return std::move(points_);
}

mesh::HexMesh MeshBuilder::take_hexahedra() {
  check_complete(!hexahedra_.empty(), "hexahedron");
  return {std::move(points_), std::move(hexahedra_)};
}

}  // namespace hexatlas::io
