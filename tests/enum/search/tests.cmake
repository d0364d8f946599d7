hexatlas_tests(enum_search fast SOURCES depth_first_test.cpp USES enum_search)
hexatlas_tests(enum_search threads SOURCES pool_test.cpp USES enum_search enum_parallel)
