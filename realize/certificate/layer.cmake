hexatlas_layer(realize/certificate
  HEADERS certificate.hpp
  SOURCES certificate.cpp
  USES enum/core)
