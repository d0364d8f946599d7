hexatlas_test(tables_build_generate_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/generate_test.cpp
  USES tables_build tables_check enum_canon enum_flips)
target_compile_definitions(tables_build_generate_test PRIVATE
  HEXATLAS_KNOWN_COUNTS="${CMAKE_CURRENT_LIST_DIR}/../../counts/known_counts.tsv")
