hexatlas_tests(meshing_delaunay fast
  SOURCES degenerate_test.cpp digging_test.cpp four_facets_test.cpp laws_test.cpp queries_test.cpp space_order_test.cpp
    triangulation_test.cpp weighted_test.cpp
  APART four_facets_test.cpp weighted_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_tests(meshing_delaunay long
  SOURCES large_test.cpp many_threads_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_tests(meshing_delaunay threads
  SOURCES handover_test.cpp threads_test.cpp
  USES meshing_delaunay realize_exact enum_parallel)
if(TARGET hexatlas_cgal)
  hexatlas_tests(meshing_delaunay_cgal long
    SOURCES cgal_test.cpp cgal_weighted_test.cpp
    APART cgal_test.cpp | cgal_weighted_test.cpp
    USES meshing_delaunay hexatlas_cgal)
endif()
