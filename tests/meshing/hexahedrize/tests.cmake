hexatlas_test(meshing_hexahedrize_pairing_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/pairing_test.cpp
  USES meshing_hexahedrize)
hexatlas_test(meshing_hexahedrize_linear_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/linear_test.cpp
  USES meshing_hexahedrize enum_quads tables_check)
target_compile_definitions(meshing_hexahedrize_linear_test PRIVATE
  HEXATLAS_SECTORS="${PROJECT_SOURCE_DIR}/tables/data/linear-bound.hxs")
hexatlas_test(meshing_hexahedrize_peel_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/peel_test.cpp
  USES meshing_hexahedrize enum_quads tables_check)
hexatlas_test(meshing_hexahedrize_peel_large_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/peel_large_test.cpp
  USES meshing_hexahedrize enum_quads tables_check)
foreach(name peel peel_large)
  target_compile_definitions(meshing_hexahedrize_${name}_test PRIVATE
    HEXATLAS_SECTORS="${PROJECT_SOURCE_DIR}/tables/data/linear-bound.hxs"
    HEXATLAS_SHIPPED_TABLE="${PROJECT_SOURCE_DIR}/tables/data/hexatlas.hxt")
endforeach()
