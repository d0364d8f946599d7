hexatlas_test(enum_parallel_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/parallel_for_test.cpp
  USES enum_parallel)
