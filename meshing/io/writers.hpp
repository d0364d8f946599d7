#pragma once
/// \file
/// One writer per format, behind to_text (mesh_files.hpp, which states what they promise and
/// require). All write the same thing: points, quads, hexahedra, the latter in the file's order of
/// corners.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "meshing/io/mesh_files.hpp"
#include "meshing/mesh/mesh.hpp"

namespace hexatlas::io {

struct CellsToWrite {
  std::span<const mesh::Point> points;
  std::span<const std::array<mesh::Index, 4>> quads;
  std::span<const std::array<mesh::Index, 8>> hexahedra;  ///< in the file's order
};

/// Requires: no hexahedra.
[[nodiscard]] std::string write_obj(const CellsToWrite& cells);
[[nodiscard]] std::string write_off(const CellsToWrite& cells);

[[nodiscard]] std::string write_medit(const CellsToWrite& cells);
[[nodiscard]] std::string write_vtk(const CellsToWrite& cells);
[[nodiscard]] std::string write_vtu(const CellsToWrite& cells);
[[nodiscard]] std::string write_gmsh(const CellsToWrite& cells, GmshVersion version);

}  // namespace hexatlas::io
