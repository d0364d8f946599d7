hexatlas_tests(realize_conditions fast SHORT
  SOURCES clauses_test.cpp edges_test.cpp points_test.cpp
  USES realize_conditions tables_check)
