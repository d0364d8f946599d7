hexatlas_tests(meshing_hybrid fast
  SOURCES candidates_test.cpp classes_test.cpp graph_test.cpp lattice_test.cpp quads_test.cpp selection_test.cpp
  USES meshing_hybrid meshing_delaunay realize_exact tables_check)
hexatlas_tests(meshing_hybrid long
  SOURCES brute_force_test.cpp
  USES meshing_hybrid meshing_delaunay tables_check)
hexatlas_tests(meshing_hybrid threads
  SOURCES threads_test.cpp
  USES meshing_hybrid meshing_delaunay tables_check)
