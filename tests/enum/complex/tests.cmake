hexatlas_test(enum_complex_quadrangulation_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quadrangulation_test.cpp
  USES enum_complex enum_canon)
hexatlas_test(enum_complex_hex_complex_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/hex_complex_test.cpp
  USES enum_complex enum_flips)
hexatlas_test(enum_complex_quad_surface_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quad_surface_test.cpp
  USES enum_complex enum_flips)
hexatlas_test(enum_complex_cell_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/cell_test.cpp
  USES enum_complex)
hexatlas_test(enum_complex_triangulation_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/triangulation_test.cpp
  USES enum_complex)
hexatlas_test(enum_complex_pair_set_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/pair_set_test.cpp
  USES enum_complex)
