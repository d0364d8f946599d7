hexatlas_test(tables_fill_query_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/query_test.cpp
  USES tables_fill enum_flips)
