hexatlas_tests(realize_exact fast
  SOURCES in_orthosphere_test.cpp in_sphere_test.cpp in_sphere_ties_test.cpp integer_orientation_test.cpp
    jacobian_filter_test.cpp jacobian_test.cpp limbs_test.cpp orientation_test.cpp patch_test.cpp prism_test.cpp
    prism_threshold_test.cpp volume_test.cpp
  APART integer_orientation_test.cpp jacobian_filter_test.cpp prism_threshold_test.cpp volume_test.cpp
  USES realize_exact)
