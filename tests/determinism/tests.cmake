hexatlas_tests(determinism threads
  SOURCES beam_threads_test.cpp cut_threads_test.cpp shellings_threads_test.cpp
  USES enum_flips enum_hexes enum_parallel)
