hexatlas_test(enum_quads_generate_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/generate_test.cpp
  USES enum_quads enum_flips)
target_compile_definitions(enum_quads_generate_test PRIVATE
  HEXATLAS_SPLIT_QUADS=10 HEXATLAS_CODED_SIMPLE=11 HEXATLAS_SIMPLE=13 HEXATLAS_CONNECTED=19)
hexatlas_test(enum_quads_generate_long_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/generate_test.cpp
  USES enum_quads enum_flips)
target_compile_definitions(enum_quads_generate_long_test PRIVATE
  HEXATLAS_SPLIT_QUADS=12 HEXATLAS_CODED_SIMPLE=14 HEXATLAS_SIMPLE=16 HEXATLAS_CONNECTED=22)
hexatlas_test(enum_quads_expansions_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/expansions_test.cpp
  USES enum_quads enum_flips)
hexatlas_test(enum_quads_planar_code_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/planar_code_test.cpp
  USES enum_quads enum_flips)
