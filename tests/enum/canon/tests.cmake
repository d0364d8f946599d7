find_package(rapidcheck REQUIRED)
hexatlas_tests(enum_canon fast
  SOURCES code_test.cpp nauty/hex_symmetry_test.cpp nauty/triangulation_form_test.cpp
  USES enum_canon enum_canon_nauty enum_balls enum_flips rapidcheck)
hexatlas_tests(enum_canon threads
  SOURCES nauty/threads_test.cpp
  USES enum_canon_nauty enum_parallel enum_flips)
