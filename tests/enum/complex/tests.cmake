hexatlas_tests(enum_complex fast
  SOURCES cell_test.cpp hex_complex_test.cpp pair_set_test.cpp quad_surface_test.cpp quadrangulation_test.cpp
    triangulation_test.cpp
  ALONE quad_surface_test.cpp quadrangulation_test.cpp
  USES enum_canon enum_flips)
