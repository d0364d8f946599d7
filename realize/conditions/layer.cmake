hexatlas_layer(realize/conditions
  HEADERS clauses.hpp edges.hpp points.hpp
  SOURCES clauses.cpp edges.cpp points.cpp
  USES enum/core enum/complex realize/exact realize/chirotope realize/certificate)
