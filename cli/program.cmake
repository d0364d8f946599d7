# What CLI11 reads. It is costly to compile: once.
add_library(command_line OBJECT
  cli/command_line.cpp cli/command_line_enum.cpp cli/command_line_mesh.cpp cli/command_line_table.cpp
  cli/command_line_view.cpp)
hexatlas_share_units(command_line)
target_compile_options(command_line PRIVATE ${HEXATLAS_COLDEST_OPTIONS})

add_executable(hexatlas
  cli/boundary_input.cpp cli/cell_input.cpp cli/check.cpp cli/check_hybrid.cpp cli/code.cpp
  cli/completeness.cpp cli/enum_hexmeshes.cpp
  cli/enum_lists.cpp cli/enum_quadrangulations.cpp cli/enum_shellings.cpp cli/enum_triangulations.cpp
  cli/interrupt.cpp cli/long_work.cpp cli/main.cpp cli/mesh_boundary.cpp cli/mesh_delaunay.cpp cli/mesh_hex.cpp cli/mesh_hybrid.cpp cli/hybrid_text.cpp cli/mesh_quads.cpp
  cli/mesh_untangle.cpp cli/mesh_output.cpp
  cli/mesh_report.cpp cli/mesh_hex_report.cpp cli/histogram_chart.cpp cli/output.cpp
  cli/realize.cpp cli/reproduce.cpp cli/simplify.cpp cli/table_bounds.cpp cli/table_build.cpp cli/table_by_quads.cpp
  cli/table_check.cpp cli/table_path.cpp cli/table_read.cpp cli/table_write.cpp cli/child_process.cpp
  cli/view.cpp cli/view_page.cpp cli/view_picture.cpp)
target_compile_options(hexatlas PRIVATE ${HEXATLAS_COLDEST_OPTIONS})  # what takes time is in the layers
hexatlas_share_units(hexatlas
  APART cli/child_process.cpp cli/enum_hexmeshes.cpp cli/enum_quadrangulations.cpp cli/mesh_delaunay.cpp |
    cli/mesh_quads.cpp)
include(${CMAKE_CURRENT_SOURCE_DIR}/cli/view/view.cmake)
foreach(target command_line hexatlas)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE enum_hexes enum_quads meshing_delaunay meshing_hexahedrize meshing_hybrid
    meshing_io meshing_quality meshing_simplify meshing_view realize_solve tables_build tables_check tables_format
    tables_sheet CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json)
endforeach()
target_link_libraries(hexatlas PRIVATE command_line)
set_target_properties(hexatlas PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

# The commit goes into manifests; a build outside a checkout says so.
execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
else()  # configure anew when the commit or the index changes
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/.git/HEAD ${PROJECT_SOURCE_DIR}/.git/index)
endif()
set_source_files_properties(cli/table_write.cpp PROPERTIES
  COMPILE_DEFINITIONS "HEXATLAS_COMMIT=\"${commit}\"")
set_source_files_properties(cli/output.cpp PROPERTIES
  COMPILE_DEFINITIONS "HEXATLAS_VERSION=\"${PROJECT_VERSION}\"")

# The program finds its tables beside itself.
file(GLOB tables CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tables/data/*)
foreach(table ${tables})
  get_filename_component(name ${table} NAME)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/tables/${name}
    COMMAND ${CMAKE_COMMAND} -E copy ${table} ${PROJECT_BINARY_DIR}/tables/${name}
    DEPENDS ${table} VERBATIM)
  list(APPEND copied ${PROJECT_BINARY_DIR}/tables/${name})
endforeach()
add_custom_target(tables_beside_program ALL DEPENDS ${copied})
add_dependencies(hexatlas tables_beside_program)

include(GNUInstallDirs)
install(TARGETS hexatlas)
install(FILES ${tables} DESTINATION ${CMAKE_INSTALL_DATADIR}/hexatlas/tables)
