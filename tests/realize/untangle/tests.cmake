hexatlas_test(realize_untangle_test fast
  SOURCES untangle/energies_test.cpp untangle/koebe_test.cpp untangle/untangle_test.cpp
  USES realize_untangle enum_quads Eigen3::Eigen)
hexatlas_test(realize_untangle_threads_test threads
  SOURCES untangle/threads_test.cpp
  USES realize_untangle)
