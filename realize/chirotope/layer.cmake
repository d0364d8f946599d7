hexatlas_layer(realize/chirotope
  HEADERS chirotope.hpp
  SOURCES chirotope.cpp
  USES enum/core realize/certificate)
