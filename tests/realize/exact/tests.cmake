hexatlas_test(realize_exact_test fast
  SOURCES exact/orientation_test.cpp exact/integer_orientation_test.cpp exact/jacobian_test.cpp exact/volume_test.cpp
    exact/patch_test.cpp
  USES realize_exact)
hexatlas_test(realize_in_sphere_test fast
  SOURCES exact/in_sphere_test.cpp exact/in_sphere_ties_test.cpp
  USES realize_exact)
hexatlas_test(realize_in_orthosphere_test fast
  SOURCES exact/in_orthosphere_test.cpp
  USES realize_exact)
hexatlas_test(realize_limbs_test fast SOURCES exact/limbs_test.cpp USES realize_exact)
hexatlas_test(realize_prism_test fast SOURCES exact/prism_test.cpp exact/prism_threshold_test.cpp USES realize_exact)
hexatlas_test(realize_jacobian_filter_test fast SOURCES exact/jacobian_filter_test.cpp USES realize_exact)
