hexatlas_test(meshing_view_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/structure_test.cpp
  USES meshing_view)
