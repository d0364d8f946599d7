find_package(rapidcheck REQUIRED)
hexatlas_test(enum_canon_code_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/code_test.cpp
  USES enum_canon enum_flips rapidcheck)
hexatlas_test(enum_canon_nauty_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/nauty/hex_symmetry_test.cpp
  USES enum_canon_nauty enum_flips)
hexatlas_test(enum_canon_nauty_threads_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/nauty/threads_test.cpp
  USES enum_canon_nauty enum_parallel enum_flips)
hexatlas_test(enum_canon_triangulation_form_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/nauty/triangulation_form_test.cpp
  USES enum_balls enum_canon_nauty enum_flips)
