# hexatlas_bench is built with the tests and run by hand.
find_package(benchmark REQUIRED)
set(bench_sources balls_bench.cpp exact_bench.cpp hexatlas_bench.cpp hexes_bench.cpp hybrid_bench.cpp quads_bench.cpp)
list(TRANSFORM bench_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
add_executable(hexatlas_bench ${bench_sources})
hexatlas_share_units(hexatlas_bench)
target_include_directories(hexatlas_bench PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(hexatlas_bench PRIVATE HEXATLAS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(hexatlas_bench PRIVATE
  meshing_hybrid meshing_delaunay tables_format enum_balls enum_hexes enum_quads enum_flips enum_canon enum_complex
  realize_exact benchmark::benchmark)
