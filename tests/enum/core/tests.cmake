hexatlas_tests(enum_core fast SHORT SOURCES files_test.cpp progress_test.cpp rank_test.cpp USES enum_core)
