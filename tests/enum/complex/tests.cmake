hexatlas_tests(enum_complex fast
  SOURCES brown_test.cpp cell_test.cpp dual_class_test.cpp hex_complex_test.cpp pair_set_test.cpp
    quad_surface_test.cpp quadrangulation_test.cpp quaternion_test.cpp triangulation_test.cpp
  APART quad_surface_test.cpp | quadrangulation_test.cpp
  USES enum_canon enum_flips)
