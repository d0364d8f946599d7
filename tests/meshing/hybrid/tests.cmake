hexatlas_test(meshing_hybrid_test fast
  SOURCES hybrid/candidates_test.cpp hybrid/classes_test.cpp hybrid/graph_test.cpp
    hybrid/selection_test.cpp
  USES meshing_hybrid meshing_delaunay tables_check)
