hexatlas_tests(sabotage_bound fast TOGETHER
  SOURCES bound_certificates_test.cpp bound_sabotage_test.cpp
  USES tables_check tables_build enum_hexes enum_canon)
hexatlas_tests(sabotage_catalogue long SOURCES catalogue_sabotage_test.cpp USES tables_check)
hexatlas_tests(sabotage_delaunay fast SOURCES delaunay_sabotage_test.cpp USES tables_check)
foreach(label fast long)
  hexatlas_tests(sabotage_hybrid ${label} SOURCES hybrid_sabotage_test.cpp USES tables_check)
endforeach()
hexatlas_tests(sabotage_sectors fast SOURCES sectors_sabotage_test.cpp USES tables_check)
hexatlas_tests(sabotage_table fast
  SOURCES mesh_sabotage_test.cpp table_records_sabotage_test.cpp table_sabotage_test.cpp
  USES tables_check)
hexatlas_tests(sabotage_table long SOURCES table_records_sabotage_test.cpp USES tables_check)

add_executable(sabotage_code_tool ${CMAKE_CURRENT_LIST_DIR}/code_tool.cpp)
target_link_libraries(sabotage_code_tool PRIVATE tables_check)
hexatlas_script_test(sabotage.reference_code program Python3::Interpreter
  ${CMAKE_CURRENT_LIST_DIR}/reference_code.py $<TARGET_FILE:sabotage_code_tool>)
