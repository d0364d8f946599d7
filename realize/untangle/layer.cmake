hexatlas_layer(realize/untangle
  HEADERS koebe.hpp untangle.hpp
  SOURCES attempt.cpp attempt.hpp descent.cpp descent.hpp energies.cpp energies.hpp frame.cpp frame.hpp
    harmonic.cpp harmonic.hpp koebe.cpp placement.cpp placement.hpp problem.cpp problem.hpp raise.cpp raise.hpp
    samples.cpp samples.hpp unfold.cpp unfold.hpp untangle.cpp work.hpp
  USES enum/core enum/complex enum/parallel realize/exact
  THIRD_PARTY Eigen3::Eigen)
