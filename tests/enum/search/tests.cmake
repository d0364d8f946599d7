hexatlas_test(enum_search_depth_first_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/depth_first_test.cpp
  USES enum_search)
hexatlas_test(enum_search_pool_test fast threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/pool_test.cpp
  USES enum_search enum_parallel)
