hexatlas_layer(meshing/view
  HEADERS structure.hpp
  SOURCES structure.cpp
  USES enum/core enum/cells meshing/mesh)
