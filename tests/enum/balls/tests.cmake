hexatlas_tests(enum_balls fast
  SOURCES front_search_test.cpp polyhedra_test.cpp spheres_cells_test.cpp spheres_test.cpp
  USES enum_balls enum_canon_nauty enum_flips)
hexatlas_tests(enum_balls threads SOURCES sphere_threads_test.cpp triangulations_test.cpp USES enum_balls)
hexatlas_tests(enum_balls long
  SOURCES all_manifolds_test.cpp
  USES enum_balls enum_canon_nauty enum_flips)
