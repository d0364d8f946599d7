hexatlas_test(meshing_delaunay_test fast
  SOURCES delaunay/triangulation_test.cpp delaunay/degenerate_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_test(meshing_delaunay_weighted_test fast
  SOURCES delaunay/weighted_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_test(meshing_delaunay_laws_test fast
  SOURCES delaunay/laws_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_test(meshing_delaunay_large_test long
  SOURCES delaunay/large_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_test(meshing_delaunay_queries_test fast
  SOURCES delaunay/queries_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_test(meshing_delaunay_parts_test fast
  SOURCES delaunay/digging_test.cpp delaunay/four_facets_test.cpp delaunay/space_order_test.cpp
  USES meshing_delaunay realize_exact)
hexatlas_test(meshing_delaunay_threads_test threads
  SOURCES delaunay/handover_test.cpp delaunay/threads_test.cpp
  USES meshing_delaunay realize_exact enum_parallel)
hexatlas_test(meshing_delaunay_many_threads_test long
  SOURCES delaunay/many_threads_test.cpp
  USES meshing_delaunay realize_exact)
if(TARGET hexatlas_cgal)
  hexatlas_test(meshing_delaunay_cgal_test fast
    SOURCES delaunay/cgal_test.cpp delaunay/cgal_weighted_test.cpp
    USES meshing_delaunay hexatlas_cgal)
endif()
