hexatlas_test(realize_clauses_test fast
  SOURCES conditions/clauses_test.cpp
  USES realize_conditions)
hexatlas_test(realize_points_test fast
  SOURCES conditions/points_test.cpp
  USES realize_conditions)
hexatlas_test(realize_edges_test fast
  SOURCES conditions/edges_test.cpp
  USES realize_conditions tables_check)
