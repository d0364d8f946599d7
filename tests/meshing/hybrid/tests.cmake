hexatlas_test(meshing_hybrid_lattice_test fast
  SOURCES hybrid/lattice_test.cpp
  USES meshing_hybrid realize_exact)
