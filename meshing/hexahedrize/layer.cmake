hexatlas_layer(meshing/hexahedrize
  HEADERS hexahedrize.hpp smoothing.hpp
  SOURCES hexahedrize.cpp smoothing.cpp
  USES enum/core enum/cells enum/complex enum/canon realize/exact tables/format meshing/mesh)
