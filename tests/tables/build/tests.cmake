hexatlas_test(tables_build_bounds_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/bounds_test.cpp
  USES tables_build tables_check enum_canon enum_hexes)
hexatlas_test(tables_build_search_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/search_test.cpp
  USES tables_build tables_check enum_canon enum_flips)
target_compile_definitions(tables_build_search_test PRIVATE
  HEXATLAS_KNOWN_COUNTS="${CMAKE_CURRENT_LIST_DIR}/../../counts/known_counts.tsv")
hexatlas_test(tables_build_census_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/census_test.cpp
  USES tables_build enum_flips)
hexatlas_test(tables_build_named_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/named_test.cpp
  USES tables_build enum_canon)
