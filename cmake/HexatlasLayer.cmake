# hexatlas_layer(enum/flips HEADERS ... [SOURCES ... [APART ...]] [USES enum/core ...] [THIRD_PARTY ...])
#
# One target per layer, named after its folder (enum/flips -> enum_flips). USES is
# the link line and must be a subset of the layer's row in layers.txt, so that the
# file a person reads and the build cannot disagree. Headers of a layer compile
# alone: those with a source of the same name are its first include (check_layers.py),
# the others are verified by the target all_verify_interface_header_sets.
# Sources share translation units (HEXATLAS_UNITY), sixteen in each. APART: those whose unnamed
# namespace has a name of another's; they share units with each other. Where two of them collide,
# "|" begins another unit: APART a.cpp b.cpp | c.cpp.

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

# hexatlas_share_units(TARGET APART ...): the units of the sources that the target has by now. APART as
# above, with the names by which they were added. What is alone in its unit is compiled as it is.
function(hexatlas_share_units target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "APART")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${HEXATLAS_UNITY} UNITY_BUILD_MODE GROUP
    UNITY_BUILD_CODE_BEFORE_INCLUDE "// NOLINTNEXTLINE(bugprone-suspicious-include)")
  get_target_property(rest ${target} SOURCES)
  list(REMOVE_ITEM rest ${ARG_APART} "")
  set(unit)
  set(number 0)
  foreach(source ${rest} | ${ARG_APART} |)
    list(LENGTH unit members)
    if(source STREQUAL "|" OR members EQUAL 16)
      if(members GREATER 1)
        set_source_files_properties(${unit} PROPERTIES UNITY_GROUP ${number})
      endif()
      math(EXPR number "${number} + 1")
      set(unit)
    endif()
    if(NOT source STREQUAL "|")
      list(APPEND unit ${source})
    endif()
  endforeach()
endfunction()

# hexatlas_read_headers_once(TARGET): the standard library, in builds that are for tests alone and where it
# helps (clang: a quarter of the time). The others show that each file includes what it names.
function(hexatlas_read_headers_once target)
  get_target_property(used ${target} LINK_LIBRARIES)
  if(NOT HEXATLAS_SANITIZE OR NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang"
      OR used MATCHES "OpenMP::OpenMP_CXX")  # with it the language is another
    return()
  endif()
  if(NOT TARGET standard_headers)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/standard_headers.cpp CONTENT "" @ONLY)
    add_library(standard_headers OBJECT ${PROJECT_BINARY_DIR}/standard_headers.cpp)
    target_precompile_headers(standard_headers PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem>
      <fstream> <functional> <map> <memory> <numeric> <optional> <set> <span> <sstream> <string> <string_view>
      <thread> <unordered_map> <utility> <variant> <vector>)
  endif()
  target_precompile_headers(${target} REUSE_FROM standard_headers)
endfunction()

function(hexatlas_layer layer)
  cmake_parse_arguments(ARG "" "" "HEADERS;SOURCES;APART;USES;THIRD_PARTY" ${ARGN})
  hexatlas_check_uses(${layer} ${ARG_USES})
  string(REPLACE "/" "_" target ${layer})
  list(TRANSFORM ARG_USES REPLACE "/" "_")
  list(TRANSFORM ARG_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/${layer}/)
  list(TRANSFORM ARG_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/${layer}/)
  list(TRANSFORM ARG_APART PREPEND ${PROJECT_SOURCE_DIR}/${layer}/ REGEX "[.]cpp$")
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    hexatlas_share_units(${target} APART ${ARG_APART})
    set(scope PUBLIC)
    set(door_scope PRIVATE)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
    set(door_scope INTERFACE)
  endif()
  set(with_source ${ARG_SOURCES})
  list(TRANSFORM with_source REPLACE "[.]cpp$" ".hpp")
  set(without_source ${ARG_HEADERS})
  list(REMOVE_ITEM without_source ${with_source} "")
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS}
    FILE_SET without_source TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${without_source})
  target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${ARG_USES} ${door_scope} ${ARG_THIRD_PARTY})
  if(ARG_SOURCES)
    hexatlas_read_headers_once(${target})
  endif()
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON
    INTERFACE_HEADER_SETS_TO_VERIFY without_source)
endfunction()
