hexatlas_test(enum_core_files_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/files_test.cpp
  USES enum_core)
hexatlas_test(enum_core_rank_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/rank_test.cpp
  USES enum_core)
