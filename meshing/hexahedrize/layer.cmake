hexatlas_layer(meshing/hexahedrize
  HEADERS hexahedrize.hpp linear.hpp pairing.hpp peel.hpp placing.hpp small_form.hpp
  SOURCES hexahedrize.cpp linear.cpp pairing.cpp peel.cpp placing.cpp small_form.cpp
  USES enum/core enum/parallel enum/cells enum/complex enum/canon enum/flips realize/exact realize/untangle tables/fill tables/format meshing/mesh
  THIRD_PARTY Boost::headers)
