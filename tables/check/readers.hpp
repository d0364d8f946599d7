#pragma once
/// \file
/// Internal to the judge: one reader per format, and what they share.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tables/check/mesh.hpp"

namespace hexatlas::check {

[[nodiscard]] Mesh parse_legacy_vtk(const std::string& name, std::string_view bytes);
[[nodiscard]] Mesh parse_vtu(const std::string& name, std::string_view bytes);
[[nodiscard]] Mesh parse_medit(const std::string& name, std::string_view bytes);
[[nodiscard]] Mesh parse_gmsh(const std::string& name, std::string_view bytes);
[[nodiscard]] Surface parse_obj(const std::string& name, std::string_view bytes);
[[nodiscard]] Surface parse_off(const std::string& name, std::string_view bytes);

/// Cells as VTK keeps them: offsets[i] .. offsets[i + 1] - 1 are the places in `connectivity` of
/// the vertices of cell i, whose kind is types[i]; offsets has one element more than types.
struct VtkCells {
  std::vector<std::uint64_t> connectivity;
  std::vector<std::uint64_t> offsets;
  std::vector<std::uint64_t> types;
};

/// Appends the hexahedra and quads of `cells` to `mesh`, whose points are complete. Says what is
/// wrong by `fail`, which does not return.
void add_vtk_cells(const VtkCells& cells, Mesh& mesh,
                   const std::function<void(const std::string&)>& fail);

}  // namespace hexatlas::check
