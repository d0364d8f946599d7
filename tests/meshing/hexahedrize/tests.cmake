hexatlas_tests(meshing_hexahedrize fast
  SOURCES linear_test.cpp pairing_test.cpp peel_test.cpp round_frame_test.cpp sharp_zones_test.cpp sides_test.cpp
  USES meshing_hexahedrize enum_quads tables_check)
hexatlas_tests(meshing_hexahedrize long
  SOURCES peel_large_test.cpp
  USES meshing_hexahedrize enum_quads tables_check)
