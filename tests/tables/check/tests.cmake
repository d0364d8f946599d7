# tests_of_two_sizes(NAME MACRO fast-size long-size SOURCES ... USES ... DEFINITIONS ...): NAME_fast_test and
# NAME_long_test, in which MACRO is the size.
function(tests_of_two_sizes name macro fast long)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;DEFINITIONS" ${ARGN})
  foreach(label fast long)
    hexatlas_test(${name}_${label}_test ${label} SOURCES ${ARG_SOURCES} USES ${ARG_USES})
    target_compile_definitions(${name}_${label}_test PRIVATE ${macro}=${${label}} ${ARG_DEFINITIONS})
  endforeach()
endfunction()

hexatlas_test(tables_check_file_bytes_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/file_bytes_test.cpp
  USES tables_check)
hexatlas_test(tables_check_lrat_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/lrat_test.cpp
  USES tables_check)
hexatlas_test(tables_check_completeness_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/completeness_test.cpp
  USES tables_check)
hexatlas_test(tables_check_completeness_proof_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/completeness_proof_test.cpp
  USES tables_check realize_solve)
hexatlas_test(tables_check_catalogue_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/catalogue_test.cpp
  USES tables_check tables_format)
target_compile_definitions(tables_check_catalogue_test PRIVATE
  HEXATLAS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
hexatlas_test(tables_check_refutation_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/refutation_test.cpp
  USES tables_check)
hexatlas_test(sabotage_catalogue_test long
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/catalogue_sabotage_test.cpp
  USES tables_check)
target_compile_definitions(sabotage_catalogue_test PRIVATE
  HEXATLAS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
hexatlas_test(tables_check_mesh_check_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/mesh_check_test.cpp ${CMAKE_CURRENT_LIST_DIR}/laws_test.cpp
  USES tables_check)
hexatlas_test(tables_check_read_mesh_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/read_mesh_test.cpp ${CMAKE_CURRENT_LIST_DIR}/read_binary_vtk_test.cpp
  USES tables_check)
hexatlas_test(tables_check_read_points_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/read_points_test.cpp
  USES tables_check meshing_io)
hexatlas_test(tables_check_delaunay_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/delaunay_check_test.cpp ${CMAKE_CURRENT_LIST_DIR}/regular_check_test.cpp
  USES tables_check)
hexatlas_test(sabotage_delaunay_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/delaunay_sabotage_test.cpp
  USES tables_check)
hexatlas_test(tables_check_hybrid_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/hybrid_check_test.cpp
  USES tables_check meshing_io)
tests_of_two_sizes(sabotage_hybrid HEXATLAS_ROUNDS 6 120
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/hybrid_sabotage_test.cpp
  USES tables_check)
hexatlas_test(tables_check_quad_code_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quad_code_test.cpp
  USES tables_check)
tests_of_two_sizes(tables_check_rooted_count HEXATLAS_MAX_QUADS 10 12
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/rooted_count_test.cpp
  USES tables_check enum_canon)
hexatlas_test(tables_check_table_check_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/table_check_test.cpp
  USES tables_check)
target_compile_definitions(tables_check_table_check_test PRIVATE
  HEXATLAS_SHIPPED_TABLE="${PROJECT_SOURCE_DIR}/tables/data/hexatlas.hxt")
hexatlas_test(sabotage_mesh_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/mesh_sabotage_test.cpp
  USES tables_check)
tests_of_two_sizes(sabotage_table_records HEXATLAS_ROUNDS 700 4000
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/table_records_sabotage_test.cpp
  USES tables_check
  DEFINITIONS HEXATLAS_SHIPPED_TABLE="${PROJECT_SOURCE_DIR}/tables/data/hexatlas.hxt")
hexatlas_test(sabotage_table_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/table_sabotage_test.cpp
  USES tables_check)

hexatlas_test(tables_check_bound_rules_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/bound_rules_test.cpp
  USES tables_check tables_format)
target_compile_definitions(tables_check_bound_rules_test PRIVATE
  HEXATLAS_SHIPPED_TABLE="${PROJECT_SOURCE_DIR}/tables/data/hexatlas.hxt")
tests_of_two_sizes(sabotage_bound HEXATLAS_ROUNDS 1200 6000
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/bound_sabotage_test.cpp
  USES tables_check)

hexatlas_test(sabotage_bound_certificates_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/bound_certificates_test.cpp
  USES tables_check tables_build enum_hexes enum_canon)

hexatlas_test(tables_check_sectors_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/sectors_test.cpp
  USES tables_check)
hexatlas_test(sabotage_sectors_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/sectors_sabotage_test.cpp
  USES tables_check)
foreach(name tables_check_sectors_test sabotage_sectors_test)
  target_compile_definitions(${name} PRIVATE
    HEXATLAS_SCARRED_SECTOR="${CMAKE_CURRENT_LIST_DIR}/scarred.hxs")
endforeach()

add_executable(sabotage_code_tool ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/code_tool.cpp)
target_link_libraries(sabotage_code_tool PRIVATE tables_check)
hexatlas_script_test(sabotage.reference_code fast Python3::Interpreter
  ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/reference_code.py $<TARGET_FILE:sabotage_code_tool>)
