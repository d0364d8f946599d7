hexatlas_test(enum_hexes_search_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/search_test.cpp
  USES enum_hexes enum_search enum_flips)
hexatlas_test(enum_hexes_brute_force_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/brute_force_test.cpp
  USES enum_hexes enum_search enum_flips)
hexatlas_test(enum_hexes_known_meshes_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/known_meshes_test.cpp
  USES enum_hexes enum_search enum_flips tables_format)
target_compile_definitions(enum_hexes_known_meshes_test PRIVATE
  HEXATLAS_SHIPPED_TABLE="${PROJECT_SOURCE_DIR}/tables/data/hexatlas.hxt")
hexatlas_test(enum_hexes_hexmeshes_test fast threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/hexmeshes_test.cpp
  USES enum_hexes enum_search enum_flips tables_build)

set(known_counts
  HEXATLAS_KNOWN_COUNTS="${CMAKE_CURRENT_LIST_DIR}/../../counts/known_counts.tsv")
hexatlas_test(enum_hexes_shellings_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/shellings_test.cpp
  USES enum_hexes enum_search enum_quads enum_canon_nauty enum_flips)
target_compile_definitions(enum_hexes_shellings_test PRIVATE ${known_counts}
  HEXATLAS_MOST_HEXAHEDRA=5)
hexatlas_test(enum_hexes_shellings_long_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/shellings_test.cpp
  USES enum_hexes enum_search enum_quads enum_canon_nauty enum_flips)
target_compile_definitions(enum_hexes_shellings_long_test PRIVATE ${known_counts}
  HEXATLAS_MOST_HEXAHEDRA=7)
