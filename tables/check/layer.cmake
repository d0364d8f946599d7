# The judge: includes no file of another layer, links nothing of ours.
hexatlas_layer(tables/check
  HEADERS ball.hpp disjoint_sets.hpp file_bytes.hpp incidence.hpp judge_cells.hpp laws.hpp
    malformed.hpp mesh.hpp mesh_check.hpp payload.hpp quad_code.hpp readers.hpp scanner.hpp
    sha256.hpp table_check.hpp table_layout.hpp verdict.hpp vtu_data.hpp
  SOURCES ball.cpp file_bytes.cpp incidence.cpp judge_cells.cpp laws.cpp links.cpp mesh_check.cpp
    payload.cpp quad_code.cpp read_gmsh.cpp read_legacy_vtk.cpp read_medit.cpp read_mesh.cpp
    read_polygons.cpp read_vtu.cpp scanner.cpp sha256.cpp table_check.cpp table_layout.cpp
    vtu_data.cpp
  THIRD_PARTY PkgConfig::zstd ZLIB::ZLIB pugixml::pugixml)
