hexatlas_tests(realize_conditions fast
  SOURCES clauses_test.cpp edges_test.cpp points_test.cpp
  USES realize_conditions tables_check)
