hexatlas_layer(meshing/quality
  HEADERS hexahedron.hpp report.hpp
  SOURCES hexahedron.cpp report.cpp
  USES enum/core realize/exact meshing/mesh)
