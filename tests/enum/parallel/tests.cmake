hexatlas_tests(enum_parallel threads SOURCES parallel_for_test.cpp USES enum_parallel)
