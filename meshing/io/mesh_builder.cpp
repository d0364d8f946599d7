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
  if (is_passed_over(type)) return;
  if (type.shape == CellShape::tetrahedron) {
    tetrahedra_.reserve(tetrahedra_.size() + count);
  } else if (type.shape == CellShape::hexahedron) {
    hexahedra_.reserve(hexahedra_.size() + count);
  } else if (wanted_ == Wanted::surface && type.shape == CellShape::quad) {
    quads_.reserve(quads_.size() + count);
    quad_line_.reserve(quad_line_.size() + count);
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
  if (wanted_ == Wanted::hexahedra || wanted_ == Wanted::hex_model) {
    if (type.shape != CellShape::hexahedron && type.shape != CellShape::voxel && !is_a_quad(type))
      fail(line, name + "; every cell must be a hexahedron");
    return;
  }
  if (wanted_ == Wanted::tetrahedra || wanted_ == Wanted::tet_model) {
    if (type.shape != CellShape::tetrahedron && !is_a_facet(type))
      fail(line, name + "; every cell must be a tetrahedron");
    return;
  }
  if (wanted_ == Wanted::hybrid) {
    if (type.shape == CellShape::volume)
      fail(line, name + "; every cell must be a tetrahedron, hexahedron, prism or pyramid");
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

bool MeshBuilder::is_passed_over(const CellType& type) const {
  switch (wanted_) {
    case Wanted::points:
    case Wanted::weighted_points:
      return true;
    case Wanted::tet_model:
      return type.shape == CellShape::low || (is_a_facet(type) && !is_a_triangle(type));
    case Wanted::hex_model:
      return type.shape == CellShape::low || (is_a_facet(type) && !is_a_quad(type));
    case Wanted::tetrahedra:
    case Wanted::hexahedra:
    case Wanted::hybrid:
      return type.shape == CellShape::low || is_a_facet(type);
    case Wanted::surface:
    case Wanted::facets:
      break;
  }
  return type.shape == CellShape::low;
}

std::uint32_t MeshBuilder::to_reference(std::int64_t reference, std::size_t line) const {
  const auto number = static_cast<std::uint32_t>(reference);
  if (number != reference)
    fail(line, "reference " + std::to_string(reference) + " is not between 0 and 4294967295");
  return number;
}

void MeshBuilder::keep_facet(const CellType& type, std::span<const Index> vertices,
                             std::size_t line, std::optional<std::int64_t> reference) {
  if (wanted_ == Wanted::tet_model) {
    triangles_.push_back({vertices[0], vertices[1], vertices[2]});
    colours_.push_back(to_reference(reference.value_or(0), line));
    return;
  }
  const auto line_number = static_cast<std::uint32_t>(line);
  const std::int64_t colour = reference.value_or(0);
  if (is_a_triangle(type)) {
    facets_.push_back({{vertices[0], vertices[1], vertices[2], 0}, 3, line_number, colour});
    return;
  }
  const bool cyclic = type.shape == CellShape::quad;
  const std::array<Index, 4> quad{vertices[0], vertices[1], vertices[cyclic ? 2 : 3],
                                  vertices[cyclic ? 3 : 2]};
  if (wanted_ == Wanted::facets) {
    facets_.push_back({quad, 4, line_number, colour});
    return;
  }
  quads_.push_back(quad);
  quad_line_.push_back(line_number);
}

void MeshBuilder::keep_volume(const CellType& type, std::span<const Index> vertices,
                              std::size_t line, std::optional<std::int64_t> reference) {
  const auto keep = [&vertices](auto& cells, auto&& corner_at) {
    auto& cell = cells.emplace_back();
    for (std::size_t i = 0; i < cell.size(); ++i) cell[corner_at(i)] = vertices[i];
  };
  const auto as_it_is = [](std::size_t i) { return i; };
  if (wanted_ == Wanted::tet_model && reference) regions_.push_back(to_reference(*reference, line));
  if (wanted_ == Wanted::hex_model && reference)  // only whether two are the same matters
    regions_.push_back(static_cast<std::uint32_t>(*reference));
  switch (type.shape) {
    case CellShape::tetrahedron:
      return keep(tetrahedra_, as_it_is);
    case CellShape::hexahedron:
      return keep(hexahedra_, [](std::size_t i) { return kFileCorner[i]; });
    case CellShape::voxel:
      return keep(hexahedra_, as_it_is);
    case CellShape::prism:
      return keep(prisms_, as_it_is);
    case CellShape::wedge:
      return keep(prisms_, [](std::size_t i) { return kWedgeCorner[i]; });
    case CellShape::pyramid:
      return keep(pyramids_, as_it_is);
    default:
      throw core::PreconditionViolated("keep_volume: the cell is one that is kept");
  }
}

void MeshBuilder::add_cell(const CellType& declared, std::span<const Index> vertices,
                           std::size_t line, std::optional<std::int64_t> reference) {
  // A polygon is named by its number of corners; four make it a quad.
  const CellType type = declared.name == "polygon" ? polygon_type(vertices.size()) : declared;
  check_vertices(type, vertices, line);
  if (is_passed_over(type)) return;
  check_kind(type, line);
  check_distinct(type, vertices, line);
  is_a_facet(type) ? keep_facet(type, vertices, line, reference)
                   : keep_volume(type, vertices, line, reference);
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

mesh::TetModel MeshBuilder::take_tet_model() {
  return {take_tetrahedra(), std::move(regions_), std::move(triangles_), std::move(colours_)};
}

std::vector<mesh::Point> MeshBuilder::take_points() {
  check_indices();
  return std::move(points_);
}

mesh::WeightedPoints MeshBuilder::take_weighted_points() {
  return {std::move(points_), std::move(weights_)};
}

mesh::HexMesh MeshBuilder::take_hexahedra() {
  check_complete(!hexahedra_.empty(), "hexahedron");
  return {std::move(points_), std::move(hexahedra_)};
}

mesh::HexModel MeshBuilder::take_hex_model() {
  return {take_hexahedra(), std::move(regions_), std::move(quads_)};
}

mesh::HybridMesh MeshBuilder::take_hybrid() {
  check_complete(
      !tetrahedra_.empty() || !hexahedra_.empty() || !prisms_.empty() || !pyramids_.empty(),
      "tetrahedron, hexahedron, prism or pyramid");
  return {std::move(points_), std::move(tetrahedra_), std::move(hexahedra_), std::move(prisms_),
          std::move(pyramids_)};
}

}  // namespace hexatlas::io
