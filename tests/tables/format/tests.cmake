hexatlas_test(tables_format_record_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/record_test.cpp
  USES tables_format enum_flips enum_canon_nauty)
hexatlas_test(tables_format_table_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/table_test.cpp
  USES tables_format tables_check enum_flips enum_canon_nauty)
hexatlas_test(tables_format_catalogue_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/catalogue_test.cpp
  USES tables_format)
target_compile_definitions(tables_format_catalogue_test PRIVATE
  HEXATLAS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
hexatlas_test(tables_format_sectors_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/sectors_test.cpp
  USES tables_format)
target_compile_definitions(tables_format_sectors_test PRIVATE
  HEXATLAS_SECTORS="${PROJECT_SOURCE_DIR}/tables/data/linear-bound.hxs"
  HEXATLAS_SCARRED_SECTOR="${CMAKE_CURRENT_LIST_DIR}/../check/scarred.hxs")
