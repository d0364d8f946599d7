#pragma once
/// \file
/// One reader per format, behind parse_surface, parse_points and their like (mesh_files.hpp, which
/// states what they promise). Each takes the whole file; those of text take it without byte order
/// mark, and all but read_xyz and read_raw not empty.

#include <string_view>

#include "meshing/io/mesh_builder.hpp"

namespace hexatlas::io {

void read_obj(std::string_view bytes, MeshBuilder& builder);
void read_off(std::string_view bytes, MeshBuilder& builder);
void read_vtk(std::string_view bytes, MeshBuilder& builder);
void read_vtu(std::string_view bytes, MeshBuilder& builder);
void read_medit(std::string_view bytes, MeshBuilder& builder);
void read_gmsh(std::string_view bytes, MeshBuilder& builder);
void read_xyz(std::string_view bytes, MeshBuilder& builder);
void read_raw(std::string_view bytes, MeshBuilder& builder);
void read_ply(std::string_view bytes, MeshBuilder& builder);
void read_hxtet(std::string_view bytes, MeshBuilder& builder);

}  // namespace hexatlas::io
