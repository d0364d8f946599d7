hexatlas_layer(meshing/io
  HEADERS format.hpp mesh_files.hpp cell_types.hpp hxtet.hpp little_endian.hpp mesh_builder.hpp
    output.hpp readers.hpp scanner.hpp vtu_data.hpp writers.hpp
  SOURCES format.cpp mesh_files.cpp cell_types.cpp mesh_builder.cpp output.cpp scanner.cpp
    read_gmsh.cpp read_medit.cpp read_obj.cpp read_off.cpp read_ply.cpp read_points.cpp
    read_vtk.cpp read_vtu.cpp vtu_data.cpp write_files.cpp write_gmsh.cpp write_hxtet.cpp
    write_text.cpp write_vtk.cpp
  APART read_off.cpp read_vtk.cpp
  USES enum/core enum/cells meshing/mesh
  THIRD_PARTY pugixml::pugixml ZLIB::ZLIB)
