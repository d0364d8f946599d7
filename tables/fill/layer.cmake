hexatlas_layer(tables/fill
  HEADERS filled.hpp query.hpp
  SOURCES filled.cpp query.cpp
  USES enum/core enum/complex enum/canon enum/flips tables/format)
