#include "meshing/io/mesh_builder.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "enum/core/errors.hpp"

namespace hexatlas::io {

using mesh::Index;

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
  } else if (wanted_ == Wanted::hexahedra && type.shape == CellShape::hexahedron) {
    hexahedra_.reserve(hexahedra_.size() + count);
  }
}

void MeshBuilder::add_point(const mesh::Point& point, std::size_t line) {
  if (points_.size() >= std::numeric_limits<Index>::max()) fail(line, "too many points");
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

void MeshBuilder::add_cell(const CellType& declared, std::span<const Index> vertices,
                           std::size_t line) {
  // A polygon is named by its number of corners; four make it a quad.
  const CellType type = declared.name == "polygon" ? polygon_type(vertices.size()) : declared;
  check_vertices(type, vertices, line);
  const bool is_quad = type.shape == CellShape::quad || type.shape == CellShape::pixel;
  const bool is_surface = is_quad || type.shape == CellShape::surface;
  const bool is_hexahedron = type.shape == CellShape::hexahedron || type.shape == CellShape::voxel;
  if (type.shape == CellShape::low || (is_surface && wanted_ == Wanted::hexahedra)) return;
  if (wanted_ == Wanted::surface && !is_surface)
    fail(line, std::string(type.name) +
                   "; this is a volume mesh, where a surface mesh of quads is expected");
  if (wanted_ == Wanted::surface && !is_quad)
    fail(line, std::string(type.name) + "; every facet must be a quad");
  if (wanted_ == Wanted::hexahedra && !is_hexahedron)
    fail(line, std::string(type.name) + "; every cell must be a hexahedron");
  check_distinct(type, vertices, line);

  if (is_quad) {
    const bool cyclic = type.shape == CellShape::quad;
    quads_.push_back(
        {vertices[0], vertices[1], vertices[cyclic ? 2 : 3], vertices[cyclic ? 3 : 2]});
    quad_line_.push_back(static_cast<std::uint32_t>(line));
    return;
  }
  std::array<Index, 8>& hexahedron = hexahedra_.emplace_back();
  for (std::size_t i = 0; i < hexahedron.size(); ++i)
    hexahedron[type.shape == CellShape::voxel ? i : kFileCorner[i]] = vertices[i];
}

void MeshBuilder::check_complete(bool has_cells, const char* cell) const {
  if (index_bound_ > points_.size())
    fail(index_bound_line_,
         "index " + std::to_string(index_bound_ - 1 + static_cast<std::uint64_t>(index_base_)) +
             " is too large: there are " + std::to_string(points_.size()) + " points");
  if (!has_cells) fail(0, std::string("contains no ") + cell);
}

mesh::SurfaceMesh MeshBuilder::take_surface() {
  check_complete(!quads_.empty(), "quad");
  return {std::move(points_), std::move(quads_), std::move(quad_line_)};
}

mesh::HexMesh MeshBuilder::take_hexahedra() {
  check_complete(!hexahedra_.empty(), "hexahedron");
  return {std::move(points_), std::move(hexahedra_)};
}

}  // namespace hexatlas::io
