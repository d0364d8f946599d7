hexatlas_layer(meshing/hexahedrize
  HEADERS hexahedrize.hpp linear.hpp pair_set.hpp pairing.hpp smoothing.hpp
  SOURCES hexahedrize.cpp linear.cpp pairing.cpp smoothing.cpp
  USES enum/core enum/cells enum/complex enum/canon realize/exact tables/format meshing/mesh
  THIRD_PARTY Boost::headers)
