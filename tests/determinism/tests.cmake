hexatlas_test(determinism_beam_threads_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/beam_threads_test.cpp
  USES enum_flips)
hexatlas_test(determinism_cut_threads_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/cut_threads_test.cpp
  USES enum_flips enum_parallel)
hexatlas_test(determinism_shellings_threads_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/shellings_threads_test.cpp
  USES enum_hexes)
