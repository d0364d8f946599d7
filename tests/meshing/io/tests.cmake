hexatlas_tests(meshing_io fast SHORT
  SOURCES hybrid_test.cpp malformed_gmsh_test.cpp malformed_test.cpp malformed_vtk_test.cpp mutations_test.cpp
    paths_test.cpp ply_test.cpp points_test.cpp prefixes_test.cpp read_test.cpp replay_test.cpp round_trip_test.cpp
    tetrahedra_test.cpp
  USES meshing_io)

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
