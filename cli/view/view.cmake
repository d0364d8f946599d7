# The page of `hexatlas view`, bundled at build time from the scripts here and three.js into one C++ source.
if(NOT HEXATLAS_VIEW)
  target_sources(hexatlas PRIVATE cli/view_no_page.cpp)
  return()
endif()

find_program(HEXATLAS_NODE NAMES node nodejs)
find_program(HEXATLAS_NPM npm)
if(NOT HEXATLAS_NODE OR NOT HEXATLAS_NPM)
  message(FATAL_ERROR "The page of `hexatlas view` is bundled by Node.js 18 or later with npm, which are not there.\n"
    "Install them (Debian: apt-get install nodejs npm), or build without the page: -DHEXATLAS_VIEW=OFF")
endif()

set(view_source ${PROJECT_SOURCE_DIR}/cli/view)
set(view_build ${PROJECT_BINARY_DIR}/view)
set(view_modules ${view_build}/node_modules)
file(GLOB view_scripts CONFIGURE_DEPENDS ${view_source}/*.js)

# npm checks what it downloads against the sums in package-lock.json and runs no script of a package.
add_custom_command(OUTPUT ${view_build}/modules.stamp
  COMMAND ${CMAKE_COMMAND} -E copy ${view_source}/package.json ${view_source}/package-lock.json ${view_build}
  COMMAND ${HEXATLAS_NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error
  COMMAND ${CMAKE_COMMAND} -E touch ${view_build}/modules.stamp
  DEPENDS ${view_source}/package.json ${view_source}/package-lock.json
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/view
  COMMENT "Fetching three.js and esbuild" VERBATIM)
add_custom_command(OUTPUT ${view_build}/view_page_parts.cpp
  COMMAND ${HEXATLAS_NODE} ${view_source}/build_page.mjs ${view_modules} ${view_build}/view_page_parts.cpp
  DEPENDS ${view_build}/modules.stamp ${view_source}/build_page.mjs ${view_source}/page.html ${view_source}/page.css
    ${view_scripts}
  COMMENT "Bundling the page of `hexatlas view`" VERBATIM)
file(MAKE_DIRECTORY ${view_build})
target_sources(hexatlas PRIVATE ${view_build}/view_page_parts.cpp)
