# CMAKE_CURRENT_LIST_DIR is this folder wherever the file is included from.
foreach(name read malformed malformed_vtk malformed_gmsh prefixes round_trip paths replay points ply
    tetrahedra hybrid mutations)
  hexatlas_test(meshing_io_${name}_test fast
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/${name}_test.cpp USES meshing_io)
endforeach()
target_compile_definitions(meshing_io_replay_test PRIVATE
  HEXATLAS_TESTS_DIR="${PROJECT_SOURCE_DIR}/tests")

add_executable(meshing_io_mesh_tool ${CMAKE_CURRENT_LIST_DIR}/mesh_tool.cpp)
target_link_libraries(meshing_io_mesh_tool PRIVATE meshing_io)
hexatlas_script_test(meshing.io.peers long Python3::Interpreter
  ${CMAKE_CURRENT_LIST_DIR}/peers_test.py $<TARGET_FILE:meshing_io_mesh_tool>)
hexatlas_script_test(meshing.io.tetrahedra_peers long Python3::Interpreter -B
  ${CMAKE_CURRENT_LIST_DIR}/tetrahedra_peers_test.py $<TARGET_FILE:meshing_io_mesh_tool>)
hexatlas_script_test(meshing.io.hybrid_peers long Python3::Interpreter -B
  ${CMAKE_CURRENT_LIST_DIR}/hybrid_peers_test.py $<TARGET_FILE:meshing_io_mesh_tool>)
# The eleven surfaces of the experiment, as they are kept with it.
hexatlas_script_test(meshing.io.pyramid_peers long Python3::Interpreter -B
  ${CMAKE_CURRENT_LIST_DIR}/pyramid_peers_test.py $<TARGET_FILE:hexatlas>
  ${PROJECT_SOURCE_DIR}/experiments/2026-11-quad-balls/inputs)
