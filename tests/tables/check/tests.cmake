hexatlas_test(tables_check_file_bytes_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/file_bytes_test.cpp
  USES tables_check)
hexatlas_test(tables_check_mesh_check_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/mesh_check_test.cpp
  USES tables_check)
hexatlas_test(tables_check_read_mesh_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/read_mesh_test.cpp
  USES tables_check)
hexatlas_test(tables_check_quad_code_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/quad_code_test.cpp
  USES tables_check)
hexatlas_test(tables_check_table_check_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/table_check_test.cpp
  USES tables_check)
hexatlas_test(sabotage_mesh_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/mesh_sabotage_test.cpp
  USES tables_check)
hexatlas_test(sabotage_table_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/table_sabotage_test.cpp
  USES tables_check)

add_executable(sabotage_code_tool ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/code_tool.cpp)
target_link_libraries(sabotage_code_tool PRIVATE tables_check)
hexatlas_script_test(sabotage.reference_code fast Python3::Interpreter
  ${CMAKE_CURRENT_LIST_DIR}/../../sabotage/reference_code.py $<TARGET_FILE:sabotage_code_tool>)
