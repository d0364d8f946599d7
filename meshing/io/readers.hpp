#pragma once
/// \file
/// One reader per format, behind parse_surface and parse_hexahedra (mesh_files.hpp, which states
/// what they promise). Each takes the whole file, without byte order mark and not empty.

#include <string_view>

#include "meshing/io/mesh_builder.hpp"

namespace hexatlas::io {

void read_obj(std::string_view bytes, MeshBuilder& builder);
void read_off(std::string_view bytes, MeshBuilder& builder);
void read_vtk(std::string_view bytes, MeshBuilder& builder);
void read_vtu(std::string_view bytes, MeshBuilder& builder);
void read_medit(std::string_view bytes, MeshBuilder& builder);
void read_gmsh(std::string_view bytes, MeshBuilder& builder);

}  // namespace hexatlas::io
