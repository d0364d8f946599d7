hexatlas_test(realize_exact_test fast
  SOURCES exact/orientation_test.cpp exact/integer_orientation_test.cpp exact/jacobian_test.cpp exact/volume_test.cpp
    exact/patch_test.cpp
  USES realize_exact)
