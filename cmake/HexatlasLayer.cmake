# hexatlas_layer(enum/flips HEADERS ... [SOURCES ...] [USES enum/core ...] [THIRD_PARTY ...])
#
# One target per layer, named after its folder (enum/flips -> enum_flips). USES is
# the link line and must be a subset of the layer's row in layers.txt, so that the
# file a person reads and the build cannot disagree. Headers of a layer are
# verified to compile alone (target all_verify_interface_header_sets).

function(hexatlas_check_uses layer)
  file(STRINGS ${PROJECT_SOURCE_DIR}/docs/architecture/layers.txt rows REGEX "^${layer} *[|]")
  if(NOT rows)
    message(FATAL_ERROR "${layer} is not listed in docs/architecture/layers.txt")
  endif()
  string(REGEX REPLACE "^[^|]*[|]([^|]*)[|].*$" "\\1" allowed "${rows}")
  separate_arguments(allowed)
  foreach(used ${ARGN})
    if(NOT used IN_LIST allowed)
      message(FATAL_ERROR "${layer} must not use ${used}: see docs/architecture/layers.txt")
    endif()
  endforeach()
endfunction()

function(hexatlas_layer layer)
  cmake_parse_arguments(ARG "" "" "HEADERS;SOURCES;USES;THIRD_PARTY" ${ARGN})
  hexatlas_check_uses(${layer} ${ARG_USES})
  string(REPLACE "/" "_" target ${layer})
  list(TRANSFORM ARG_USES REPLACE "/" "_")
  list(TRANSFORM ARG_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/${layer}/)
  list(TRANSFORM ARG_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/${layer}/)
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    set(door_scope PRIVATE)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
    set(door_scope INTERFACE)
  endif()
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS})
  target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${ARG_USES} ${door_scope} ${ARG_THIRD_PARTY})
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()
