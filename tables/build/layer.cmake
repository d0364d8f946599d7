hexatlas_layer(tables/build
  HEADERS generate.hpp named.hpp
  SOURCES generate.cpp
  USES enum/core enum/complex enum/canon enum/flips tables/format)
