set(known_counts HEXATLAS_KNOWN_COUNTS="${CMAKE_CURRENT_LIST_DIR}/known_counts.tsv")
hexatlas_test(counts_quadrangulations_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quadrangulations_test.cpp
  USES enum_canon enum_canon_nauty enum_flips)
target_compile_definitions(counts_quadrangulations_test PRIVATE ${known_counts} HEXATLAS_MAX_QUADS=11)
hexatlas_test(counts_quadrangulations_long_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quadrangulations_test.cpp
  USES enum_canon enum_canon_nauty enum_flips)
target_compile_definitions(counts_quadrangulations_long_test PRIVATE ${known_counts} HEXATLAS_MAX_QUADS=13)
