# hexatlas_bench is built with the tests and run by hand.
find_package(benchmark REQUIRED)
add_executable(hexatlas_bench
  ${CMAKE_CURRENT_LIST_DIR}/balls_bench.cpp ${CMAKE_CURRENT_LIST_DIR}/exact_bench.cpp
  ${CMAKE_CURRENT_LIST_DIR}/hexatlas_bench.cpp
  ${CMAKE_CURRENT_LIST_DIR}/hexes_bench.cpp
  ${CMAKE_CURRENT_LIST_DIR}/hybrid_bench.cpp
  ${CMAKE_CURRENT_LIST_DIR}/quads_bench.cpp)
target_include_directories(hexatlas_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(hexatlas_bench PRIVATE HEXATLAS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(hexatlas_bench PRIVATE
  meshing_hybrid meshing_delaunay tables_format enum_balls enum_hexes enum_quads enum_flips enum_canon enum_complex
  realize_exact benchmark::benchmark)
