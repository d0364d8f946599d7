hexatlas_test(enum_search_depth_first_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/depth_first_test.cpp
  USES enum_search)
