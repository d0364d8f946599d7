#pragma once
/// \file
/// One writer per format, behind to_text and write_hexahedra (mesh_files.hpp, which states what
/// they promise and require). All write the same thing: points, then lists of cells, each of one
/// type and with the file's order of corners, and the regions of the cells where there are some: as
/// references of MEDIT, entities of Gmsh 4.1, a field `region` of VTK.

#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include "meshing/io/cell_types.hpp"
#include "meshing/io/mesh_files.hpp"
#include "meshing/io/output.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

/// Cells of one type; not empty.
class CellList {
 public:
  template <std::size_t N>
  CellList(const FileCell& cell, std::span<const std::array<mesh::Index, N>> cells,
           std::span<const std::uint32_t> of_regions)
      : type(cell), regions(of_regions), corners_(cells.front().data(), N * cells.size()) {
    static_assert(sizeof(cells.front()) == N * sizeof(mesh::Index));
  }

  FileCell type;
  std::span<const std::uint32_t> regions;  ///< one for each cell, or none at all

  [[nodiscard]] std::size_t size() const { return corners_.size() / corners_each(); }
  [[nodiscard]] std::size_t corners_each() const {
    return static_cast<std::size_t>(type.type.vertices);
  }
  [[nodiscard]] std::span<const mesh::Index> operator[](std::size_t i) const {
    return corners_.subspan(i * corners_each(), corners_each());
  }
  [[nodiscard]] std::span<const mesh::Index> all_corners() const { return corners_; }

 private:
  std::span<const mesh::Index> corners_;
};

struct CellsToWrite {
  std::span<const mesh::Point> points;
  std::vector<CellList> lists;

  template <std::size_t N>
  void add(const FileCell& type, std::span<const std::array<mesh::Index, N>> cells,
           std::span<const std::uint32_t> regions = {}) {
    if (!cells.empty()) lists.emplace_back(type, cells, regions);
  }
  [[nodiscard]] std::size_t cell_count() const;
  /// Whether each cell has a region.
  [[nodiscard]] bool has_regions() const { return !lists.empty() && !lists[0].regions.empty(); }
};

/// How the arrays of a .vtu file are written: small, or fast.
enum class VtuArrays : std::uint8_t {
  zlib_base64,   ///< compressed, in base64
  appended_raw,  ///< as they are, after the XML part
};

/// Requires: triangles and quads only.
void write_obj(const CellsToWrite& cells, Output& out);
void write_off(const CellsToWrite& cells, Output& out);

void write_medit(const CellsToWrite& cells, Output& out);
void write_vtk(const CellsToWrite& cells, Output& out);
void write_vtu(const CellsToWrite& cells, VtuArrays arrays, Output& out);
void write_gmsh(const CellsToWrite& cells, GmshVersion version, Output& out);

/// Requires: tetrahedra only.
void write_hxtet(const CellsToWrite& cells, Output& out);

}  // namespace hexatlas::io
