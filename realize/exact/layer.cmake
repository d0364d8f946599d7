hexatlas_layer(realize/exact
  HEADERS sign.hpp orientation.hpp integer_orientation.hpp jacobian.hpp volume.hpp
  SOURCES orientation.cpp integer_orientation.cpp jacobian.cpp volume.cpp determinant.hpp integers.hpp
  USES enum/core
  THIRD_PARTY PkgConfig::gmp)
