hexatlas_test(tables_sheet_contact_sheet_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/contact_sheet_test.cpp
  USES tables_sheet)
hexatlas_test(tables_sheet_distribution_chart_test fast
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/distribution_chart_test.cpp
  USES tables_sheet)
