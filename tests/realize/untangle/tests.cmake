hexatlas_tests(realize_untangle fast
  SOURCES energies_test.cpp koebe_test.cpp untangle_test.cpp
  USES realize_untangle enum_quads Eigen3::Eigen)
hexatlas_tests(realize_untangle threads SOURCES threads_test.cpp USES realize_untangle)
