hexatlas_layer(meshing/hybrid
  HEADERS candidates.hpp classes.hpp conforming.hpp filling.hpp lattice.hpp progress.hpp quads.hpp
    selection.hpp tet_graph.hpp
  SOURCES around.cpp around.hpp blocks.hpp candidates.cpp changing_tets.cpp changing_tets.hpp
    classes.cpp conforming.cpp corners.cpp corners.hpp filling.cpp glued_tets.cpp
    glued_tets.hpp hexahedron_search.cpp
    hexahedron_search.hpp lattice.cpp lattice_points.cpp lattice_points.hpp lattice_recovery.cpp
    lattice_recovery.hpp lattice_surface.cpp lattice_surface.hpp lattice_tets.cpp lattice_tets.hpp
    lattice_vectors.hpp occupancy.cpp occupancy.hpp prism_search.cpp prism_search.hpp quads.cpp
    selection.cpp tet_graph.cpp
  APART changing_tets.cpp lattice.cpp lattice_points.cpp lattice_recovery.cpp lattice_surface.cpp | tet_graph.cpp
  USES enum/core enum/parallel enum/cells enum/complex realize/exact meshing/mesh meshing/quality
    meshing/delaunay)
