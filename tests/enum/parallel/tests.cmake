hexatlas_tests(enum_parallel threads SOURCES parallel_for_test.cpp USES enum_parallel)
target_link_options(enum_parallel_threads_tests PRIVATE -Wl,--wrap=_Znwm)  # memory that runs out
