hexatlas_layer(tables/build
  HEADERS catalogues.hpp generate.hpp named.hpp realize.hpp
  SOURCES catalogues.cpp generate.cpp realize.cpp
  USES enum/core enum/parallel enum/complex enum/canon enum/flips enum/balls realize/certificate
    realize/solve tables/format)
