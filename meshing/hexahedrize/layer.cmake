hexatlas_layer(meshing/hexahedrize
  HEADERS angles.hpp hexahedrize.hpp linear.hpp pairing.hpp peel.hpp placing.hpp round_frame.hpp sides.hpp small_form.hpp
  SOURCES angles.cpp hexahedrize.cpp linear.cpp pairing.cpp peel.cpp placing.cpp round_frame.cpp sides.cpp small_form.cpp
  USES enum/core enum/parallel enum/cells enum/complex enum/canon enum/flips realize/exact realize/untangle tables/fill tables/format meshing/mesh meshing/quality
  THIRD_PARTY Boost::headers)
