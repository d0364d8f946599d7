hexatlas_tests(realize_chirotope fast SHORT SOURCES chirotope_test.cpp USES realize_chirotope)
