hexatlas_layer(realize/solve
  HEADERS coordinates.hpp decide.hpp elaborate.hpp elaborate_shorten.hpp final_polynomial.hpp
    refute.hpp sat.hpp
  SOURCES coordinates.cpp coordinates_clauses.cpp coordinates_clauses.hpp coordinates_descent.cpp
    coordinates_descent.hpp coordinates_jacobian.cpp coordinates_jacobian.hpp coordinates_repair.cpp
    coordinates_repair.hpp coordinates_slack.cpp coordinates_slack.hpp decide.cpp elaborate.cpp
    elaborate_propagation.cpp elaborate_propagation.hpp elaborate_shorten.cpp
    final_polynomial.cpp final_polynomial_hull.cpp final_polynomial_hull.hpp refute.cpp sat.cpp
  APART coordinates_slack.cpp final_polynomial.cpp | final_polynomial_hull.cpp
  USES enum/core enum/complex realize/exact realize/chirotope realize/conditions realize/certificate
  THIRD_PARTY hexatlas_cadical PkgConfig::z3)
