hexatlas_layer(meshing/hexahedrize
  HEADERS hexahedrize.hpp placing.hpp
  SOURCES hexahedrize.cpp placing.cpp
  USES enum/core enum/cells enum/complex enum/canon realize/exact realize/untangle tables/format meshing/mesh)
