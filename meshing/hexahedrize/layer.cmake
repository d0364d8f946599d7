hexatlas_layer(meshing/hexahedrize
  HEADERS hexahedrize.hpp linear.hpp pair_set.hpp pairing.hpp placing.hpp
  SOURCES hexahedrize.cpp linear.cpp pairing.cpp placing.cpp
  USES enum/core enum/cells enum/complex enum/canon realize/exact realize/untangle tables/format meshing/mesh
  THIRD_PARTY Boost::headers)
