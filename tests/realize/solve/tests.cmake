hexatlas_tests(realize_solve fast
  SOURCES coordinates_test.cpp elaborate_test.cpp final_polynomial_test.cpp refute_test.cpp
  USES realize_solve)
