hexatlas_tests(meshing_simplify fast SOURCES simplify_test.cpp USES meshing_simplify)
# Used by experiments/2026-11-simplify.
add_executable(meshing_simplify_blow_up ${CMAKE_CURRENT_LIST_DIR}/blow_up_tool.cpp)
target_include_directories(meshing_simplify_blow_up PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(meshing_simplify_blow_up PRIVATE meshing_simplify meshing_hexahedrize meshing_io)
