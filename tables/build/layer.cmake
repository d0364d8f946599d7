hexatlas_layer(tables/build
  HEADERS bounds.hpp catalogues.hpp census.hpp hexmesh_search.hpp named.hpp realize.hpp search.hpp
  SOURCES bounds.cpp catalogues.cpp census.cpp hexmesh_search.cpp realize.cpp search.cpp search_bytes.cpp
    search_largest.cpp
  USES enum/core enum/parallel enum/complex enum/canon enum/search enum/flips enum/hexes enum/quads enum/balls realize/certificate
    realize/solve tables/fill tables/format
  THIRD_PARTY PkgConfig::sqlite)
