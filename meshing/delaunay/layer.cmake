hexatlas_layer(meshing/delaunay
  HEADERS triangulation.hpp
  SOURCES builder.cpp builder.hpp cells.hpp common_unit.hpp curves.cpp curves.hpp digging.hpp
    digging_body.hpp division.hpp four_facets.hpp four_facets_avx2.cpp four_facets_avx512.cpp
    four_facets_body.hpp four_facets_plain.cpp handover.hpp inserter.cpp inserter.hpp
    local_vertices.hpp page_allocator.hpp page_buffer.hpp parts.hpp region.hpp site.hpp
    space_order.cpp space_order.hpp star_links.hpp triangulation.cpp walk.hpp worker.hpp
  USES enum/core enum/parallel realize/exact meshing/mesh)
# Vectors of four doubles; never an argument of a function that is not inlined.
target_compile_options(meshing_delaunay PRIVATE -Wno-psabi)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # Chosen when running, where the processor has them. A fused operation leaves out a rounding.
  set_source_files_properties(delaunay/four_facets_avx2.cpp PROPERTIES
    COMPILE_OPTIONS "-mavx2;-mfma;-ffp-contract=fast" SKIP_PRECOMPILE_HEADERS ON)
  # The same vectors, and registers for all of them.
  set_source_files_properties(delaunay/four_facets_avx512.cpp PROPERTIES COMPILE_OPTIONS
    "-mavx512f;-mavx512vl;-mavx512dq;-mfma;-mprefer-vector-width=256;-ffp-contract=fast"
    SKIP_PRECOMPILE_HEADERS ON)
endif()
