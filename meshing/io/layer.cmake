hexatlas_layer(meshing/io
  HEADERS format.hpp mesh_files.hpp cell_types.hpp little_endian.hpp mesh_builder.hpp readers.hpp
    scanner.hpp text.hpp vtu_data.hpp writers.hpp
  SOURCES format.cpp mesh_files.cpp cell_types.cpp mesh_builder.cpp scanner.cpp text.cpp
    read_gmsh.cpp read_medit.cpp read_obj.cpp read_off.cpp read_vtk.cpp read_vtu.cpp
    vtu_data.cpp write_gmsh.cpp write_text.cpp write_vtk.cpp
  USES enum/core enum/cells meshing/mesh
  THIRD_PARTY pugixml::pugixml ZLIB::ZLIB)
