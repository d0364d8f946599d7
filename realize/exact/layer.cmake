hexatlas_layer(realize/exact
  HEADERS sign.hpp orientation.hpp in_sphere.hpp integer_orientation.hpp jacobian.hpp prism.hpp volume.hpp
    patch.hpp patch_separation.hpp memory.hpp
  SOURCES orientation.cpp in_sphere.cpp integer_orientation.cpp jacobian.cpp prism.cpp
    volume.cpp patch.cpp patch_separation.cpp memory.cpp
    determinant.hpp binary.hpp limbs.hpp limb_points.hpp integers.hpp
  USES enum/core
  THIRD_PARTY PkgConfig::gmp)
