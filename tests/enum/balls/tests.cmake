hexatlas_test(enum_balls_front_search_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/front_search_test.cpp
  USES enum_balls)
hexatlas_test(enum_balls_triangulations_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/triangulations_test.cpp
  USES enum_balls)
hexatlas_test(enum_balls_spheres_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/spheres_test.cpp
  USES enum_balls enum_canon_nauty enum_flips)
hexatlas_test(enum_balls_spheres_cells_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/spheres_cells_test.cpp
  USES enum_balls enum_flips)
hexatlas_test(enum_balls_polyhedra_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/polyhedra_test.cpp
  USES enum_balls)
hexatlas_test(enum_balls_all_manifolds_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/all_manifolds_test.cpp
  USES enum_balls enum_canon_nauty enum_flips)
hexatlas_test(enum_balls_sphere_threads_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/sphere_threads_test.cpp
  USES enum_balls)
