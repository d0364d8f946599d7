hexatlas_test(realize_refute_test fast
  SOURCES solve/elaborate_test.cpp solve/final_polynomial_test.cpp solve/refute_test.cpp
  USES realize_solve)
hexatlas_test(realize_coordinates_test fast
  SOURCES solve/coordinates_test.cpp
  USES realize_solve)
