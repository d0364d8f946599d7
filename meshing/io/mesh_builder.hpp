#pragma once
/// \file
/// The mesh while a reader fills it: decides which cells are kept, ignored or refused, so that
/// all formats agree. Points may come after the cells that use them; the upper bound of the
/// indices is therefore checked at the end.
///
/// Errors: InvalidInput at the line of the cell.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshing/io/cell_types.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

enum class Wanted : std::uint8_t {
  points,
  weighted_points,
  surface,
  facets,
  tetrahedra,
  tet_model,  ///< tetrahedra, triangles and their references
  hexahedra,
  hex_model,  ///< hexahedra, their references and quads
  hybrid,  ///< tetrahedra, hexahedra, prisms and pyramids
};

class MeshBuilder {
 public:
  MeshBuilder(Wanted wanted, std::string file, int index_base);

  /// Memory for this many further points or wanted cells. Requires: a count checked by the reader.
  void reserve_points(std::size_t count);
  void reserve_cells(const CellType& type, std::size_t count);

  void add_point(const mesh::Point& point, std::size_t line);
  /// Of the last point. Where weights are wanted, each point has one.
  void add_weight(double weight) { weights_.push_back(weight); }

  /// Keeps, ignores or refuses the cell; indices count from 0. `reference`: of what the cell is a
  /// part, where the format says so for every cell.
  void add_cell(const CellType& declared, std::span<const mesh::Index> vertices, std::size_t line,
                std::optional<std::int64_t> reference = {});

  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] Wanted wanted() const { return wanted_; }

  /// The mesh. Fails if an index is above the last point, or if there is no cell.
  [[nodiscard]] mesh::SurfaceMesh take_surface();
  [[nodiscard]] mesh::FacetMesh take_facets();
  [[nodiscard]] mesh::TetMesh take_tetrahedra();
  [[nodiscard]] mesh::TetModel take_tet_model();
  [[nodiscard]] mesh::HexMesh take_hexahedra();
  [[nodiscard]] mesh::HexModel take_hex_model();
  [[nodiscard]] mesh::HybridMesh take_hybrid();

  /// The points, also if there are none.
  [[nodiscard]] std::vector<mesh::Point> take_points();
  [[nodiscard]] mesh::WeightedPoints take_weighted_points();

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const;
  void check_vertices(const CellType& type, std::span<const mesh::Index> vertices,
                      std::size_t line);
  void check_distinct(const CellType& type, std::span<const mesh::Index> vertices,
                      std::size_t line) const;
  void check_kind(const CellType& type, std::size_t line) const;
  [[nodiscard]] bool is_passed_over(const CellType& type) const;
  void keep_facet(const CellType& type, std::span<const mesh::Index> vertices, std::size_t line,
                  std::optional<std::int64_t> reference);
  void keep_volume(const CellType& type, std::span<const mesh::Index> vertices, std::size_t line,
                   std::optional<std::int64_t> reference);
  [[nodiscard]] std::uint32_t to_reference(std::int64_t reference, std::size_t line) const;
  void check_indices() const;
  void check_complete(bool has_cells, const char* cell) const;

  Wanted wanted_;
  std::string file_;
  int index_base_;
  std::vector<mesh::Point> points_;
  std::vector<double> weights_;  ///< of the points
  std::vector<std::array<mesh::Index, 4>> quads_;
  std::vector<std::uint32_t> quad_line_;
  std::vector<mesh::Facet> facets_;
  std::vector<std::array<mesh::Index, 4>> tetrahedra_;
  std::vector<std::uint32_t> regions_;  ///< of the cells of a model
  std::vector<std::array<mesh::Index, 3>> triangles_;
  std::vector<std::uint32_t> colours_;  ///< of the triangles
  std::vector<std::array<mesh::Index, 8>> hexahedra_;
  std::vector<mesh::Prism> prisms_;
  std::vector<mesh::Pyramid> pyramids_;
  std::uint64_t index_bound_ = 0;     ///< least number of points that the cells seen need
  std::size_t index_bound_line_ = 0;  ///< the line that needs them
};

}  // namespace hexatlas::io
