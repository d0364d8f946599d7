hexatlas_layer(realize/exact
  HEADERS sign.hpp orientation.hpp jacobian.hpp
  SOURCES orientation.cpp jacobian.cpp determinant.hpp integers.hpp
  USES enum/core
  THIRD_PARTY PkgConfig::gmp)
