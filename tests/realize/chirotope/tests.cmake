hexatlas_test(realize_chirotope_test fast
  SOURCES chirotope/chirotope_test.cpp
  USES realize_chirotope)
