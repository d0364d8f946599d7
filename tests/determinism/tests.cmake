hexatlas_test(determinism_beam_threads_test threads
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/beam_threads_test.cpp
  USES enum_flips)
