hexatlas_layer(realize/exact
  HEADERS sign.hpp orientation.hpp in_sphere.hpp in_orthosphere.hpp integer_orientation.hpp jacobian.hpp prism.hpp volume.hpp
    patch.hpp patch_separation.hpp memory.hpp
  SOURCES orientation.cpp in_sphere.cpp in_orthosphere.cpp integer_orientation.cpp jacobian.cpp prism.cpp
    volume.cpp patch.cpp patch_separation.cpp memory.cpp
    jacobian_coefficients.hpp jacobian_subdivision.cpp
    jacobian_lanes.hpp jacobian_lanes_avx2.cpp jacobian_lanes_body.hpp jacobian_lanes_plain.cpp
    determinant.hpp sphere_expansion.hpp binary.hpp limbs.hpp limb_points.hpp integers.hpp
  APART jacobian.cpp patch.cpp | jacobian_subdivision.cpp patch_separation.cpp | jacobian_lanes_plain.cpp
  USES enum/core
  THIRD_PARTY PkgConfig::gmp)
# Vectors of four doubles; never an argument of a function that is not inlined.
target_compile_options(realize_exact PRIVATE -Wno-psabi)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # Chosen when running, where the processor has them. No fused operations: the same verdicts.
  set_source_files_properties(exact/jacobian_lanes_avx2.cpp PROPERTIES
    COMPILE_OPTIONS "-mavx2" SKIP_PRECOMPILE_HEADERS ON)
endif()
