hexatlas_test(meshing_hybrid_test fast
  SOURCES hybrid/candidates_test.cpp hybrid/classes_test.cpp hybrid/graph_test.cpp hybrid/quads_test.cpp
    hybrid/selection_test.cpp
  USES meshing_hybrid meshing_delaunay tables_check)
hexatlas_test(meshing_hybrid_brute_force_test long
  SOURCES hybrid/brute_force_test.cpp
  USES meshing_hybrid meshing_delaunay tables_check)
hexatlas_test(meshing_hybrid_threads_test threads
  SOURCES hybrid/threads_test.cpp
  USES meshing_hybrid meshing_delaunay tables_check)
hexatlas_test(meshing_hybrid_lattice_test fast
  SOURCES hybrid/lattice_test.cpp
  USES meshing_hybrid realize_exact)
