hexatlas_tests(tables_fill fast SOURCES query_test.cpp USES tables_fill enum_flips)
