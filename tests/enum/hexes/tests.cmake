hexatlas_tests(enum_hexes fast
  SOURCES hexmeshes_test.cpp known_meshes_test.cpp search_test.cpp shellings_test.cpp
  USES enum_hexes enum_search enum_quads enum_canon_nauty enum_flips tables_build tables_format)
hexatlas_tests(enum_hexes long
  SOURCES brute_force_test.cpp shellings_test.cpp
  USES enum_hexes enum_search enum_quads enum_canon_nauty enum_flips)
