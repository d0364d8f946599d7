hexatlas_tests(enum_quads fast
  SOURCES expansions_test.cpp generate_test.cpp planar_code_test.cpp
  USES enum_quads enum_flips)
hexatlas_tests(enum_quads long SOURCES generate_test.cpp USES enum_quads enum_flips)
